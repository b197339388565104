#include <algorithm>
#include <memory>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cli/argument.h"
#include "app/cli/option_groups.h"
#include "app/cli/progress.h"
#include "app/commands/batch.h"
#include "app/commands/commands.h"
#include "app/commands/idle_options.h"
#include "app/commands/letters.h"
#include "app/commands/run_plan.h"
#include "app/film/film.h"
#include "app/output/accuracy.h"
#include "app/output/summary.h"
#include "app/output/tables.h"

namespace wuerfel {

namespace {

void note_idle_options(const RunOptions& asked, const Options& options, Notes& notes) {
  require_effect(options, asked.motion);
  if (asked.outputs.empty()) {
    note_idle(options,
              {"--size", "--layers", "--theme", "--view", "--zoom", "--scale", "--force-scale",
               "--velocity-scale", "--rod-scale", "--encoder"},
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
  const StopSignal& stop;
};

Answer run(const Job& job, AnswerForm form, Notes& notes) {
  const auto& [asked, scene, plan, since_start, stop] = job;
  Simulation simulation(scene, asked.motion);
  simulation.set_pulse([&stop] { stop.check(); });

  // What cannot be written is noticed before the long work.
  AnimationSettings animation = animation_settings(asked.picture, asked.rate.fps, scene);
  animation.while_waiting = [&stop] { stop.check(); };
  PictureOutputs pictures(asked.outputs, animation, asked.hold);
  Tables tables(asked.states, asked.forces, asked.events);
  SummaryFile summary_file(asked.summary);

  // Simulate from one instant that somebody wants to see to the next.
  RunCost cost{.start_s = since_start.cpu_before() + since_start.wall()};
  const Stopwatch watch(form.one_line ? Stopwatch::Of::thread : Stopwatch::Of::process);
  const MotionSource source{scene,        asked.motion, plan.instants, plan.request,
                            plan.request, plan.back,    stop};
  FrameTaker taker(plan.request, plan.request, plan.back);
  Film film(asked.picture, asked.rate, source, pictures);
  std::vector<Sample> samples;
  double worst_force = 0.0;  // residual
  const auto style = Progress::style_for_stderr(asked.quiet || form.one_line);
  Progress progress(style, "simulating", plan.end, "s");
  for (const Instant& instant : plan.instants) {
    stop.check();
    simulation.advance_to(instant.t);
    progress.reached(instant.t);
    if (instant.sample) samples.push_back({instant.t, simulation.states()});
    std::optional<Snapshot> snapshot = taker.take(simulation, instant);
    if (!snapshot) continue;
    tables.add_states(instant.t, scene, simulation.states());
    tables.add_forces(*snapshot);
    if (!asked.forces.empty()) worst_force = std::max(worst_force, snapshot->force_residual);
    // What only a table asked for is not seen.
    if (!asked.picture.layers.has(Layer::contact_forces)) snapshot->forces.clear();
    if (!pictures.empty()) film.add(std::move(*snapshot));
  }
  progress.end();

  film.finish(style);
  tables.finish(simulation.events());
  cost.frames = film.frames();
  cost.frames_reused = film.reused();
  cost.wall_s = watch.wall();
  cost.cpu_s = watch.cpu();
  const ExitCode code = verdict_on_accuracy(simulation.audit(), worst_force, notes);
  auto summary = run_summary(scene, asked.motion, simulation, samples, notes, cost);
  if (!asked.forces.empty()) summary["forces"] = {{"max_kkt_residual", worst_force}};
  summary_file.write(json_text(summary, {}));
  return {code, form.json ? json_text(summary, form) : ""};
}

/// What holds for all scenes of the command.
struct Errand {
  const RunOptions& asked;
  const Options& options;
  const Stopwatch& since_start;
  const StopSignal& stop;
};

Answer answer(const Errand& errand, const SceneText& text, AnswerForm form, Notes& notes) {
  const auto& [asked, options, since_start, stop] = errand;
  if (form.one_line && !asked.files().empty())
    throw UsageError("files are written for one scene at a time; for several there is --json");
  note_idle_options(asked, options, notes);
  const Scene scene = parse(text, asked.overrides);
  note_what_is_left_out(options, scene, asked.motion.integrator, notes);
  if (!asked.outputs.empty() && asked.picture.size.height == 0)
    throw UsageError("--size: the height of films and frames has to be told, as 1280x720");
  const RunOptions suited = with_rate_of_gif(asked, options, notes);
  if (!asked.outputs.empty()) note_letters(scene, asked.picture.layers, notes);
  return run({suited, scene, make_plan(suited, scene), since_start, stop}, form, notes);
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
  options.flag("--json", "print the summary as JSON", asked.json);
  options.flag("--quiet", "no progress and no notes", asked.quiet);
  add_threads_option(options, asked.threads);
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
    const StopSignal stop;
    const Errand errand{*asked, options, since_start, stop};
    return for_each_scene({asked->scenes, asked->json, asked->quiet, asked->threads},
                          [&errand](const SceneText& text, AnswerForm form, Notes& notes) {
                            return answer(errand, text, form, notes);
                          });
  };
}

}  // namespace wuerfel
