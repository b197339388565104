#include "core/dynamics/contact_rows.h"

#include "core/dynamics/pull_back.h"

namespace wuerfel {
namespace {

SideRow scaled(const SideRow& row, double scale) {
  return {row.g_i * scale, row.g_j * scale, row.g_k * scale, row.c * scale};
}

}  // namespace

SideRow normal_row(const System& system, const State& state, const Contact& c, Order order) {
  const double scale = 1.0 / c.length;
  if (order == Order::acceleration) {
    const ContactVelocity v = contact_velocity(system, state, c);
    return scaled(side_acceleration_row(c.arm_i, c.arm_j, c.alpha, v.v_i, v.v_j, v.v_k), scale);
  }
  SideRow row = scaled(side_velocity_row(c.arm_i, c.arm_j, c.alpha), scale);
  if (order == Order::position) row.c = c.gap;
  return row;
}

SideRow tangential_row(const System& system, const State& state, const Contact& c, Order order) {
  SideRow row = side_tangent_row(c.arm_i, c.arm_j, c.alpha);
  if (order == Order::acceleration) {
    const ContactVelocity v = contact_velocity(system, state, c);
    row = side_tangent_acceleration_row(c.arm_i, c.arm_j, c.alpha, v.v_i, v.v_j, v.v_k);
  }
  row = scaled(row, 1.0 / c.length);
  if (order == Order::position) row.c = c.slip;
  if (order != Order::acceleration && system.is_cube(c.from)) {
    // Across an open gap the side's body is met at the place of the corner, where impulses act: it turns by <v_j - v_i, n>.
    const Vec2 foot = state[c.from].position + c.alpha * c.arm_j + (1.0 - c.alpha) * c.arm_i;
    const Vec2 turn = c.normal.dot(c.point - foot) / c.length * c.normal;
    row.g_i += turn;
    row.g_j -= turn;
  }
  return row;
}

double slip_rate(const System& system, const State& state, const Contact& c) {
  const ContactVelocity v = contact_velocity(system, state, c);
  const SideRow row = tangential_row(system, state, c, Order::velocity);
  return row.g_i.dot(v.v_i) + row.g_j.dot(v.v_j) + row.g_k.dot(v.v_k);
}

ContactRow pull_back(const System& system,
                     const State& state,
                     const Contact& contact,
                     Order order,
                     const SideRow& row) {
  RigidRow on;
  RigidRow from;
  if (system.is_cube(contact.on)) pull_back(row.g_k, contact.arm_k, state[contact.on].spin, on);
  if (system.is_cube(contact.from)) {
    const double omega = state[contact.from].spin;
    pull_back(row.g_i, contact.arm_i, omega, from);
    pull_back(row.g_j, contact.arm_j, omega, from);
  }
  const bool accelerates = order == Order::acceleration;
  return {on.g, from.g, accelerates ? row.c + (on.centripetal + from.centripetal) : row.c};
}

}  // namespace wuerfel
