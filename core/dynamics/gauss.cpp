#include "core/dynamics/gauss.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {

IslandSolution IslandDynamics::solve(const State& state, const Island& island) {
  solver_->solve(builder_.program(), result_);
  IslandSolution solution;
  solution.status = result_.status;
  solution.residual = result_.residual.worst();
  solution.forces.assign(island.contacts.size(), 0.0);
  if (static_cast<int>(result_.x.size()) != builder_.program().unknowns()) {
    // Without an answer nothing is pushed: the caller sees the status.
    const QuadraticProgram& program = builder_.program();
    solution.twists = builder_.twists(state, island, program.target);
    return solution;
  }
  solution.twists = builder_.twists(state, island, result_.x);
  auto row = static_cast<std::size_t>(builder_.first_contact_row());
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (use_[k] != SideUse::none) solution.forces[k] = result_.multiplier[row++];
  }
  return solution;
}

IslandSolution IslandDynamics::accelerations(const State& state, const Island& island) {
  use_.clear();
  for (const Contact& contact : island.contacts) {
    const bool active = contact_motion(*system_, state, contact) != ContactMotion::opening;
    use_.push_back(active ? SideUse::inequality : SideUse::none);
  }
  builder_.acceleration(state, island, use_);
  return solve(state, island);
}

IslandSolution IslandDynamics::impact(const State& state, const Island& island) {
  use_.assign(island.contacts.size(), SideUse::inequality);
  builder_.velocity(state, island, use_);
  return solve(state, island);
}

IslandSolution IslandDynamics::tangential_velocities(const State& state, const Island& island) {
  use_.assign(island.contacts.size(), SideUse::equality);
  builder_.velocity(state, island, use_);
  return solve(state, island);
}

IslandSolution IslandDynamics::correction(const State& state,
                                          const Island& island,
                                          std::span<const SideUse> use) {
  use_.assign(use.begin(), use.end());
  builder_.position(state, island, use_);
  return solve(state, island);
}

double largest_acceleration(const System& system,
                            const Island& island,
                            const std::vector<Twist>& twists) {
  double largest = 0.0;
  for (std::size_t k = 0; k < twists.size(); ++k) {
    const double side = system.body(island.cubes[k]).size.minCoeff();
    largest = std::max(largest, twists[k].linear.norm() + side * std::abs(twists[k].angular));
  }
  return largest;
}

}  // namespace wuerfel
