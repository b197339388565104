#include "core/dynamics/programs.h"

#include "core/constraints/rod.h"
#include "core/model/points.h"

namespace wuerfel {
namespace {

std::array<Vec2, points_per_cube> arms_of(const CubePoints& points) {
  std::array<Vec2, points_per_cube> arms;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    arms[k] = points.p[k] - points.p[points_per_cube - 1];
  }
  return arms;
}

/// The same for the same corner and side.
std::int64_t name_of(const Contact& c) {
  constexpr int body_bits = 29;
  return (((std::int64_t{c.on} << body_bits) | c.from) << 4) | (c.corner << 2) | c.side;
}

}  // namespace

void ProgramBuilder::begin(const State& state,
                           const Island& island,
                           Order order,
                           std::span<const Twist> targets) {
  const bool points = formulation_ == Formulation::points;
  program_.clear(points ? 2 : 3);
  local_.resize(system_->cubes, -1);
  int next = 0;
  for (const int cube : island.cubes) {
    local_[cube] = next++;
    const Body& body = system_->body(cube);
    const BodyState& s = state[cube];
    const Twist goal = targets.empty() ? Twist{} : targets[next - 1];
    if (!points) {
      const std::array<double, 3> mass = {body.mass, body.mass, body.inertia};
      std::array<double, 3> target = {goal.linear.x(), goal.linear.y(), goal.angular};
      if (order == Order::velocity) target = {s.velocity.x(), s.velocity.y(), s.spin};
      if (order == Order::acceleration) target = {system_->gravity.x(), system_->gravity.y(), 0.0};
      program_.add_block(mass, target);
      continue;
    }
    const CubePoints p = points_of(s, body.size);
    const auto masses = mass_distribution(body.size, body.mass);
    for (std::size_t k = 0; k < masses.size(); ++k) {
      Vec2 target = goal.linear + goal.angular * perp(p.p[k] - s.position);
      if (order == Order::velocity) target = p.v[k];
      if (order == Order::acceleration) target = system_->gravity;
      program_.add_block(std::array{masses[k].mass, masses[k].mass},
                         std::array{target.x(), target.y()});
    }
  }
  if (points) {
    for (const int cube : island.cubes) {
      add_rods(state, cube, points_per_cube * local_[cube], order);
    }
  }
  first_contact_row_ = program_.rows();
}

void ProgramBuilder::add_rods(const State& state, int cube, int first_block, Order order) {
  const CubePoints points = points_of(state[cube], system_->body(cube).size);
  for (const RodEnds& rod : cube_rods) {
    const auto i = rod.i;
    const auto j = rod.j;
    const double l_ij = (points.p[i] - points.p[j]).norm();
    // The cube is rigid here, so that displacements keep lengths to first order as velocities do.
    RodRow row = rod_velocity_row(points.p[i], points.p[j]);
    if (order == Order::acceleration) {
      row = rod_acceleration_row(points.p[i], points.p[j], points.v[i], points.v[j]);
    }
    const Vec2 g = row.g / l_ij;
    program_.add_equality(-row.c / l_ij);
    program_.add_entry(first_block + rod.i, std::array{g.x(), g.y()});
    program_.add_entry(first_block + rod.j, std::array{-g.x(), -g.y()});
  }
}

void ProgramBuilder::add_point_entries(const Contact& contact, const SideRow& row) {
  const auto add = [&](int body, int corner, const Vec2& g) {
    const int block = points_per_cube * local_[body] + corner;
    program_.add_entry(block, std::array{g.x(), g.y()});
  };
  if (system_->is_cube(contact.on)) add(contact.on, contact.corner, row.g_k);
  if (system_->is_cube(contact.from)) {
    add(contact.from, next_corner(contact.side), row.g_i);
    add(contact.from, contact.side, row.g_j);
  }
}

void ProgramBuilder::add_rigid_entries(const Contact& contact, const ContactRow& row) {
  if (system_->is_cube(contact.on)) program_.add_entry(local_[contact.on], row.on);
  if (system_->is_cube(contact.from)) program_.add_entry(local_[contact.from], row.from);
}

void ProgramBuilder::add_side(const State& state,
                              const Contact& contact,
                              SideUse use,
                              Order order) {
  const int index =
      use == SideUse::equality ? program_.add_equality(0.0) : program_.add_inequality(0.0);
  add_entries(state, contact, order, normal_row(*system_, state, contact, order), index);
}

void ProgramBuilder::add_entries(
    const State& state, const Contact& contact, Order order, const SideRow& row, int index) {
  if (formulation_ == Formulation::points) {
    program_.bound[index] = -row.c;
    add_point_entries(contact, row);
    return;
  }
  program_.row_name.push_back(name_of(contact));
  const ContactRow rigid = pull_back(*system_, state, contact, order, row);
  program_.bound[index] = -rigid.c;
  add_rigid_entries(contact, rigid);
}

void ProgramBuilder::add_friction(const State& state,
                                  const Island& island,
                                  std::span<const SideUse> use,
                                  Order order,
                                  std::span<const int> slides) {
  friction_.clear();
  friction_contact_.assign(island.contacts.size(), -1);
  int normal = first_contact_row_;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (use[k] == SideUse::none) continue;
    const Contact& c = island.contacts[k];
    FrictionContact rub{normal++, -1, system_->surface(c.on, c.from).friction,
                        slides.empty() ? 0 : slides[k]};
    if (rub.mu > 0.0) {
      rub.tangent = program_.add_row(0.0, -unbounded, unbounded);
      add_entries(state, c, order, tangential_row(*system_, state, c, order), rub.tangent);
    }
    friction_contact_[k] = static_cast<int>(friction_.size());
    friction_.push_back(rub);
  }
}

void ProgramBuilder::add_sides(const State& state,
                               const Island& island,
                               std::span<const SideUse> use,
                               Order order) {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (use[k] != SideUse::none) add_side(state, island.contacts[k], use[k], order);
  }
}

void ProgramBuilder::acceleration(const State& state,
                                  const Island& island,
                                  std::span<const SideUse> use) {
  begin(state, island, Order::acceleration);
  add_sides(state, island, use, Order::acceleration);
}

void ProgramBuilder::velocity(const State& state,
                              const Island& island,
                              std::span<const SideUse> use) {
  begin(state, island, Order::velocity);
  add_sides(state, island, use, Order::velocity);
}

void ProgramBuilder::position(const State& state,
                              const Island& island,
                              std::span<const SideUse> use,
                              std::span<const Twist> targets) {
  begin(state, island, Order::position, targets);
  add_sides(state, island, use, Order::position);
}

std::vector<Twist> ProgramBuilder::twists(const State& state,
                                          const Island& island,
                                          const std::vector<double>& x) const {
  std::vector<Twist> result;
  result.reserve(island.cubes.size());
  const double* at = x.data();
  for (const int cube : island.cubes) {
    if (formulation_ == Formulation::rigid) {
      result.push_back({Vec2(at[0], at[1]), at[2]});
      at += 3;
      continue;
    }
    const Body& body = system_->body(cube);
    std::array<Vec2, points_per_cube> rates;
    for (Vec2& rate : rates) {
      rate = {at[0], at[1]};
      at += 2;
    }
    const CubePoints points = points_of(state[cube], body.size);
    result.push_back(rigid_part(rates, arms_of(points), mass_distribution(body.size, body.mass)));
  }
  return result;
}

}  // namespace wuerfel
