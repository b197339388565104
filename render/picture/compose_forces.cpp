// Forces: what bodies do to each other at the faces by which they touch; the same corner by corner;
// weights; pressure, impacts.
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/picture/frame_parts.h"
#include "render/picture/impacts.h"

namespace wuerfel::internal {
namespace {

constexpr double tooth_spacing = 7.0;   ///< of the comb that shows a pressure
constexpr double pressure_share = 0.3;  ///< of an arrow's length, that an even pressure is deep
constexpr double deepest = 0.45;        ///< m of pressure per m of typical arrow limit
constexpr double readable_cut_arrow = 24.0;  ///< px, for a head and the sign of the cut

Color joint_color(const FrameParts& parts) { return parts.style.contact; }

bool contains(const SnapshotBox& box, const Vec2& place) {
  const Vec2 along = axis_of(box);
  const Vec2 from_center = place - box.center;
  return std::abs(from_center.dot(along)) < 0.5 * box.size.x()
         && std::abs(from_center.dot(perp(along))) < 0.5 * box.size.y();
}

/// An arrow cut by a thin body that pushes, too short to be read, begins behind that body where
/// nothing else is.
JointArrow readable(const FrameParts& parts, const SnapshotJoint& joint, const JointArrow& arrow) {
  const ForceScale& scale = parts.options.force_scale;
  const double force = joint.force.norm();
  const double full = std::min(scale.metres_per_newton * force, scale.longest);
  const double length =
      std::min(full, parts.metres(readable_cut_arrow * parts.unit * parts.fineness));
  if (!arrow.cut || !(arrow.length() < length)) return arrow;
  const Vec2 tail = joint.point - length / force * joint.force;
  const auto is_free = [&](const Vec2& place) {
    for (int k = 0; k < static_cast<int>(parts.snapshot.boxes.size()); ++k)
      if (k != joint.other && contains(parts.snapshot.boxes[k], place)) return false;
    return true;
  };
  if (!is_free(tail) || !is_free(0.5 * (tail + arrow.tail))) return arrow;
  return {tail, arrow.tip, length < scale.metres_per_newton * force * (1.0 - 1e-6)};
}

/// A pressure along a face, from one end to the other: N/m at both. Where the resultant lies outside
/// the middle third only a part of the face is pressed, and the pressure is a triangle.
struct Pressure {
  Vec2 from;
  Vec2 to;
  double at_from;
  double at_to;
};

Pressure pressure_of(const SnapshotJoint& joint) {
  const double length = (joint.to - joint.from).norm();
  const double force = joint.force.dot(joint.normal);
  if (!(length > 0.0)) return {joint.point, joint.point, 0.0, 0.0};
  const Vec2 along = (joint.to - joint.from) / length;
  const double e = (joint.point - joint.from).dot(along) - 0.5 * length;  // from the middle
  if (6.0 * std::abs(e) <= length) {
    const double mean = force / length;
    return {joint.from, joint.to, mean * (1.0 - 6.0 * e / length), mean * (1.0 + 6.0 * e / length)};
  }
  const double pressed = 3.0 * (0.5 * length - std::abs(e));
  if (!(pressed > 1e-3 * length)) return {joint.point, joint.point, 0.0, 0.0};
  const double peak = 2.0 * force / pressed;
  if (e > 0.0) return {joint.to - pressed * along, joint.to, 0.0, peak};
  return {joint.from, joint.from + pressed * along, peak, 0.0};
}

/// m, how deep a pressure of so many N/m is drawn: an even pressure of a typical force is about as deep as a part of
/// that force's arrow is long.
double depth_of(const FrameParts& parts, const SnapshotJoint& joint, double pressure) {
  const ForceScale& scale = parts.options.force_scale;
  const double full =
      pressure_share * scale.metres_per_newton * (joint.to - joint.from).norm() * pressure;
  return std::min(deepest * scale.longest / 0.8, full);
}

/// Strokes from the face into the body that pushes, and a line along their ends.
void add_comb(const FrameParts& parts, const SnapshotJoint& joint, const Pressure& p) {
  const double length = (p.to - p.from).norm();
  const auto end = [&](double share) {
    const double depth = depth_of(parts, joint, p.at_from + share * (p.at_to - p.at_from));
    return parts.pixel(p.from + share * (p.to - p.from) - depth * joint.normal);
  };
  const auto start = [&](double share) { return parts.pixel(p.from + share * (p.to - p.from)); };
  SegmentShape tooth;
  tooth.half_width = 0.5F * parts.weight(1.0);
  tooth.color = with_alpha(joint_color(parts), 0.75);
  const int count = std::max(
      2, static_cast<int>(length * parts.view.pixels_per_metre / (tooth_spacing * parts.unit)));
  for (int i = 0; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    tooth.from = start(share);
    tooth.to = end(share);
    parts.list.add(tooth);
    if (i == 0) continue;
    SegmentShape rim = tooth;
    rim.half_width = 0.5F * parts.weight(1.6);
    rim.from = end(static_cast<double>(i - 1) / count);
    parts.list.add(rim);
  }
}

}  // namespace

double least_arrow(const FrameParts& parts) {
  const ForceScale& scale = parts.options.force_scale;
  const double pixels_per_newton = scale.metres_per_newton * parts.view.pixels_per_metre;
  return std::max(scale.hidden_below,
                  shortest_force_arrow * parts.unit * parts.fineness / pixels_per_newton);
}

void add_dot(const FrameParts& parts, Pixel place, Color color, double radius) {
  DiscShape dot;
  dot.center = place;
  dot.outline_width = parts.style.halo.a > 0 ? parts.weight(1.0) : 0.0F;
  dot.radius = std::max(parts.weight(radius), 0.8F) + dot.outline_width;
  dot.fill = color;
  dot.outline = parts.style.halo;
  parts.list.add(dot);
}

void add_joint_arrows(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const double least = least_arrow(parts);
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    const JointArrow arrow =
        readable(parts, joint, joint_arrow(parts.snapshot, joint, parts.options.force_scale));
    const bool room = arrow.length() * parts.view.pixels_per_metre
                      >= 0.5 * shortest_force_arrow * parts.unit * parts.fineness;
    if (joint.force.norm() < least || !room) {
      add_dot(parts, parts.pixel(joint.point), joint_color(parts), force_dot);
      continue;
    }
    arrows.push_back(
        {styled_arrow(parts, parts.pixel(arrow.tail), parts.pixel(arrow.tip), joint_color(parts)),
         joint.unique ? ArrowForm::filled : ArrowForm::hollow, arrow.cut, joint.force.norm()});
  }
}

