#include "core/time/near_contacts.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

// Shares of the smaller side of a pair: pairs nearer than this may meet, and pairs that move by
// more than this may when they are near at neither end of the step.
constexpr double near_share = 1e-2;
constexpr double fast_share = 0.25;

}  // namespace

void NearContacts::find(const State& start, const State& predicted, double h, double gravity) {
  pose_boxes(*system_, start, boxes_);
  pose_boxes(*system_, predicted, predicted_boxes_);
  bounds_.clear();
  contacts_.clear();
  for (int i = 0; i < system_->count() && system_->body(i).kind != BodyKind::plane; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Box& from = boxes_[at];
    const Box& to = predicted_boxes_[at];
    const auto extent = [](const Box& box) {
      return Vec2(box.arm[2].cwiseAbs().cwiseMax(box.arm[1].cwiseAbs())
                  + Vec2::Constant(near_share * box.smaller_side()));
    };
    bounds_.push_back({(from.center - extent(from)).cwiseMin(to.center - extent(to)),
                       (from.center + extent(from)).cwiseMax(to.center + extent(to))});
  }
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(bounds_)) {
    if (system_->is_cube(pair.first)) add_pair(start, pair, h, gravity);
  }
  add_planes();
}

void NearContacts::add_pair(const State& start, const IndexPair& pair, double h, double gravity) {
  const auto i = static_cast<std::size_t>(pair.first);
  const auto j = static_cast<std::size_t>(pair.second);
  const double side = std::min(boxes_[i].smaller_side(), boxes_[j].smaller_side());
  const Vec2 relative = (predicted_boxes_[i].center - boxes_[i].center)
                        - (predicted_boxes_[j].center - boxes_[j].center);
  const bool near = separation(boxes_[i], boxes_[j]) < near_share * side
                    || separation(predicted_boxes_[i], predicted_boxes_[j]) < near_share * side
                    || relative.norm() > fast_share * side;
  if (!near) return;
  const auto spin = [&](int body) {
    return system_->is_cube(body) ? std::abs(start[static_cast<std::size_t>(body)].spin) : 0.0;
  };
  // Sides that may become flush within the step: a second corner on sides that are not gives a
  // false impulse when a corner passes the end of an edge.
  const double flush =
      2.0 * h * (spin(pair.first) + spin(pair.second)) + 30.0 * gravity * h * h / side;
  add_near_contacts(boxes_, pair.first, pair.second, flush, contacts_);
}

void NearContacts::add_planes() {
  for (int p = 0; p < system_->count(); ++p) {
    const Body& plane = system_->body(p);
    if (plane.kind != BodyKind::plane) continue;
    for (int i = 0; i < system_->cubes; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double near = near_share * boxes_[at].smaller_side();
      for (int k = 0; k < 4; ++k) {
        const auto gap = [&](const Box& box) {
          return plane.normal.dot((box.center - plane.point)
                                  + box.arm[static_cast<std::size_t>(k)]);
        };
        if (gap(boxes_[at]) >= near && gap(predicted_boxes_[at]) >= near) continue;
        Contact c;
        c.on = i;
        c.from = p;
        c.corner = k;
        contacts_.push_back(at_poses(*system_, boxes_, c));
      }
    }
  }
}

}  // namespace wuerfel
