#include "core/dynamics/closed_contacts.h"

#include <algorithm>

#include "core/dynamics/momentum_balance.h"
#include "core/dynamics/rod_rows.h"

namespace wuerfel {

ClosedContacts::ClosedContacts(const System& system)
    : system_(&system), builder_(system, Formulation::rigid) {}

void ClosedContacts::close(const std::vector<Contact>& contacts,
                           const std::vector<char>& resting,
                           std::span<const Touch> touches) {
  rubbing_.close(touches);
  resting_ = resting;
  island_.contacts = contacts;
  island_.cubes.clear();
  island_.rods.clear();
  for (int k = 0; k < static_cast<int>(system_->rods.size()); ++k) {
    const Rod& rod = system_->rods[k];
    if (!moves(rod.i) && !moves(rod.j)) continue;
    island_.rods.push_back(k);
    for (const int body : {rod.i.body, rod.j.body})
      if (body >= 0) island_.cubes.push_back(body);
  }
  for (const Contact& c : contacts) {
    for (const int body : {c.on, c.from}) {
      if (system_->is_cube(body)) island_.cubes.push_back(body);
    }
  }
  std::ranges::sort(island_.cubes);
  island_.cubes.erase(std::unique(island_.cubes.begin(), island_.cubes.end()), island_.cubes.end());
  held_ = std::ranges::any_of(island_.rods, [&](int k) { return is_held(system_->rods[k]); });
  hangs_alone_ = contacts.empty() && island_.rods.size() == 1 && island_.cubes.size() == 1;
  on_fixed_ = touches_fixed(*system_, contacts) || (held_ && !hangs_alone_);
  laid_out_ = false;
  angles_.clear();
  boxes_.resize(system_->count());
  for (int i = system_->cubes; i < system_->count(); ++i)
    boxes_[i] = system_->body(i).box;
}

bool ClosedContacts::moves(const RodEnd& end) const {
  return end.body >= 0 && (resting_.empty() || resting_[end.body] == 0);
}

/// Contacts as they are at the state. False where they were there already.
bool ClosedContacts::pose(const State& state) {
  bool moved = angles_.empty();
  angles_.resize(island_.cubes.size());
  double* angle = angles_.data();
  for (const int cube : island_.cubes) {
    const BodyState& s = state[cube];
    moved = moved || s.angle != *angle || s.position != boxes_[cube].center;
    if (moved) boxes_[cube] = make_box(s.position, s.angle, system_->body(cube).size);
    *angle++ = s.angle;
  }
  if (!moved) return false;
  for (Contact& c : island_.contacts)
    c = at_poses(*system_, boxes_, c);
  return true;
}

/// The rows, and their factorisation. Those of contacts have the same coefficients at the same place.
void ClosedContacts::find_rows(const State& state, bool moved, Order order) {
  if (laid_out_) {
    builder_.renew(state, island_, order);
    if (moved || !island_.rods.empty()) solver_.factorise_again(builder_.program());
    return;
  }
  const std::vector<SideUse> use(island_.contacts.size(), SideUse::equality);
  builder_.acceleration(state, island_, use);
  if (order != Order::acceleration) builder_.renew(state, island_, order);
  solver_.factorise(builder_.program());
  laid_out_ = true;
}

/// A pendulum: one row g x + c = 0, which needs no solver. x = f + M^-1 g nu, twice, so that the row holds to rounding.
void ClosedContacts::move_on_rod(const State& state, Order order) {
  const int cube = island_.cubes.front();
  const Body& body = system_->body(cube);
  const Rod& rod = system_->rods[island_.rods.front()];
  const BodyRodRow row = rod_row(rod, state, order);
  const std::array<double, 3>& g = rod.i.body >= 0 ? row.i : row.j;
  const double per_mass = 1.0 / body.mass;
  const std::array<double, 3> ease{per_mass * g[0], per_mass * g[1], g[2] / body.inertia};
  const double compliance = g[0] * ease[0] + g[1] * ease[1] + g[2] * ease[2];
  double x[3] = {0.0, 0.0, 0.0};
  if (order == Order::velocity) {
    const BodyState& s = state[cube];
    x[0] = s.velocity.x(), x[1] = s.velocity.y(), x[2] = s.spin;
  } else if (order == Order::acceleration) {
    x[0] = system_->gravity.x(), x[1] = system_->gravity.y();
  }
  for (int round = 0; round < 2; ++round) {
    const double nu = -(g[0] * x[0] + g[1] * x[1] + g[2] * x[2] + row.c) / compliance;
    for (int k = 0; k < 3; ++k)
      x[k] += ease[k] * nu;
  }
  x_.assign(x, x + 3);
}

const std::vector<double>& ClosedContacts::nearest(const State& state, Order order) {
  if (none()) return x_;
  if (hangs_alone_) {
    move_on_rod(state, order);
    return x_;
  }
  const bool moved = pose(state);
  if (rubbing_.any()) {
    rubbing_.solve(*system_, state, island_, order, x_, forces_);
    return x_;
  }
  find_rows(state, moved, order);
  if (island_.rods.empty()) {
    solver_.solve(builder_.program(), x_, forces_);
    return x_;
  }
  solver_.solve(builder_.program(), x_, multipliers_);
  forces_.assign(multipliers_.begin() + builder_.first_contact_row(), multipliers_.end());
  return x_;
}

void ClosedContacts::accelerate(const State& state, std::vector<Twist>& accelerations) {
  accelerations.assign(state.size(), {system_->gravity, 0.0});
  for (std::size_t i = 0; i < resting_.size(); ++i) {
    if (resting_[i] != 0) accelerations[i] = {};
  }
  forces_.clear();
  const double* at = nearest(state, Order::acceleration).data();
  for (const int cube : island_.cubes) {
    accelerations[cube] = {Vec2(at[0], at[1]), at[2]};
    at += 3;
  }
}

/// Beyond gravity, whoever did it: what the accelerations say.
Push ClosedContacts::felt(const State& state, const Vec2& center) const {
  Push sum;
  const double* a = x_.data();
  for (const int cube : island_.cubes) {
    const Body& body = system_->body(cube);
    const Vec2 force = body.mass * (Vec2(a[0], a[1]) - system_->gravity);
    sum += {force, det(state[cube].position - center, force) + body.inertia * a[2]};
    a += 3;
  }
  return sum;
}

Push ClosedContacts::pushed(const State& state) const {
  Push sum;
  if (!on_fixed_ && !held_) return sum;
  if (hangs_alone_ && system_->cubes == 1) {
    const Body& body = system_->body(0);
    return {body.mass * (Vec2(x_[0], x_[1]) - system_->gravity), body.inertia * x_[2]};
  }
  const Vec2 center = common_center(*system_, state, resting_);
  if (held_) return felt(state, center);
  if (!rubbing_.any()) {
    const double* force = forces_.data();
    for (const Contact& c : island_.contacts)
      add_push(*system_, state, center, c, *force++ * c.normal, sum);
    return sum;
  }
  const std::vector<double> along = rubbing_.along_sides(forces_);
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    const Contact& c = island_.contacts[k];
    add_push(*system_, state, center, c, forces_[k] * c.normal + along[k] * perp(c.normal), sum);
  }
  return sum;
}

}  // namespace wuerfel
