#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/argument.h"
#include "app/cli/memory_limit.h"
#include "app/cli/option_groups.h"
#include "app/cli/pace.h"
#include "app/cli/progress.h"
#include "app/commands/batch.h"
#include "app/commands/commands.h"
#include "app/commands/estimate.h"
#include "app/commands/idle_options.h"
#include "app/commands/letters.h"
#include "app/commands/run_books.h"
#include "app/output/program_file.h"
#include "core/dynamics/missed_programs.h"
#include "core/time/restart_point.h"

namespace wuerfel {

namespace {

void note_idle_options(const RunOptions& asked, const Options& options, Notes& notes) {
  require_effect(options, asked.motion);
  if (asked.checkpoint.empty()) note_idle(options, {"--every"}, "without --checkpoint", notes);
  if (!asked.json && asked.summary.empty())
    note_idle(options, {"--sample"}, "without --json or --summary", notes);
  if (asked.outputs.empty()) {
    note_idle(options,
              {"--size", "--layers", "--theme", "--view", "--zoom", "--scale", "--force-scale",
               "--velocity-scale", "--acceleration-scale", "--rod-scale", "--color", "--color-top",
               "--explode", "--legend", "--average", "--encoder", "--rasteriser", "--hold"},
              "without -o", notes);
    if (!asked.tables())
      note_idle(options, {"--fps", "--speed"}, "without -o, --states or --forces", notes);
    return;
  }
  note_idle_picture_options(options, asked.picture.layers, notes);
  note_film_differences(asked.outputs, asked.picture, options.given("--encoder"), notes);
}

// A GIF counts hundredths of a second: 50 frames are the most that all programs show.
RunOptions with_rate_of_gif(const RunOptions& asked, const Options& options, Notes& notes) {
  constexpr double most = 50.0;
  RunOptions suited = asked;
  const auto is_gif = [](const std::string& name) { return has_suffix(name, ".gif"); };
  if (options.given("--fps") || std::ranges::none_of(asked.outputs, is_gif)) return suited;
  suited.rate.fps = most;
  notes.add("a GIF shows at most 50 frames per second: all films have 50");
  return suited;
}

/// What a run starts from.
struct Job {
  const RunOptions& asked;
  const Scene& scene;
  RunPlan plan;
  Stopwatch since_start;
  std::vector<TimetableEntry> instants{};
};

/// Where the simulation begins: at the start, or where a checkpoint stopped it.
Simulation begin(const Job& job, const Checkpoint& resumed) try {
  if (resumed.restart_point.empty()) return {job.scene, job.asked.motion};
  return {job.scene, job.asked.motion, resumed.restart_point};
} catch (const RestartError& error) {
  throw UsageError(fmt::format("--resume: {} is damaged: {}", job.asked.resume, error.what()));
}

/// What was seen before a checkpoint is seen again; returns up to where, as an instant's number.
std::size_t repeat(const Job& job,
                   const std::vector<Moment>& moments,
                   const Simulation& simulation,
                   RunBooks& books) {
  std::size_t k = 0;
  std::size_t next = 0;
  const auto& instants = job.instants;
  for (; k < instants.size() && instants[k].t < simulation.time(); ++k) {
    if (!is_seen(instants[k])) continue;
    if (next == moments.size() || moments[next].t != instants[k].t) break;
    books.take(instants[k], simulation, moments[next++]);
  }
  const bool all =
      next == moments.size() && (k == instants.size() || instants[k].t >= simulation.time());
  if (!all) {
    throw UsageError(
        fmt::format("--resume: {} was made at other times; --until, --fps, --speed and --sample "
                    "have to be those "
                    "of the run that it belongs to",
                    job.asked.resume));
  }
  return k;
}

/// Simulates from one instant that somebody wants to see to the next.
void simulate(const Job& job,
              std::size_t first,
              Simulation& simulation,
              RunBooks& books,
              CheckpointKeeper& keeper,
              AccuracyWatch& accuracy,
              Progress& progress) {
  const bool strict = job.asked.strict;
  double due = job.asked.every.value_or(job.plan.end / 10.0);
  const double every = due;
  for (std::size_t k = first; k < job.instants.size(); ++k) {
    const TimetableEntry& instant = job.instants[k];
    simulation.advance_to(instant.t);
    progress.reached(instant.t);
    if (is_seen(instant)) {
      const Moment moment = simulation.moment();
      books.take(instant, simulation, moment);
      keeper.add(moment);
    }
    if (instant.frame || instant.sample || strict) accuracy.look(simulation, books.worst_force());
    if (strict && accuracy.first()) break;
    if (instant.t < due) continue;
    keeper.write(accuracy);
    due = instant.t + every;
  }
  accuracy.look(simulation, books.worst_force());
}

void say_work(const Job& job, AnswerForm form) {
  const std::string work = estimate(job.asked, job.scene, job.instants);
  if (!work.empty() && !job.asked.quiet && !form.one_line) say(fmt::format("wuerfel: {}\n", work));
}

void note_labels(const RunBooks& books, Notes& notes) {
  const int labels = books.labels_left_out();
  if (labels > 0) notes.add("up to " + left_out(labels, "label of a frame", "labels of a frame"));
}

Answer run(Job job, AnswerForm form, Notes& notes) {
  const auto& [asked, scene, plan, since_start, instants] = job;
  // Where there are several scenes nothing is written that a signal could tear.
  const StopSignal stop(form.one_line ? StopSignal::Ear::deaf : StopSignal::Ear::open);
  const std::string origin = checkpoint_origin(scene, asked.motion);
  Checkpoint resumed;
  if (!asked.resume.empty()) resumed = read_checkpoint(asked.resume, origin);
  std::optional<ProgramFile> failed;
  if (!asked.failed_programs.empty()) failed.emplace(asked.failed_programs);
  const MissedProgramListener listener([&failed](const FrictionProgram& program) {
    if (failed) failed->add(program);
  });
  Simulation simulation = begin(job, resumed);

  AnimationSettings animation = animation_settings(asked.picture, asked.rate.fps, scene);
  animation.while_waiting = [&stop] { stop.check(); };
  RunOutputs outputs(asked, animation);
  SummaryFile summary_file(asked.summary);
  job.instants = instants_of(asked, plan);
  const MotionSource source{scene,        asked.motion, instants, plan.request,
                            plan.request, plan.back,    stop};
  RunBooks books(asked, source, outputs);
  say_work(job, form);
  RunCost cost{.start_s = since_start.cpu_before() + since_start.wall()};
  const Stopwatch watch(form.one_line ? Stopwatch::Of::thread : Stopwatch::Of::process);
  const auto style = Progress::style_for_stderr(asked.quiet || form.one_line);
  Progress progress(style, "simulating", plan.end, "s");
  watch_steps(simulation, scene, asked.motion.integrator, plan.end, stop, &progress);
  AccuracyWatch accuracy(resumed.first_violation);
  const std::size_t first = repeat(job, resumed.moments, simulation, books);
  CheckpointKeeper keeper(asked, origin, std::move(resumed));
  keeper.listen(simulation);
  try {
    simulate(job, first, simulation, books, keeper, accuracy, progress);
    progress.end();
    books.finish(simulation, style);
    if (failed) failed->finish();
  } catch (const Interrupted&) {
    keeper.write(accuracy);
    throw;
  } catch (const MemoryExceeded&) {
    keeper.write(accuracy);
    throw;
  } catch (const EndlessMotion&) {
    keeper.write(accuracy);
    throw;
  }
  cost.frames = books.frames();
  cost.frames_reused = books.reused();
  note_labels(books, notes);
  cost.wall_s = watch.wall();
  cost.cpu_s = watch.cpu();
  const ExitCode code = accuracy.verdict(notes);
  auto summary = run_summary(scene, asked.motion, simulation, books.samples(), notes, cost);
  if (accuracy.first()) summary["audit"]["first_violation"] = violation_json(*accuracy.first());
  if (!asked.forces.empty()) summary["forces"] = {{"max_kkt_residual", books.worst_force()}};
  summary_file.write(json_text(summary, {}));
  return {code, form.json ? json_text(summary, form) : ""};
}

void require_no_files(const RunOptions& asked) {
  if (!asked.files().empty())
    throw UsageError("files are written for one scene at a time; for several there is --json");
}

Answer answer(const RunOptions& asked,
              const Options& options,
              const Stopwatch& since_start,
              const SceneText& text,
              AnswerForm form,
              Notes& notes) {
  if (form.one_line) require_no_files(asked);
  note_idle_options(asked, options, notes);
  if (!form.one_line) note_idle(options, {"--threads"}, "for one scene", notes);
  const Scene scene = parse(text, asked.overrides);
  note_what_is_left_out(options, scene, asked.motion.integrator, notes);
  if (!asked.outputs.empty() && asked.picture.size.height == 0)
    throw UsageError("--size: the height of films and frames has to be told, as 1280x720");
  RunOptions suited = with_rate_of_gif(asked, options, notes);
  suited.picture.layers = drawn_layers(asked.picture, options.given("--layers"));
  if (!asked.outputs.empty()) {
    note_letters(scene, asked.picture.layers, notes);
    note_crowd(scene, asked.picture.layers, notes);
    note_idle_colors(options, color_by(asked.picture, scene.cubes.size()), notes);
    // Small frames have neither by themselves.
    if (options.given("--scale")) note_hud(suited.picture, suited.picture.size, notes);
  }
  return run({suited, scene, make_plan(suited, scene), since_start}, form, notes);
}

void declare_outputs(Options& options, RunOptions& asked) {
  options.value("-o,--output", "DIR/|FILE",
                "folder of frames, or a film: .mp4 .webm .gif .apng (repeatable)",
                [&asked](const std::string& text) {
                  require_picture_output(text);
                  asked.outputs.push_back(text);
                });
  add_rate_options(options, asked.rate);
  options.single("--hold", "S",
                 "how long films show their last frame, in s [1 for .gif and .apng, else 0]",
                 [&asked](const std::string& text) { asked.hold = parse_time("--hold", text); });
  options.single("--until", "T", "end in s [the scene's duration]",
                 [&asked](const std::string& text) { asked.until = parse_time("--until", text); });
  options.value("--sample", "T1,T2,..",
                "report the state at these times, each once and in their order",
                [&asked](const std::string& text) {
                  for (const std::string& time : split_list(text))
                    asked.samples.push_back(parse_time("--sample", time));
                });
  options.text("--states", "FILE", "positions and velocities at the frame times as CSV",
               asked.states);
  options.text("--forces", "FILE", "contact forces at the frame times as CSV", asked.forces);
  options.text("--events", "FILE", "events as JSON lines", asked.events);
  options.text("--summary", "FILE", "the summary as JSON", asked.summary);
  options.text("--failed-programs", "FILE",
               "programs that missed their tolerance, for `wuerfel replay`", asked.failed_programs);
  options.text("--checkpoint", "FILE", "keep here what the run can be taken up again from",
               asked.checkpoint);
  options.single(
      "--every", "S", "simulated time from one checkpoint to the next in s [a tenth of the run]",
      [&asked](const std::string& text) { asked.every = parse_positive("--every", text); });
  options.text("--resume", "FILE", "go on from such a checkpoint, with the same scene and options",
               asked.resume);
  options.flag("--strict", "stop where the error budget is exceeded first", asked.strict);
  options.flag("--json", "print the summary as JSON", asked.json);
  options.flag("--quiet", "no progress and no notes", asked.quiet);
  add_threads_option(options, asked.threads);
  add_memory_option(options);
}

}  // namespace

Action declare_run(Options& options) {
  auto asked = std::make_shared<RunOptions>();
  add_scenes(options, asked->scenes, asked->overrides);
  declare_outputs(options, *asked);
  add_picture_options(options, asked->picture);
  add_encoder_option(options, asked->picture.encoder);
  add_motion_options(options, asked->motion);
  return [asked, &options](const Stopwatch& since_start) {
    require_distinct_outputs(*asked);
    if (asked->scenes.size() > 1) require_no_files(*asked);
    return for_each_scene({asked->scenes, asked->json, asked->quiet, asked->threads},
                          [&](const SceneText& text, AnswerForm form, Notes& notes) {
                            return answer(*asked, options, since_start, text, form, notes);
                          });
  };
}

}  // namespace wuerfel