void add_contact_arrows(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const ForceScale& scale = parts.options.force_scale;
  const double least = least_arrow(parts);
  for (const SnapshotForce& force : parts.snapshot.forces) {
    const double magnitude = force.force.norm();
    const Color color = force_color(parts.style, force.kind);
    if (magnitude < least) {
      add_dot(parts, parts.pixel(force.point), color, force_dot);
      continue;
    }
    const double full = magnitude * scale.metres_per_newton;
    const Vec2 arrow = std::min(full, scale.longest) / magnitude * force.force;
    const ArrowForm form = force.kind == ForceKind::friction ? ArrowForm::half
                           : force.unique                    ? ArrowForm::filled
                                                             : ArrowForm::hollow;
    // From the place where it acts into the body.
    const Vec2 tail = force.point;
    arrows.push_back({styled_arrow(parts, parts.pixel(tail), parts.pixel(tail + arrow), color),
                      form, scale.cuts(magnitude), magnitude});
  }
}

void add_weights(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const ForceScale& scale = parts.options.force_scale;
  const double least = least_arrow(parts);
  const auto add = [&](const Vec2& place, double mass) {
    const Vec2 weight = mass * parts.snapshot.gravity;
    const double magnitude = weight.norm();
    if (!(magnitude > 0.0)) return;
    const double full = magnitude * scale.metres_per_newton;
    const Pixel center = parts.pixel(place);
    if (magnitude < least) return add_dot(parts, center, parts.style.own_weight, force_dot);
    const Vec2 tip = place + std::min(full, scale.longest) / magnitude * weight;
    arrows.push_back({styled_arrow(parts, center, parts.pixel(tip), parts.style.own_weight),
                      ArrowForm::filled, scale.cuts(magnitude), magnitude, force_dot});
  };
  for (const SnapshotBox& box : parts.snapshot.boxes)
    if (!box.fixed) add(box.center, box.mass);
  for (const SnapshotMass& mass : parts.snapshot.masses)
    add(mass.position, mass.mass);
}

double pressure_depth(const FrameParts& parts, const SnapshotJoint& joint) {
  const Pressure pressure = pressure_of(joint);
  return depth_of(parts, joint, std::max(pressure.at_from, pressure.at_to));
}

void add_pressure(const FrameParts& parts) {
  if (parts.options.force_scale.metres_per_newton <= 0.0) return;
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    const Pressure pressure = pressure_of(joint);
    if (pressure.at_from + pressure.at_to > 0.0) add_comb(parts, joint, pressure);
  }
}

// Rings that grow and fade; their size tells the impulse.
void add_impacts(const FrameParts& parts) {
  const RingScale scale = ring_scale(parts.snapshot);
  for (const SnapshotImpact& impact : parts.snapshot.impacts) {
    if (!scale.has_ring(impact)) continue;
    const double share = std::min(scale.share(impact), 4.0);
    DiscShape ring;
    ring.center = parts.pixel(impact.point);
    ring.radius = parts.weight((4.0 + 9.0 * std::sqrt(share)) * (0.5 + 0.5 * impact.age));
    ring.outline_width = parts.weight(1.0 + 2.0 * (1.0 - impact.age));
    ring.fill = with_alpha(parts.style.contact, 0.25 * (1.0 - impact.age));
    ring.outline = with_alpha(parts.style.contact, 0.9 * (1.0 - impact.age));
    parts.list.add(ring);
  }
}

}  // namespace wuerfel::internal
