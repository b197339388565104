#include "app/cli/pace.h"

#include <algorithm>

#include <fmt/format.h>

namespace wuerfel {

namespace {

constexpr double most_steps_left = 1e9;
constexpr long least_steps_per_look = 100'000;
/// A motion gets on when all of its groups have taken a thousand steps, at the latest; some begin anew when they meet.
constexpr long steps_of_body = 10'000;

bool is_controlled(Integrator integrator) {
  return integrator == Integrator::automatic || integrator == Integrator::event
         || integrator == Integrator::rattle;
}

}  // namespace

Pace::Pace(double end, std::size_t bodies, Integrator integrator)
    : end_(end),
      judged_(is_controlled(integrator)),
      steps_per_look_(least_steps_per_look + steps_of_body * static_cast<long>(bodies)) {}

void Pace::beat(double reached) {
  if (!judged_ || ++steps_ < steps_per_look_) return;
  const double left = (end_ - reached) * static_cast<double>(steps_);
  if (left > most_steps_left * (reached - last_)) {
    throw EndlessMotion(fmt::format(
        "stopped at {:.4g} s: with steps of {:.1g} s the way to {:.4g} s takes more than {:.0g} "
        "of them, as many as the fastest body passes parts of the smallest side; less speed or "
        "spin, larger sides, a longer --step where one was chosen, or less time help",
        reached, (reached - last_) / static_cast<double>(steps_), end_, most_steps_left));
  }
  steps_ = 0;
  last_ = reached;
}

void watch_steps(Simulation& simulation,
                 const Scene& scene,
                 Integrator integrator,
                 double end,
                 const StopSignal& stop,
                 Progress* progress) {
  Pace pace(end, scene.cubes.size() + scene.points.size(), integrator);
  simulation.set_pulse([&simulation, &stop, progress, end, pace]() mutable {
    stop.check();
    pace.beat(simulation.reached());
    if (progress != nullptr) progress->reached(std::min(end, simulation.reached()));
  });
}

}  // namespace wuerfel
