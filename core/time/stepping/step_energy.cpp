#include "core/time/stepping/step_energy.h"

#include <algorithm>

#include "core/dynamics/momentum.h"
#include "core/time/stepping/step_books.h"

namespace wuerfel {
namespace {

/// What the sway of a step takes from the energy is given back by no more than this factor on
/// velocities.
constexpr double most_given_back = 1.01;

/// What a step took beyond its losses, and velocities cannot take back, is of what landed in it, if anything did.
void lose_in_landing(double energy, std::vector<StepLoss>& losses) {
  const auto of_landing = [](const StepLoss& loss) { return !loss.friction; };
  const auto last = std::find_if(losses.rbegin(), losses.rend(), of_landing);
  if (last != losses.rend()) last->energy += energy;
}

RigidMotion kept_of(const System& system, const StepComponent& part, const State& state) {
  return kept_motion(momentum_of(system, state, part.cubes), part.held_along);
}

}  // namespace

double pay(const System& system,
           const std::vector<StepComponent>& components,
           double unpaid,
           State& state) {
  const auto take = [&](const StepComponent& part, const RigidMotion& kept) {
    if (unpaid <= 0.0) return;
    const double goal = energy_of(system, state, part.cubes) - unpaid;
    unpaid = std::max(0.0, -scale_to_energy(system, part.cubes, kept, goal, 1.0, state));
  };
  // What slides as a whole has no motion to pay with: others of the group do.
  for (const StepComponent& part : components)
    take(part, kept_of(system, part, state));
  // Fixed bodies that rub take momentum along their sides, too.
  for (const StepComponent& part : components) {
    if (system.rubs && !part.held_along.empty()) take(part, RigidMotion{});
  }
  return unpaid;
}

Rise restore_energy(
    const System& system, const Stride& stride, bool sways, StepRecord& record, State& end) {
  Rise rise;
  for (StepComponent& part : record.components) {
    const double lost = sum_of(part.losses);
    const double goal = energy_of(system, stride.start, part.cubes) - lost;
    const double missed = energy_of(system, end, part.cubes) - goal;
    rise.whole += std::max(0.0, missed);
    rise.sway += std::abs(missed);
    if (sways) continue;
    const double missing =
        scale_to_energy(system, part.cubes, kept_of(system, part, end), goal, most_given_back, end);
    const double kept_back = std::clamp(-missing, 0.0, lost);
    if (missing > 0.0) lose_in_landing(missing, part.losses);
    rise.unpaid += std::max(0.0, -missing - kept_back);
    for (StepLoss& loss : part.losses) {
      if (kept_back > 0.0) loss.energy *= 1.0 - kept_back / lost;
    }
  }
  rise.unpaid = pay(system, record.components, rise.unpaid, end);
  return rise;
}

}  // namespace wuerfel
