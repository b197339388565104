#include "core/dynamics/momentum_balance.h"

#include <algorithm>

#include "core/dynamics/momentum.h"
#include "core/dynamics/rod_rows.h"

namespace wuerfel {
namespace {

/// m, from the common centre to a body's, or its radius, if that is larger. A point alone is its own centre but for rounding.
double arm_about(const Vec2& center, const Vec2& position, const Body& body) {
  constexpr double rounding = 1e-15;
  const double distance = (position - center).norm();
  return std::max(distance > rounding * center.norm() ? distance : 0.0, body.radius());
}

}  // namespace

Vec2 common_center(const System& system, const State& state, std::span<const char> resting) {
  return momentum_of_moving(system, state, resting).center;
}

void add_push(const System& system,
              const State& state,
              const Vec2& center,
              const Contact& contact,
              const Vec2& impulse,
              Push& sum) {
  const bool corner = system.is_cube(contact.on);
  if (corner == system.is_cube(contact.from)) return;
  const int cube = corner ? contact.on : contact.from;
  const Vec2 arm = corner ? contact.arm_k : arm_of_side(contact);
  const Vec2 p = corner ? impulse : Vec2(-impulse);
  sum += {p, det(state[cube].position - center + arm, p)};
}

void add_push(const State& place, const Vec2& center, const Rod& rod, double impulse, Push& sum) {
  const bool first = rod.i.body >= 0;
  if (first == (rod.j.body >= 0)) return;
  const RodEnd& end = first ? rod.i : rod.j;
  const Vec2 p = (first ? impulse : -impulse) * rod_direction(rod, place);
  sum += {p, det(place[end.body].position - center + held_place(end, place).arm, p)};
}

Push push_of(const System& system,
             const State& state,
             const Island& island,
             const IslandSolution& solution) {
  const Vec2 center = common_center(system, state);
  Push sum;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    add_push(system, state, center, c, impulse_at(c, solution, k), sum);
  }
  for (std::size_t k = 0; k < solution.rods.size(); ++k)
    add_push(state, center, system.rods[island.rods[k]], solution.rods[k], sum);
  return sum;
}

Push unexplained(const System& system,
                 const State& before,
                 const State& after,
                 double dt,
                 const Push& pushes,
                 std::span<const char> resting) {
  const Momentum from = momentum_of_moving(system, before, resting);
  const Momentum to = momentum_of_moving(system, after, resting);
  const Vec2 weight = dt * from.mass * system.gravity;
  return {to.linear - from.linear - weight - pushes.linear,
          to.angular - from.angular - pushes.angular};
}

void MomentumScale::include(const MomentumScale& other) {
  linear = std::max(linear, other.linear);
  angular = std::max(angular, other.angular);
}

MomentumScale momentum_scale(const System& system, const State& state, double speed) {
  const Vec2 center = common_center(system, state);
  MomentumScale scale;
  for (int i = 0; i < system.cubes; ++i) {
    const Body& body = system.body(i);
    const double p = body.mass * std::max(fastest_corner(body, state[i]), speed);
    scale.linear += p;
    scale.angular += p * arm_about(center, state[i].position, body);
  }
  return scale;
}

}  // namespace wuerfel
