#include "core/constraints/contact.h"

#include <algorithm>
#include <cmath>

#include "core/constraints/manifold.h"

namespace wuerfel {
namespace {

/// The contact of corner k of a box with a plane. The plane has no ends: the side is placed under
/// the corner.
Contact corner_on_plane(int on, const Box& b, int k, int from, const Body& plane) {
  Contact c;
  c.on = on;
  c.from = from;
  c.corner = k;
  c.normal = plane.normal;
  c.arm_k = b.arm[k];
  c.point = b.center + c.arm_k;
  c.gap = plane.normal.dot((b.center - plane.point) + c.arm_k);
  c.alpha = 0.5;
  const Vec2 foot = c.point - c.gap * c.normal;
  c.arm_i = foot + 0.5 * perp(c.normal);
  c.arm_j = foot - 0.5 * perp(c.normal);
  return c;
}

void add_plane(int plane_index,
               const Body& plane,
               int box_index,
               const Box& box,
               double tolerance,
               std::vector<Contact>& contacts) {
  for (int k = 0; k < 4; ++k) {
    const double gap = plane.normal.dot((box.center - plane.point) + box.arm[k]);
    if (gap <= tolerance)
      contacts.push_back(corner_on_plane(box_index, box, k, plane_index, plane));
  }
}

}  // namespace

double gap_rounding(const Vec2& a, const Vec2& b) {
  constexpr double few_bits = 1e-15;
  return few_bits * std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
}

ContactVelocity contact_velocity(const System& system, const State& state, const Contact& contact) {
  ContactVelocity v;
  if (system.is_cube(contact.on)) {
    const BodyState& b = state[contact.on];
    v.v_k = b.velocity + b.spin * perp(contact.arm_k);
  }
  if (system.is_cube(contact.from)) {
    const BodyState& a = state[contact.from];
    v.v_i = a.velocity + a.spin * perp(contact.arm_i);
    v.v_j = a.velocity + a.spin * perp(contact.arm_j);
  }
  return v;
}

double gap_rate(const Contact& contact, const ContactVelocity& v) {
  return contact.normal.dot(v.v_k - contact.alpha * v.v_j - (1.0 - contact.alpha) * v.v_i);
}

double contact_scale(const System& system, const Contact& contact) {
  return std::min(system.body(contact.on).smaller_side(), system.body(contact.from).smaller_side());
}

ContactMotion contact_motion(const System& system, const State& state, const Contact& contact) {
  const ContactVelocity v = contact_velocity(system, state, contact);
  const double speed = std::max({v.v_i.norm(), v.v_j.norm(), v.v_k.norm()});
  const double fall = std::sqrt(system.gravity.norm() * contact_scale(system, contact));
  const double zero = rate_tolerance * std::max(fall, speed);
  const double rate = gap_rate(contact, v);
  if (rate < -zero) return ContactMotion::closing;
  return rate <= zero ? ContactMotion::resting : ContactMotion::opening;
}

Contact at_poses(const System& system, std::span<const Box> boxes, const Contact& contact) {
  const Box& b = boxes[contact.on];
  const Body& from = system.body(contact.from);
  if (from.kind == BodyKind::plane) {
    return corner_on_plane(contact.on, b, contact.corner, contact.from, from);
  }
  const Box& a = boxes[contact.from];
  return corner_on_side(contact.on, b, contact.corner, contact.from, a, contact.side);
}

void ContactFinder::find(const System& system,
                         const State& state,
                         std::vector<Contact>& contacts,
                         double tolerance) {
  contacts.clear();
  deepest_ = {};
  pose_boxes(system, state, boxes_);
  bounds_.clear();
  int boxes = 0;
  for (; boxes < system.count() && system.body(boxes).kind != BodyKind::plane; ++boxes) {
    const Box& box = boxes_[boxes];
    const Vec2 extent = box.extent()
                        + Vec2::Constant(std::max(tolerance * system.body(boxes).smaller_side(),
                                                  gap_rounding(box.center, box.center)));
    bounds_.push_back({box.center - extent, box.center + extent});
  }
  const auto note = [&](double separation, double scale, int a, int b) {
    if (-separation > deepest_.depth) deepest_ = {-separation, scale, a, b};
  };
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(bounds_)) {
    if (!system.is_cube(pair.first)) continue;
    const double scale =
        std::min(system.body(pair.first).smaller_side(), system.body(pair.second).smaller_side());
    note(add_touching_contacts(system, state, boxes_, pair.first, pair.second, tolerance * scale,
                               contacts),
         scale, pair.first, pair.second);
  }
  for (int p = boxes; p < system.count(); ++p) {
    const Body& plane = system.body(p);
    for (int i = 0; i < system.cubes; ++i) {
      const Box& box = boxes_[i];
      const double scale = system.body(i).smaller_side();
      const double separation = plane_separation(plane.point, plane.normal, box);
      const double touching = std::max(tolerance * scale, gap_rounding(box.center, plane.point));
      if (separation > touching) continue;
      note(separation, scale, i, p);
      add_plane(p, plane, i, box, touching, contacts);
    }
  }
}

}  // namespace wuerfel
