#include "core/time/stepping/near_contacts.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// Bodies that come nearer to each other by less than this share of the fall within a step are
/// carried by others.
constexpr double slow_share = 0.1;

}  // namespace

void NearContacts::begin(const State& state, double h, double gravity) {
  step_ = h;
  gravity_ = gravity;
  pose_boxes(*system_, state, start_);
  State drifted = state;
  for (BodyState& s : drifted) {
    s.position += h * s.velocity;
    s.angle += h * s.spin;
  }
  pose_boxes(*system_, drifted, drift_);
  spin_.assign(start_.size(), 0.0);
  for (std::size_t i = 0; i < state.size(); ++i)
    spin_[i] = std::abs(state[i].spin);
}

std::vector<Contact> NearContacts::find_towards(const State& end, double reach) {
  pose_boxes(*system_, end, end_);
  return find(reach, start_);
}

std::vector<Contact> NearContacts::find_at(std::span<const Box> end, double reach) {
  end_.assign(end.begin(), end.end());
  return find(reach, end_);
}

std::vector<Contact> NearContacts::find(double reach, const std::vector<Box>& measured) {
  std::vector<Contact> contacts;
  const auto bounds_of = [&](int i) {
    return swept_bounds(start_[i], end_[i], reach * system_->body(i).smaller_side());
  };
  const double fall = gravity_ * step_ * step_;
  for (const auto& [i, j] : neighbours_.find(*system_, bounds_of)) {
    const double scale = contact_scale(*system_, i, j);
    const FacingSide side =
        separating_side(*system_, {start_, drift_, end_}, slow_share * fall, i, j);
    if (side.separation >= reach * scale) continue;
    // Sides that may become flush within the step: a second corner on sides that are not gives a
    // false impulse when a corner passes the end of an edge.
    const double flush = 2.0 * step_ * (spin_[i] + spin_[j]) + 30.0 * fall / scale;
    add_near_contacts(measured, side, flush, contacts);
  }
  std::erase_if(contacts, [&](const Contact& c) { return is_covered(*system_, c); });
  add_planes(reach, measured, contacts);
  return contacts;
}

void NearContacts::add_planes(double reach,
                              const std::vector<Box>& measured,
                              std::vector<Contact>& contacts) const {
  for (int p = box_count(*system_); p < system_->count(); ++p) {
    for (int i = 0; i < system_->cubes; ++i)
      add_corners(i, p, reach, measured, contacts);
  }
}

/// Corners of a cube that come near to a plane.
void NearContacts::add_corners(int cube,
                               int plane,
                               double reach,
                               const std::vector<Box>& measured,
                               std::vector<Contact>& contacts) const {
  const Body& solid = system_->body(plane);
  const double near = reach * system_->body(cube).smaller_side();
  for (int k = 0; k < start_[cube].corner_count(); ++k) {
    const auto gap = [&](const Box& box) {
      return solid.normal.dot((box.center - solid.point) + box.arm[k]);
    };
    if (gap(start_[cube]) >= near && gap(end_[cube]) >= near) continue;
    Contact c;
    c.on = cube;
    c.from = plane;
    c.corner = k;
    contacts.push_back(at_poses(*system_, measured, c));
  }
}

}  // namespace wuerfel
