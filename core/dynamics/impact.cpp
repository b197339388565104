#include "core/dynamics/impact.h"

#include <algorithm>
#include <utility>

#include "core/dynamics/rod_rows.h"

namespace wuerfel {
namespace {

Impact with_loss(const System& system,
                 const State& state,
                 const Island& island,
                 IslandSolution after) {
  Impact result{std::move(after), kinetic_energy(system, state, island)};
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    const Twist& v = result.after.twists[k];
    const BodyState moved{{}, 0.0, v.linear, v.angular};
    result.loss -= kinetic_energy(system.body(island.cubes[k]), moved);
  }
  return result;
}

}  // namespace

double kinetic_energy(const System& system, const State& state, const Island& island) {
  double sum = 0.0;
  for (const int cube : island.cubes)
    sum += kinetic_energy(system.body(cube), state[cube]);
  return sum;
}

bool closes(const System& system, const State& state, const Island& island) {
  return std::ranges::any_of(island.contacts,
                             [&](const Contact& c) {
                               return contact_motion(system, state, c) == ContactMotion::closing;
                             })
         || std::ranges::any_of(island.rods,
                                [&](int rod) { return jerks(system, state, system.rods[rod]); });
}

Impact impact(const System& system,
              const State& state,
              const Island& island,
              IslandDynamics& dynamics) {
  return with_loss(system, state, island, dynamics.impact(state, island));
}

Impact impact(const System& system,
              const State& state,
              const Island& island,
              double slow,
              IslandDynamics& dynamics,
              FrictionDynamics& friction) {
  return rubs(system, island) || bounces(system, island)
             ? with_loss(system, state, island, friction.impact(state, island, slow))
             : impact(system, state, island, dynamics);
}

Impact jam(const System& system,
           const State& state,
           const Island& island,
           FrictionDynamics& dynamics) {
  return with_loss(system, state, island, dynamics.jam(state, island));
}

}  // namespace wuerfel
