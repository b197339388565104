// Rows of ProgramBuilder on the points of the paper: every point is a block of its own.
#include "core/dynamics/programs.h"
#include "core/dynamics/rod_rows.h"
#include "core/model/points.h"

namespace wuerfel {

void ProgramBuilder::add_points(const State& state, int cube, Order order, const Twist& goal) {
  const Body& body = system_->body(cube);
  const BodyState& s = state[cube];
  if (is_point(cube)) {
    Vec2 target = goal.linear;
    if (order == Order::velocity) target = s.velocity;
    if (order == Order::acceleration) target = system_->gravity;
    program_.add_block(std::array{body.mass, body.mass}, std::array{target.x(), target.y()});
    return;
  }
  const CubePoints p = points_of(s, body.size);
  const auto masses = mass_distribution(body.size, body.mass);
  for (std::size_t k = 0; k < masses.size(); ++k) {
    Vec2 target = point_velocity(goal, p.p[k] - s.position);
    if (order == Order::velocity) target = p.v[k];
    if (order == Order::acceleration) target = system_->gravity;
    program_.add_block(std::array{masses[k].mass, masses[k].mass},
                       std::array{target.x(), target.y()});
  }
}

void ProgramBuilder::add_rods(const State& state, int cube, Order order) {
  const CubePoints points = points_of(state[cube], system_->body(cube).size);
  const int first_block = first_block_[cube];
  for (const RodEnds& rod : cube_rods) {
    const Vec2& p_i = points.p[rod.i];
    const Vec2& p_j = points.p[rod.j];
    const double l_ij = (p_i - p_j).norm();
    // The cube is rigid here, so that displacements keep lengths to first order as velocities do.
    RodRow row = rod_velocity_row(p_i, p_j);
    if (order == Order::acceleration)
      row = rod_acceleration_row(p_i, p_j, points.v[rod.i], points.v[rod.j]);
    const Vec2 g = row.g / l_ij;
    program_.add_equality(-row.c / l_ij);
    program_.add_entry(first_block + rod.i, std::array{g.x(), g.y()});
    program_.add_entry(first_block + rod.j, std::array{-g.x(), -g.y()});
  }
}

void ProgramBuilder::add_rod(const State& state, const Rod& rod, Order order) {
  const RodRow row = rod_row(rod, held_place(rod.i, state), held_place(rod.j, state), order);
  program_.add_equality(-row.c);
  add_held_place(rod.i, row.g);
  add_held_place(rod.j, -row.g);
}

void ProgramBuilder::add_held_place(const RodEnd& end, const Vec2& g) {
  if (end.body < 0) return;
  const int first = first_block_[end.body];
  if (is_point(end.body)) return program_.add_entry(first, std::array{g.x(), g.y()});
  const auto share = share_of_points(end.at, system_->body(end.body).size);
  for (int k = 0; k < points_per_cube; ++k) {
    if (share[k] == 0.0) continue;
    program_.add_entry(first + k, std::array{share[k] * g.x(), share[k] * g.y()});
  }
}

void ProgramBuilder::add_side(const State& state,
                              const Contact& contact,
                              SideUse use,
                              Order order) {
  const SideRow row = normal_row(*system_, state, contact, order);
  program_.add_row(-row.c, use == SideUse::equality ? -unbounded : 0.0, unbounded);
  add_point_entries(contact, row);
}

void ProgramBuilder::add_point_entries(const Contact& contact, const SideRow& row) {
  const auto add = [&](int body, int corner, const Vec2& g) {
    const int block = first_block_[body] + corner;
    program_.add_entry(block, std::array{g.x(), g.y()});
  };
  if (system_->is_cube(contact.on)) add(contact.on, contact.corner, row.g_k);
  if (system_->is_cube(contact.from)) {
    add(contact.from, next_corner(contact.side), row.g_i);
    add(contact.from, contact.side, row.g_j);
  }
}

}  // namespace wuerfel
