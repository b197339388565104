#include "core/dynamics/rod_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/dynamics/pull_back.h"
#include "core/geometry/box.h"

namespace wuerfel {
namespace {

constexpr double kept_length = 1e-13;  ///< share of a rod's length that counts as rounding

Vec2 direction(const Rod& rod, const HeldPlace& i, const HeldPlace& j) {
  if (rod.kind == Rod::Kind::rod) return (i.p - j.p).normalized();
  return rod.kind == Rod::Kind::pin_x ? Vec2::UnitX() : Vec2::UnitY();
}

double excess(const Rod& rod, const HeldPlace& i, const HeldPlace& j) {
  if (rod.kind != Rod::Kind::rod) return direction(rod, i, j).dot(i.p - j.p);
  return rod_error(i.p, j.p, rod.length) / ((i.p - j.p).norm() + rod.length);
}

double spin_of(const RodEnd& end, const State& state) {
  return end.body < 0 ? 0.0 : state[end.body].spin;
}

/// Length by which errors of a rod are measured, m.
double rod_scale(const System& system, const Rod& rod) {
  if (rod.kind == Rod::Kind::rod) return rod.length;
  double scale = std::numeric_limits<double>::max();
  for (const int body : {rod.i.body, rod.j.body})
    if (body >= 0) scale = std::min(scale, system.body(body).smaller_side());
  return scale < std::numeric_limits<double>::max() ? scale : 1.0;
}

}  // namespace

HeldPlace held_place(const RodEnd& end, const State& state) {
  if (end.body < 0) return {Vec2::Zero(), end.at, Vec2::Zero()};
  const BodyState& s = state[end.body];
  if (end.at.isZero(0.0)) return {Vec2::Zero(), s.position, s.velocity};
  const Vec2 axis = make_box(s.position, s.angle, Vec2::Zero()).axis;
  const Vec2 arm = end.at.x() * axis + end.at.y() * perp(axis);
  return {arm, s.position + arm, point_velocity(s, arm)};
}

RodRow rod_row(const Rod& rod, const HeldPlace& i, const HeldPlace& j, Order order) {
  RodRow row{direction(rod, i, j), 0.0};
  if (order == Order::position) row.c = excess(rod, i, j);
  if (order == Order::acceleration && rod.kind == Rod::Kind::rod)
    row.c = rod_acceleration_row(i.p, j.p, i.v, j.v).c / (i.p - j.p).norm();
  return row;
}

BodyRodRow rod_row(const Rod& rod, const State& state, Order order) {
  const HeldPlace i = held_place(rod.i, state);
  const HeldPlace j = held_place(rod.j, state);
  const RodRow row = rod_row(rod, i, j, order);
  RigidRow on_i;
  RigidRow on_j;
  if (rod.i.body >= 0) pull_back(row.g, i.arm, spin_of(rod.i, state), on_i);
  if (rod.j.body >= 0) pull_back(-row.g, j.arm, spin_of(rod.j, state), on_j);
  const double centripetal = on_i.centripetal + on_j.centripetal;
  return {on_i.g, on_j.g, order == Order::acceleration ? row.c + centripetal : row.c};
}

Vec2 rod_direction(const Rod& rod, const State& state) {
  return direction(rod, held_place(rod.i, state), held_place(rod.j, state));
}

double rod_excess(const Rod& rod, const State& state) {
  return excess(rod, held_place(rod.i, state), held_place(rod.j, state));
}

double rod_rate(const Rod& rod, const State& state) {
  const HeldPlace i = held_place(rod.i, state);
  const HeldPlace j = held_place(rod.j, state);
  return direction(rod, i, j).dot(i.v - j.v);
}

double rod_error(const System& system, const State& state, const Rod& rod) {
  return std::abs(rod_excess(rod, state)) / rod_scale(system, rod);
}

double largest_rod_error(const System& system, const State& state) {
  double worst = 0.0;
  for (const Rod& rod : system.rods)
    worst = std::max(worst, rod_error(system, state, rod));
  return worst;
}

double rod_change(const Rod& rod, const State& place, const State& moved) {
  const BodyRodRow row = rod_row(rod, place, Order::velocity);
  const auto along = [&](const RodEnd& end, const std::array<double, 3>& g) {
    if (end.body < 0) return 0.0;
    const BodyState& d = moved[end.body];
    return g[0] * d.velocity.x() + g[1] * d.velocity.y() + g[2] * d.spin;
  };
  return along(rod.i, row.i) + along(rod.j, row.j);
}

bool has_length(const System& system, const State& state, const Rod& rod) {
  const HeldPlace i = held_place(rod.i, state);
  const HeldPlace j = held_place(rod.j, state);
  const double rounding = std::max(kept_length * rod_scale(system, rod), gap_rounding(i.p, j.p));
  return std::abs(excess(rod, i, j)) <= rounding;
}

const std::string& end_name(const System& system, const Rod& rod, const RodEnd& end) {
  const auto body = std::ranges::find(system.bodies, end.name, &Body::number);
  return end.name < 0 || body == system.bodies.end() ? rod.name : body->name;
}

bool jerks(const System& system, const State& state, const Rod& rod) {
  const double fall = std::sqrt(system.gravity.norm() * rod_scale(system, rod));
  const HeldPlace i = held_place(rod.i, state);
  const HeldPlace j = held_place(rod.j, state);
  const double speed = std::max({fall, i.v.norm(), j.v.norm()});
  return std::abs(direction(rod, i, j).dot(i.v - j.v)) > rate_tolerance * speed;
}

}  // namespace wuerfel
