#include "core/dynamics/momentum.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/rod_rows.h"

namespace wuerfel {
namespace {

bool is_point(const Body& body) { return body.kind == BodyKind::point; }

/// What a body turns by in a rigid motion: points do not.
double spin_of(const Body& body, const RigidMotion& motion) {
  return is_point(body) ? 0.0 : motion.spin;
}

/// `for_each_cube(add)` calls add(cube) for every cube that counts.
template <typename Cubes>
Momentum sum_momenta(const System& system, const State& state, const Cubes& for_each_cube) {
  Momentum sum;
  for_each_cube([&](int cube) {
    const double mass = system.body(cube).mass;
    sum.mass += mass;
    sum.center += mass * state[cube].position;
    sum.linear += mass * state[cube].velocity;
  });
  if (sum.mass > 0.0) sum.center /= sum.mass;
  for_each_cube([&](int cube) {
    const Body& body = system.body(cube);
    const Vec2 r = state[cube].position - sum.center;
    sum.angular += body.mass * det(r, state[cube].velocity) + body.inertia * state[cube].spin;
    sum.inertia += body.mass * r.squaredNorm() + (is_point(body) ? 0.0 : body.inertia);
  });
  return sum;
}

/// Changes the velocities of a cube by an impulse at an arm from its centre.
void push_at(const Body& body, const Vec2& arm, const Vec2& p, BodyState& s) {
  s.velocity += p / body.mass;
  s.spin += det(arm, p) / body.inertia;
}

}  // namespace

Vec2 arm_of_side(const Contact& c) {
  return c.alpha * c.arm_j + (1.0 - c.alpha) * c.arm_i + c.gap * c.normal;
}

Vec2 relative_velocity(const System& system, const State& state, const Contact& c) {
  Vec2 v = Vec2::Zero();
  if (system.is_cube(c.on)) v += point_velocity(state[c.on], c.arm_k);
  if (system.is_cube(c.from)) v -= point_velocity(state[c.from], arm_of_side(c));
  return v;
}

void turn(const System& system, std::span<const int> cubes, const RigidMotion& more, State& state) {
  for (const int cube : cubes) {
    state[cube].velocity += more.at(state[cube].position);
    state[cube].spin += spin_of(system.body(cube), more);
  }
}

void push(const System& system, const Contact& c, const Vec2& impulse, State& state) {
  if (system.is_cube(c.on)) push_at(system.body(c.on), c.arm_k, impulse, state[c.on]);
  if (system.is_cube(c.from)) push_at(system.body(c.from), arm_of_side(c), -impulse, state[c.from]);
}

void push(const System& system, const Rod& rod, double impulse, const State& place, State& state) {
  const Vec2 p = impulse * rod_direction(rod, place);
  const auto add = [&](const RodEnd& end, const Vec2& on_end) {
    if (end.body < 0) return;
    push_at(system.body(end.body), held_place(end, place).arm, on_end, state[end.body]);
  };
  add(rod.i, p);
  add(rod.j, -p);
}

Momentum momentum_of(const System& system, const State& state, std::span<const int> cubes) {
  return sum_momenta(system, state, [&](const auto& add) {
    for (const int cube : cubes)
      add(cube);
  });
}

Momentum momentum_of_moving(const System& system,
                            const State& state,
                            std::span<const char> resting) {
  return sum_momenta(system, state, [&](const auto& add) {
    for (int cube = 0; cube < system.cubes; ++cube)
      if (resting.empty() || resting[cube] == 0) add(cube);
  });
}

void keep_turning(const System& system,
                  const std::vector<Contact>& contacts,
                  const State& before,
                  State& state) {
  for (const Island& island : find_islands(system, contacts)) {
    double change = 0.0;
    for (const int cube : island.cubes) {
      const Vec2 moved = state[cube].position - before[cube].position;
      change += system.body(cube).mass * det(moved, state[cube].velocity);
    }
    if (change == 0.0 || is_fixed(system, island)) continue;
    const Momentum sum = momentum_of(system, state, island.cubes);
    turn(system, island.cubes, {sum.center, Vec2::Zero(), -change / sum.inertia}, state);
  }
}

std::vector<std::vector<int>> flying_groups(const System& system,
                                            const std::vector<Contact>& contacts,
                                            std::span<const char> resting) {
  std::vector<std::vector<int>> groups;
  if (system.rods.empty()) return groups;
  for (Island& island : find_islands(system, contacts)) {
    const auto rests = [&](int cube) { return !resting.empty() && resting[cube] != 0; };
    if (island.rods.empty() || is_fixed(system, island) || std::ranges::any_of(island.cubes, rests))
      continue;
    groups.push_back(std::move(island.cubes));
  }
  return groups;
}

void keep_momenta(
    const System& system, std::span<const int> cubes, const State& from, double t, State& state) {
  const Momentum due = momentum_of(system, from, cubes);
  const Momentum now = momentum_of(system, state, cubes);
  const Vec2 v = due.linear / due.mass;
  const Vec2 center = due.center + t * v + 0.5 * t * t * system.gravity;
  const Vec2 missed = center - now.center;
  for (const int cube : cubes)
    state[cube].position += missed;
  const Vec2 slower = v + t * system.gravity - now.linear / now.mass;
  turn(system, cubes, {center, slower, (due.angular - now.angular) / now.inertia}, state);
}

double energy_of(const System& system, const State& state, std::span<const int> cubes) {
  double sum = 0.0;
  for (const int cube : cubes) {
    const Body& body = system.body(cube);
    sum += kinetic_energy(body, state[cube]) - body.mass * system.gravity.dot(state[cube].position);
  }
  return sum;
}

RigidMotion kept_motion(const Momentum& momentum, std::span<const Vec2> fixed_normals) {
  const Vec2 mean = momentum.linear / momentum.mass;
  if (fixed_normals.empty()) {
    return {momentum.center, mean, momentum.angular / momentum.inertia};
  }
  const Vec2 n = fixed_normals.front();
  const bool one_direction = std::ranges::all_of(
      fixed_normals, [&](const Vec2& m) { return std::abs(det(n, m)) <= parallel; });
  if (!one_direction) return {};
  const Vec2 t = perp(n);
  return {momentum.center, mean.dot(t) * t, 0.0};
}

double scale_to_energy(const System& system,
                       std::span<const int> cubes,
                       const RigidMotion& kept,
                       double goal,
                       double most,
                       State& state) {
  double rest = 0.0;
  for (const int cube : cubes) {
    const Body& body = system.body(cube);
    const BodyState& s = state[cube];
    rest += kinetic_energy(
        body, {{}, 0.0, s.velocity - kept.at(s.position), s.spin - spin_of(body, kept)});
  }
  const double missing = goal - energy_of(system, state, cubes);
  if (rest <= 0.0) return missing;
  const double square = std::clamp(1.0 + missing / rest, 0.0, most * most);
  const double factor = std::sqrt(square);
  for (const int cube : cubes) {
    BodyState& s = state[cube];
    const Vec2 v = kept.at(s.position);
    s.velocity = v + factor * (s.velocity - v);
    const double spin = spin_of(system.body(cube), kept);
    s.spin = spin + factor * (s.spin - spin);
  }
  return missing - (square - 1.0) * rest;
}

}  // namespace wuerfel
