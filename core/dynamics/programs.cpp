#include "core/dynamics/programs.h"

#include <algorithm>

#include "core/dynamics/rod_rows.h"
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

double bend_of(const Island& island, std::size_t rod, Order order) {
  return order == Order::position && !island.bends.empty() ? island.bends[rod] : 0.0;
}

/// The same for the same rod, apart from those of contacts and of friction.
std::int64_t name_of_rod(int number) { return (std::int64_t{1} << 62) + number; }

}  // namespace

std::vector<double> unknowns_of(const std::vector<Twist>& motions) {
  std::vector<double> x;
  for (const Twist& a : motions)
    x.insert(x.end(), {a.linear.x(), a.linear.y(), a.angular});
  return x;
}

bool ProgramBuilder::is_point(int cube) const {
  return system_->body(cube).kind == BodyKind::point;
}

void ProgramBuilder::number_cubes(const Island& island) {
  local_.resize(system_->cubes, -1);
  int next = 0;
  for (const int cube : island.cubes)
    local_[cube] = next++;
  if (formulation_ == Formulation::rigid) return;
  first_block_.resize(system_->cubes, -1);
  next = 0;
  for (const int cube : island.cubes) {
    first_block_[cube] = next;
    next += is_point(cube) ? 1 : points_per_cube;
  }
}

void ProgramBuilder::build(const State& state,
                           const Island& island,
                           std::span<const SideUse> use,
                           Order order,
                           std::span<const Twist> targets) {
  number_cubes(island);
  order_ = order;
  use_.assign(use.begin(), use.end());
  if (use.empty()) use_.resize(island.contacts.size(), SideUse::inequality);
  if (formulation_ == Formulation::rigid) {
    lay_out(island);
    fill(state, island, order, targets);
    return;
  }
  program_.clear(2);
  for (std::size_t k = 0; k < island.cubes.size(); ++k)
    add_points(state, island.cubes[k], order, targets.empty() ? Twist{} : targets[k]);
  for (const int cube : island.cubes)
    if (!is_point(cube)) add_rods(state, cube, order);
  first_rod_row_ = program_.rows();
  for (std::size_t k = 0; k < island.rods.size(); ++k) {
    add_rod(state, system_->rods[island.rods[k]], order);
    program_.bound.back() -= bend_of(island, k, order);
  }
  first_contact_row_ = program_.rows();
  for (std::size_t k = 0; k < island.contacts.size(); ++k)
    if (use_[k] != SideUse::none) add_side(state, island.contacts[k], use_[k], order);
}

/// Masses, and which row couples which cubes.
void ProgramBuilder::lay_out(const Island& island) {
  program_.clear(3);
  first_rod_row_ = 0;
  first_contact_row_ = static_cast<int>(island.rods.size());
  for (const int cube : island.cubes) {
    const Body& body = system_->body(cube);
    program_.mass.insert(program_.mass.end(), {body.mass, body.mass, body.inertia});
  }
  program_.target.resize(program_.mass.size());
  const std::size_t rows = island.rods.size() + island.contacts.size();
  for (auto* v : {&program_.bound, &program_.force_min, &program_.force_max})
    v->reserve(rows);
  program_.row_start.reserve(rows + 1);
  program_.row_name.reserve(rows);
  program_.entry_block.reserve(2 * rows);
  for (const int number : island.rods) {
    const Rod& rod = system_->rods[number];
    program_.add_equality(0.0);
    program_.row_name.push_back(name_of_rod(rod.number));
    for (const int body : {rod.i.body, rod.j.body}) {
      if (body < 0) continue;
      program_.entry_block.push_back(local_[body]);
      ++program_.row_start.back();
    }
  }
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (use_[k] == SideUse::none) continue;
    const Contact& c = island.contacts[k];
    program_.add_row(0.0, use_[k] == SideUse::equality ? -unbounded : 0.0, unbounded);
    program_.row_name.push_back(c.id());
    for (const int body : {c.on, c.from}) {
      if (!system_->is_cube(body)) continue;
      program_.entry_block.push_back(local_[body]);
      ++program_.row_start.back();
    }
  }
  program_.coefficients.resize(3 * program_.entry_block.size());
}

