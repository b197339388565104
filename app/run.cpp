#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/picture.h"
#include "app/picture_outputs.h"
#include "app/progress.h"
#include "app/recording.h"
#include "app/stop_signal.h"
#include "app/summary.h"
#include "app/tables.h"
#include "app/text_output.h"
#include "app/timetable.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

// Moves on to `t` some steps at a time, so that Ctrl-C and the progress bar need not wait for the
// next frame. Looking does not change the motion.
void advance(
    Simulation& simulation, double t, double step, const StopSignal& stop, Progress& progress) {
  constexpr double patience = 1.0 / 60.0;  // s, simulated
  const double stride = std::max(1.0, std::floor(patience / step)) * step;
  for (double k = std::floor(simulation.time() / stride) + 1.0; k * stride < t; ++k) {
    stop.check();
    simulation.advance_to(k * stride);
    progress.reached(simulation.time());
  }
  stop.check();
  simulation.advance_to(t);
  progress.reached(t);
}

void draw_film(const Recording& film,
               const RunOptions& options,
               const Scene& scene,
               const StopSignal& stop,
               PictureOutputs& pictures,
               RunCost& cost) {
  Painter painter(film, options.picture);
  const std::string settings =
      fmt::format("{} {}", painter.option_text(), option_text(options.motion));
  const std::string scene_text = normalised_scene(scene);
  Progress progress(Progress::style_for_stderr(options.quiet), "drawing",
                    static_cast<double>(film.size()), "frames");
  for (std::size_t k = 0; k < film.size(); ++k) {
    stop.check();
    pictures.add(painter.draw(k), origin(film.time(k), settings, scene_text));
    progress.reached(static_cast<double>(k + 1));
  }
  stop.check();
  pictures.finish();
  cost.frames = static_cast<long>(film.size());
  cost.frames_reused = painter.reused();
}

// What the numbers on the command line must fulfil together with the scene.
void require_sense(const RunOptions& options, double end) {
  for (const double t : options.samples) {
    if (t > end)
      throw UsageError(fmt::format("--sample: {} s is after the end of the run at {} s", t, end));
  }
  constexpr double most_frames = 1e7;
  const double frames = end * options.rate.fps / options.rate.speed;
  if (frames > most_frames)
    throw UsageError(fmt::format("{:.3g} frames are more than {}", frames, most_frames));
}

// Every program was solved as well as asked for.
bool within_budget(const Simulation& simulation) { return simulation.audit().missed_solves == 0; }

AnimationSettings film_settings(const RunOptions& options, const Scene& scene) {
  std::vector<Color> bodies;
  for (const SceneCube& cube : scene.cubes) {
    if (cube.color) bodies.push_back({(*cube.color)[0], (*cube.color)[1], (*cube.color)[2]});
  }
  return {.width = options.picture.size.width,
          .height = options.picture.size.height,
          .fps = options.rate.fps,
          .transparent = options.picture.theme == Theme::transparent,
          .palette = animation_palette(make_style(options.picture.theme), bodies)};
}

SnapshotRequest what_to_look_at(const RunOptions& options) {
  SnapshotRequest request;
  if (!options.outputs.empty()) request = snapshot_request(options.picture.layers);
  request.forces |= !options.forces.empty();
  return request;
}

}  // namespace

ExitCode run(const RunOptions& options) {
  const Scene scene = read_scene(options.scene);
  const double end = options.until.value_or(scene.duration);
  require_sense(options, end);

  // Whatever can go wrong is tried before the long work.
  Simulation simulation(scene, options.motion);
  const StopSignal stop;
  PictureOutputs pictures(options.outputs, film_settings(options, scene));
  Tables tables(options.states, options.forces, options.events);
  std::optional<TextOutput> summary_file;
  if (!options.summary.empty()) summary_file.emplace(options.summary);

  // Simulate from one instant that somebody wants to see to the next.
  RunCost cost{.start_s = options.since_start.wall()};
  const Stopwatch watch;
  Recording film;
  std::vector<Sample> samples;
  const bool has_frames = !pictures.empty() || tables.per_frame();
  const std::vector<double> frames =
      has_frames ? frame_times(end, options.rate) : std::vector<double>{};
  {
    Progress progress(Progress::style_for_stderr(options.quiet), "simulating", end, "s");
    for (const Instant& instant : timetable(end, frames, options.samples)) {
      advance(simulation, instant.t, options.motion.step, stop, progress);
      if (instant.sample) samples.push_back({instant.t, simulation.states()});
      if (!instant.frame) continue;
      const Snapshot snapshot = simulation.snapshot(what_to_look_at(options));
      tables.add_states(instant.t, scene, simulation.states());
      tables.add_forces(snapshot);
      if (!pictures.empty()) film.add(snapshot);
    }
  }

  // Draw what was seen, by one view and one force scale.
  if (!film.empty()) draw_film(film, options, scene, stop, pictures, cost);
  tables.finish(simulation.events());

  cost.wall_s = watch.wall();
  cost.cpu_s = watch.cpu();
  const std::string summary =
      run_summary(scene, options.motion, simulation, samples, cost).dump(2) + "\n";
  if (summary_file) {
    summary_file->write(summary);
    summary_file->finish();
  }
  if (options.json) write_text("-", summary);
  return within_budget(simulation) ? ExitCode::fine : ExitCode::undecided;
}

}  // namespace wuerfel
