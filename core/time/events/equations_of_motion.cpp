#include "core/time/events/equations_of_motion.h"

#include <algorithm>
#include <utility>

#include "core/dynamics/momentum.h"

namespace wuerfel {

void EquationsOfMotion::close(ContactSet closed, const std::vector<char>& resting) {
  contacts_.close(closed.contacts, resting, closed.touches);
  flying_ = flying_groups(contacts_.system(), contacts_.contacts(), resting);
  touches_ = std::move(closed.touches);
  slips_ = static_cast<int>(
      std::ranges::count_if(touches_, [](const Touch& t) { return t.slips != 0; }));
}

void EquationsOfMotion::keep_momenta(const State& from, double t, State& state) const {
  for (const std::vector<int>& cubes : flying_)
    wuerfel::keep_momenta(contacts_.system(), cubes, from, t, state);
}

void EquationsOfMotion::operator()(const std::vector<double>& y, std::vector<double>& rate) {
  state_.resize(y.size() / components);
  unpack(y, state_);
  contacts_.accelerate(state_, twists_);
  rate.resize(y.size());
  double* at = rate.data();
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const Twist& a = twists_[i];
    at[0] = state_[i].velocity.x();
    at[1] = state_[i].velocity.y();
    at[2] = state_[i].spin;
    at[3] = a.linear.x();
    at[4] = a.linear.y();
    at[5] = a.angular;
    at += components;
  }
}

void EquationsOfMotion::project(State& state) {
  project_places(contacts_, state);
  project_velocities(contacts_, state);
}

void EquationsOfMotion::find_loads(std::vector<double>& loads) const {
  if (contacts_.contacts().empty()) return loads.clear();
  wuerfel::find_loads(touches_, contacts_.contacts(), contacts_.forces(), loads);
  const RubbingContacts& rubbing = contacts_.rubbing();
  if (!rubbing.any()) return;
  rubbing.add_margins(contacts_.forces(), loads);
  rubbing.add_slips(contacts_.system(), state_, contacts_.contacts(), loads);
}

int EquationsOfMotion::first_slip(const std::vector<double>& loads) const {
  return static_cast<int>(loads.size()) - slips_;
}

}  // namespace wuerfel
