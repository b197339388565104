#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/accuracy.h"
#include "app/advance.h"
#include "app/commands.h"
#include "app/picture.h"
#include "app/picture_outputs.h"
#include "app/recording.h"
#include "app/run_plan.h"
#include "app/summary.h"
#include "app/tables.h"
#include "app/text_output.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

void draw_film(const Recording& film,
               const RunOptions& options,
               const Scene& scene,
               const StopSignal& stop,
               PictureOutputs& pictures,
               RunCost& cost) {
  Painter painter(film, options.picture);
  const std::string settings = painter.option_text() + " " + option_text(options.motion);
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

}  // namespace

ExitCode run(const RunOptions& options) {
  const Scene scene = read_scene(options.scene);
  const RunPlan plan = make_plan(options, scene);
  Simulation simulation(scene, options.motion);

  // What cannot be written is noticed before the long work.
  const StopSignal stop;
  PictureOutputs pictures(options.outputs,
                          animation_settings(options.picture, options.rate.fps, scene));
  Tables tables(options.states, options.forces, options.events);
  Summary summary(options.summary, options.json);

  // Simulate from one instant that somebody wants to see to the next.
  RunCost cost{.start_s = options.since_start.wall()};
  const Stopwatch watch;
  Recording film;
  std::vector<Sample> samples;
  Progress progress(Progress::style_for_stderr(options.quiet), "simulating", plan.end, "s");
  for (const Instant& instant : plan.instants) {
    advance(simulation, instant.t, options.motion.step, stop, progress);
    if (instant.sample) samples.push_back({instant.t, simulation.states()});
    if (!instant.frame) continue;
    const Snapshot snapshot = simulation.snapshot(plan.request);
    tables.add_states(instant.t, scene, simulation.states());
    tables.add_forces(snapshot);
    if (!pictures.empty()) film.add(snapshot);
  }
  progress.end();

  // Draw what was seen, by one view and one force scale.
  if (!film.empty()) draw_film(film, options, scene, stop, pictures, cost);

  tables.finish(simulation.events());
  cost.wall_s = watch.wall();
  cost.cpu_s = watch.cpu();
  summary.write(run_summary(scene, options.motion, simulation, samples, cost));
  return verdict_on_accuracy(simulation.audit());
}

}  // namespace wuerfel
