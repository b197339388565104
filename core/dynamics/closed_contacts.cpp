#include "core/dynamics/closed_contacts.h"

#include <algorithm>

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
  laid_out_ = false;
  boxes_.resize(system_->count());
  for (int i = system_->cubes; i < system_->count(); ++i)
    boxes_[i] = system_->body(i).box;
}

bool ClosedContacts::moves(const RodEnd& end) const {
  return end.body >= 0 && (resting_.empty() || resting_[end.body] == 0);
}

void ClosedContacts::pose(const State& state) {
  for (const int cube : island_.cubes) {
    const BodyState& s = state[cube];
    boxes_[cube] = make_box(s.position, s.angle, system_->body(cube).size);
  }
  for (Contact& c : island_.contacts)
    c = at_poses(*system_, boxes_, c);
}

const std::vector<double>& ClosedContacts::nearest(const State& state, Order order) {
  if (none()) return x_;
  pose(state);
  if (rubbing_.any()) {
    rubbing_.solve(*system_, state, island_, order, x_, forces_);
    return x_;
  }
  if (laid_out_) {
    builder_.renew(state, island_, order);
    solver_.factorise_again(builder_.program());
  } else {
    const std::vector<SideUse> use(island_.contacts.size(), SideUse::equality);
    builder_.acceleration(state, island_, use);
    if (order != Order::acceleration) builder_.renew(state, island_, order);
    solver_.factorise(builder_.program());
    laid_out_ = true;
  }
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

}  // namespace wuerfel
