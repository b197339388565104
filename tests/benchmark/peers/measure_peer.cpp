#include "tests/benchmark/peers/measure_peer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/model/system.h"
#include "core/time/simulation.h"
#include "tests/benchmark/bench/clock.h"
#include "tests/benchmark/peers/deepest_overlap.h"

namespace wuerfel::bench {

namespace {

constexpr double collapsed = 0.5;      // m: somebody is that far from its place
constexpr double overhang_time = 5.0;  // s

void run_for_figures(const Peer::Maker& make, const BenchScene& scene, double step, BenchRow& row) {
  const auto world = make();
  const long every =
      std::max(1L, std::lround(1.0 / (60.0 * step)));  // overlap at 60 looks a second
  double overlap = 0.0;
  for (long k = 1; k <= row.steps; ++k) {
    world->step();
    if (k % every == 0) overlap = std::max(overlap, deepest_overlap(scene.scene, world->states()));
  }
  row.overlap = overlap;
  const State end = world->states();
  if (scene.exact.empty()) return;
  row.state_error = state_error(scene.scene, end, scene.exact);
  row.place_error = place_error(scene.scene, end, scene.exact);
  const System system = make_system(scene.scene);
  row.energy_drift = energy(system, end) - energy(system, scene.exact);
  if (!scene.rests) return;
  for (std::size_t i = 0; i < end.size(); ++i)
    if (!((end[i].position - scene.exact[i].position).norm() <= collapsed))
      row.status = "collapsed";
}

bool stands(const Scene& scene, const BodyState& top) {
  const SceneCube& start = scene.cubes.back();
  return (top.position - start.position).cwiseAbs().maxCoeff() < 0.05
         && std::abs(top.angle - start.angle) < 0.05;
}

}  // namespace

BenchRow measure_peer(const Peer& peer, const BenchScene& scene, double step, double budget) {
  BenchRow row;
  row.scene = scene.name;
  row.bodies = scene.scene.cubes.size();
  row.engine = peer.engine;
  row.method = peer.method;
  row.simulated = scene.scene.duration;
  // The last step ends exactly at the end of the scene.
  row.steps = std::max(1L, std::lround(scene.scene.duration / step));
  row.step = scene.scene.duration / static_cast<double>(row.steps);
  try {
    const Peer::Maker make = peer.prepare(scene.scene, *row.step);
    run_for_figures(make, scene, *row.step, row);
    const BestTime whole = best_time(budget, [&] {
      const auto world = make();
      for (long k = 0; k < row.steps; ++k)
        world->step();
    });
    row.cpu = whole.seconds;
    row.repeats = whole.repeats;
    row.cpu_setup = best_time(0.2 * budget, [&] { make(); }).seconds;
  } catch (const std::runtime_error& error) {
    row.status = error.what();
  }
  return row;
}

bool overhang_stands(const Peer& peer, double scale, double step) {
  const Scene scene = harmonic_overhang(scale);
  const auto world = peer.prepare(scene, step)();
  const long steps = std::lround(overhang_time / step);
  for (long k = 0; k < steps; ++k)
    world->step();
  return stands(scene, world->states().back());
}

bool overhang_stands(double scale) {
  const Scene scene = harmonic_overhang(scale);
  Simulation simulation(scene, {});
  simulation.advance_to(overhang_time);
  return stands(scene, simulation.states().back());
}

}  // namespace wuerfel::bench