void ProgramBuilder::fill(const State& state,
                          const Island& island,
                          Order order,
                          std::span<const Twist> targets) {
  double* f = program_.target.data();
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    const BodyState& s = state[island.cubes[k]];
    Twist target = targets.empty() ? Twist{} : targets[k];
    if (order == Order::velocity) target = {s.velocity, s.spin};
    if (order == Order::acceleration) target = {system_->gravity, 0.0};
    *f++ = target.linear.x();
    *f++ = target.linear.y();
    *f++ = target.angular;
  }
  double* b = program_.bound.data();
  double* g = program_.coefficients.data();
  for (std::size_t k = 0; k < island.rods.size(); ++k) {
    const Rod& rod = system_->rods[island.rods[k]];
    const BodyRodRow row = rod_row(rod, state, order);
    *b++ = -row.c - bend_of(island, k, order);
    if (rod.i.body >= 0) g = std::copy(row.i.begin(), row.i.end(), g);
    if (rod.j.body >= 0) g = std::copy(row.j.begin(), row.j.end(), g);
  }
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (use_[k] == SideUse::none) continue;
    const Contact& c = island.contacts[k];
    const ContactRow row =
        pull_back(*system_, state, c, order, normal_row(*system_, state, c, order));
    *b++ = -row.c;
    if (system_->is_cube(c.on)) g = std::copy(row.on.begin(), row.on.end(), g);
    if (system_->is_cube(c.from)) g = std::copy(row.from.begin(), row.from.end(), g);
  }
}

void ProgramBuilder::renew(const State& state, const Island& island, Order order) {
  fill(state, island, order, {});
}

void ProgramBuilder::add_friction(const State& state,
                                  const Island& island,
                                  std::span<const int> slides) {
  friction_.clear();
  friction_contact_.assign(island.contacts.size(), -1);
  int normal = first_contact_row_;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (use_[k] == SideUse::none) continue;
    const Contact& c = island.contacts[k];
    FrictionContact rub{normal++, -1, system_->surface(c.on, c.from).friction,
                        slides.empty() ? 0 : slides[k]};
    friction_contact_[k] = static_cast<int>(friction_.size());
    if (rub.mu > 0.0) {
      const SideRow row = tangential_row(*system_, state, c, order_);
      if (formulation_ == Formulation::points) {
        rub.tangent = program_.add_row(-row.c, -unbounded, unbounded);
        add_point_entries(c, row);
      } else {
        const ContactRow rigid = pull_back(*system_, state, c, order_, row);
        rub.tangent = program_.add_row(-rigid.c, -unbounded, unbounded);
        program_.row_name.push_back(-1 - c.id());
        if (system_->is_cube(c.on)) program_.add_entry(local_[c.on], rigid.on);
        if (system_->is_cube(c.from)) program_.add_entry(local_[c.from], rigid.from);
      }
    }
    friction_.push_back(rub);
  }
}

std::vector<char> ProgramBuilder::still_blocks(const State& state, const Island& island) const {
  std::vector<char> still(program_.blocks(), 0);
  if (formulation_ == Formulation::points) return still;
  for (std::size_t k = 0; k < island.cubes.size(); ++k)
    still[k] = is_still(state[island.cubes[k]]) ? 1 : 0;
  return still;
}

void ProgramBuilder::acceleration(const State& state,
                                  const Island& island,
                                  std::span<const SideUse> use) {
  build(state, island, use, Order::acceleration);
}

void ProgramBuilder::velocity(const State& state,
                              const Island& island,
                              std::span<const SideUse> use) {
  build(state, island, use, Order::velocity);
}

void ProgramBuilder::position(const State& state,
                              const Island& island,
                              std::span<const SideUse> use,
                              std::span<const Twist> targets) {
  build(state, island, use, Order::position, targets);
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
    if (is_point(cube)) {
      result.push_back({Vec2(at[0], at[1]), 0.0});
      at += 2;
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
