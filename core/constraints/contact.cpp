#include "core/constraints/contact.h"

#include <algorithm>
#include <cmath>

#include "core/constraints/manifold.h"
#include "core/constraints/side.h"

namespace wuerfel {
namespace {

double corner_gap(const Box& b, int k, const Body& plane) {
  return side_gap(plane.normal, (b.center - plane.point) + b.arm[k], 0.0);
}

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
  c.gap = corner_gap(b, k, plane);
  c.alpha = 0.5;
  const Vec2 foot = c.point - c.gap * c.normal;
  c.arm_i = foot + 0.5 * perp(c.normal);
  c.arm_j = foot - 0.5 * perp(c.normal);
  return c;
}

/// Two corners on a plane lie flat on it; more (a box inside of the plane) are touches of their own.
void add_plane_touches(const Touch& touch,
                       int corners,
                       std::vector<Contact>& contacts,
                       std::vector<Touch>& touches) {
  const int each = corners == 2 ? 2 : 1;
  for (int k = 0; k < corners; k += each) {
    touches.push_back(touch);
    touches.back().first = static_cast<int>(contacts.size()) - corners + k;
    touches.back().count = each;
  }
}

}  // namespace

double gap_rounding(const Vec2& a, const Vec2& b) {
  constexpr double few_bits = 1e-15;
  return few_bits * std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
}

double gap_rounding(const State& state) {
  double largest = 0.0;
  for (const BodyState& s : state)
    largest = std::max(largest, gap_rounding(s.position, s.position));
  return largest;
}

std::vector<ContactId> sorted_ids(std::span<const Contact> contacts) {
  std::vector<ContactId> ids(contacts.size());
  std::ranges::transform(contacts, ids.begin(), &Contact::id);
  std::ranges::sort(ids);
  return ids;
}

ContactVelocity contact_velocity(const System& system, const State& state, const Contact& contact) {
  ContactVelocity v;
  if (system.is_cube(contact.on)) v.v_k = point_velocity(state[contact.on], contact.arm_k);
  if (system.is_cube(contact.from)) {
    const BodyState& a = state[contact.from];
    v.v_i = point_velocity(a, contact.arm_i);
    v.v_j = point_velocity(a, contact.arm_j);
  }
  return v;
}

double gap_rate(const Contact& contact, const ContactVelocity& v) {
  return side_gap_rate(contact.normal, contact.alpha, v.v_i, v.v_j, v.v_k);
}

double contact_scale(const System& system, int on, int from) {
  return std::min(system.body(on).smaller_side(), system.body(from).smaller_side());
}

double contact_scale(const System& system, const Contact& contact) {
  return contact_scale(system, contact.on, contact.from);
}

double contact_speed(const System& system, const Contact& contact, const ContactVelocity& v) {
  const double fall = std::sqrt(system.gravity.norm() * contact_scale(system, contact));
  return std::max({fall, v.v_i.norm(), v.v_j.norm(), v.v_k.norm()});
}

ContactMotion contact_motion(const System& system, const State& state, const Contact& contact) {
  const ContactVelocity v = contact_velocity(system, state, contact);
  const double zero = rate_tolerance * contact_speed(system, contact, v);
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

double gap_at_poses(const System& system, std::span<const Box> boxes, const Contact& c) {
  const Box& b = boxes[c.on];
  const Body& from = system.body(c.from);
  if (from.kind == BodyKind::plane) return corner_gap(b, c.corner, from);
  const Box& a = boxes[c.from];
  return side_gap(a.normal(c.side), (b.center - a.center) + b.arm[c.corner], a.reach(c.side));
}

std::vector<Contact> ContactFinder::find(const System& system,
                                         const State& state,
                                         double tolerance) {
  std::vector<Contact> contacts;
  touches_.clear();
  deepest_ = {};
  pose_boxes(system, state, boxes_);
  find_between_boxes(system, state, tolerance, contacts);
  find_on_planes(system, tolerance, contacts);
  if (system.rubs || system.bounces) {
    for (Touch& touch : touches_)
      touch.surface = system.surface(touch.on, touch.from);
  }
  return contacts;
}

void ContactFinder::note(double separation, double scale) {
  if (-separation > deepest_.depth) deepest_ = {-separation, scale};
}

void ContactFinder::find_between_boxes(const System& system,
                                       const State& state,
                                       double tolerance,
                                       std::vector<Contact>& contacts) {
  const auto bounds_of = [&](int i) {
    const Box& box = boxes_[i];
    return posed_bounds(box, std::max(tolerance * system.body(i).smaller_side(),
                                      gap_rounding(box.center, box.center)));
  };
  for (const auto& [i, j] : neighbours_.find(system, bounds_of)) {
    const double scale = contact_scale(system, i, j);
    note(
        add_touching_contacts(system, state, boxes_, {i, j}, tolerance * scale, contacts, touches_),
        scale);
  }
}

void ContactFinder::find_on_planes(const System& system,
                                   double tolerance,
                                   std::vector<Contact>& contacts) {
  for (int p = box_count(system); p < system.count(); ++p) {
    const Body& plane = system.body(p);
    for (int i = 0; i < system.cubes; ++i) {
      const Box& box = boxes_[i];
      const double scale = system.body(i).smaller_side();
      const double separation = plane_separation(plane.point, plane.normal, box);
      const double touching = std::max(tolerance * scale, gap_rounding(box.center, plane.point));
      if (separation > touching) continue;
      note(separation, scale);
      int corners = 0;
      for (int k = 0; k < box.corner_count(); ++k) {
        if (corner_gap(box, k, plane) > touching) continue;
        contacts.push_back(corner_on_plane(i, box, k, p, plane));
        ++corners;
      }
      const Touch touch{Touch::Kind::on_plane, i, p};
      add_plane_touches(touch, corners, contacts, touches_);
    }
  }
}

}  // namespace wuerfel
