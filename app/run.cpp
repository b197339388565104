#include <utility>

#include <nlohmann/json.hpp>

#include "app/accuracy.h"
#include "app/advance.h"
#include "app/commands.h"
#include "app/film.h"
#include "app/run_plan.h"
#include "app/summary.h"
#include "app/tables.h"

namespace wuerfel {

ExitCode run(const RunOptions& options) {
  const Scene scene = read_scene(options.scene);
  const RunPlan plan = make_plan(options, scene);
  Simulation simulation(scene, options.motion);

  // What cannot be written is noticed before the long work.
  const StopSignal stop;
  AnimationSettings animation = animation_settings(options.picture, options.rate.fps, scene);
  animation.while_waiting = [&stop] { stop.check(); };
  PictureOutputs pictures(options.outputs, animation);
  Tables tables(options.states, options.forces, options.events);
  Summary summary(options.summary, options.json);

  // Simulate from one instant that somebody wants to see to the next.
  RunCost cost{.start_s = options.since_start.cpu_before() + options.since_start.wall()};
  const Stopwatch watch;
  Film film(options, scene, pictures);
  std::vector<Sample> samples;
  Progress progress(Progress::style_for_stderr(options.quiet), "simulating", plan.end, "s");
  for (const Instant& instant : plan.instants) {
    advance(simulation, instant.t, options.motion.step, stop, progress);
    if (instant.sample) samples.push_back({instant.t, simulation.states()});
    if (!instant.frame) continue;
    Snapshot snapshot = simulation.snapshot(plan.request);
    tables.add_states(instant.t, scene, simulation.states());
    tables.add_forces(snapshot);
    if (!pictures.empty()) film.add(std::move(snapshot));
  }
  progress.end();

  film.finish(stop);
  tables.finish(simulation.events());
  cost.frames = film.frames();
  cost.frames_reused = film.reused();
  cost.wall_s = watch.wall();
  cost.cpu_s = watch.cpu();
  summary.write(run_summary(scene, options.motion, simulation, samples, cost));
  return verdict_on_accuracy(simulation.audit());
}

}  // namespace wuerfel
