#include "tests/benchmark/bench/measure.h"

#include <cmath>
#include <stdexcept>

#include <fmt/core.h>

#include "core/time/simulation.h"
#include "tests/benchmark/bench/clock.h"

namespace wuerfel {

namespace {

constexpr double longest_run = 3.0;  // s of processor time

// How far the nearest event of that kind is from its known time.
std::optional<double> event_error(const BenchScene& scene, const MotionSettings& settings) {
  if (!scene.event) return std::nullopt;
  Simulation simulation(scene.scene, settings);
  simulation.advance_to(scene.event->look_until);
  std::optional<double> nearest;
  for (const Event& event : simulation.events()) {
    const double off = std::abs(event.t - scene.event->time);
    if (event.kind == scene.event->kind && (!nearest || off < *nearest)) nearest = off;
  }
  return nearest;
}

std::string status_text(const Audit& audit) {
  if (audit.missed_solves > 0)
    return fmt::format("{} programs missed their residual", audit.missed_solves);
  if (audit.unresolved > 0) return fmt::format("{} times unresolved", audit.unresolved);
  return "ok";
}

// Small motions go to their end in one go. What stands, or is a pile, is looked at on the way, so
// that a method that finds no rest does not hold up the others: false where it took too long.
bool advance(Simulation& simulation, const BenchScene& scene) {
  const int parts = scene.rests || scene.exact.empty() ? 100 : 1;
  const double start = processor_seconds();
  for (int k = 1; k <= parts; ++k) {
    simulation.advance_to(scene.scene.duration * k / parts);
    if (processor_seconds() - start > longest_run && k < parts) return false;
  }
  return true;
}

// False where it took too long.
bool run_for_figures(const BenchScene& scene, const MotionSettings& settings, BenchRow& row) {
  Simulation simulation(scene.scene, settings);
  const double start = processor_seconds();
  const bool arrived = advance(simulation, scene);
  const Audit audit = simulation.audit();
  const Cost& cost = simulation.cost();
  if (arrived && !scene.exact.empty()) {
    row.state_error = state_error(scene.scene, simulation.states(), scene.exact);
    row.place_error = place_error(scene.scene, simulation.states(), scene.exact);
  }
  row.overlap = audit.max_penetration;
  row.energy_drift = audit.drift();
  row.residual = audit.max_kkt_residual;
  row.steps = cost.steps;
  row.solves = cost.qp_solves;
  row.skips = cost.qp_skipped();
  row.status = status_text(audit);
  if (!arrived) {
    row.status = fmt::format("at t = {:.3g} s after {:.3g} s of work", simulation.time(),
                             processor_seconds() - start);
  }
  return arrived;
}

}  // namespace

BenchRow measure(const BenchScene& scene, const MotionSettings& settings, double budget) {
  BenchRow row;
  row.scene = scene.name;
  row.bodies = scene.scene.cubes.size();
  row.engine = "wuerfel";
  row.method = to_string(BenchMethod{settings.integrator, settings.formulation, settings.solver});
  if (has_tolerance(settings.integrator)) {
    row.tolerance = settings.tolerance;
  } else {
    row.step = settings.step;
  }
  row.simulated = scene.scene.duration;
  try {
    if (!run_for_figures(scene, settings, row)) return row;
    row.event_error = event_error(scene, settings);
    const BestTime whole = best_time(budget, [&] {
      Simulation simulation(scene.scene, settings);
      simulation.advance_to(scene.scene.duration);
    });
    row.cpu = whole.seconds;
    row.repeats = whole.repeats;
    row.cpu_setup = best_time(0.2 * budget, [&] {
                      const Simulation simulation(scene.scene, settings);
                    }).seconds;
    run_for_figures(scene, settings, row);
    row.event_error = event_error(scene, settings);
  } catch (const std::runtime_error& error) {
    row.status = error.what();
  }
  return row;
}

}  // namespace wuerfel
