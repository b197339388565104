// Forces: what bodies do to each other at the faces by which they touch; the same corner by corner;
// weights; pressure, lines of thrust, chains of forces, impacts.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "render/picture/frame_parts.h"
#include "render/picture/units.h"

namespace wuerfel::internal {
namespace {

constexpr double tooth_spacing = 7.0;   ///< of the comb that shows a pressure
constexpr double pressure_share = 0.3;  ///< of an arrow's length, that an even pressure is deep
constexpr double deepest = 0.45;        ///< m of pressure per m of typical arrow limit
constexpr double dash = 8.0;
constexpr double dash_gap = 5.0;
constexpr double widest_chain = 0.3;  ///< of the side of a typical cube
constexpr int digits = 3;             ///< of numbers beside arrows

Color joint_color(const FrameParts& parts) { return parts.style.contact; }

/// A number beside an arrow: right or left of its middle, of its tail, or behind that.
void label_arrow(const FrameParts& parts, const ArrowShape& arrow, double newton) {
  TextShape text;
  text.text = with_prefix(newton, "N", digits);
  text.size = static_cast<float>(0.86 * parts.style.text_size * parts.unit);
  text.color = arrow.color;
  text.halo = parts.style.halo;
  text.halo_width = static_cast<float>(2.0 * parts.unit);
  const auto width =
      static_cast<float>(parts.font.width(text.text, static_cast<double>(text.size)));
  const float gap =
      parts.weight(parts.style.arrow_head_width) * 0.5F + static_cast<float>(4.0 * parts.unit);
  const float down = 0.36F * text.size;
  const float x = arrow.tail.x;
  const float middle = 0.5F * (arrow.tail.y + arrow.tip.y) + down;
  const float tail = arrow.tail.y + down;
  const float mean = 0.5F * (arrow.tail.x + arrow.tip.x);
  const std::array<Pixel, 6> places{{{mean + gap, middle},
                                     {mean - gap - width, middle},
                                     {x + gap, tail},
                                     {x - gap - width, tail},
                                     {x - 0.5F * width, arrow.tail.y + 1.2F * text.size},
                                     {x - 0.5F * width, arrow.tip.y - 0.4F * text.size}}};
  parts.labels.place(std::move(text), places, parts.font, parts.list);
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

/// Strokes from the face into the body that pushes, and a line along their ends.
void add_comb(const FrameParts& parts, const SnapshotJoint& joint, const Pressure& p) {
  const double length = (p.to - p.from).norm();
  const double limit = deepest * parts.options.force_scale.longest / 0.8;
  // An even pressure of a typical force is about as deep as a part of that force's arrow is long.
  const double scale =
      pressure_share * parts.options.force_scale.metres_per_newton * (joint.to - joint.from).norm();
  const auto end = [&](double share) {
    const double depth = std::min(limit, scale * (p.at_from + share * (p.at_to - p.at_from)));
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

void add_dashes(const FrameParts& parts, const Vec2& from, const Vec2& to) {
  SegmentShape stroke;
  stroke.half_width = 0.5F * parts.weight(2.6);
  stroke.round = 0.0F;
  stroke.color = parts.style.thrust;
  const double length = (to - from).norm();
  const double period = parts.metres((dash + dash_gap) * parts.unit);
  const double drawn = parts.metres(dash * parts.unit);
  for (int k = 0; k * period < length && k < 1000; ++k) {
    const double end = std::min(k * period + drawn, length);
    stroke.from = parts.pixel(from + k * period / length * (to - from));
    stroke.to = parts.pixel(from + end / length * (to - from));
    parts.list.add(stroke);
  }
}

/// The joints of a box: those that carry it, and those by which it carries.
struct Loads {
  std::vector<const SnapshotJoint*> below;
  std::vector<const SnapshotJoint*> above;
};

std::vector<Loads> loads_of_boxes(const Snapshot& snapshot) {
  std::vector<Loads> of(snapshot.boxes.size());
  for (const SnapshotJoint& joint : snapshot.joints) {
    if (joint.body >= 0) of[joint.body].below.push_back(&joint);
    if (joint.other >= 0 && joint.other < std::ssize(of)) of[joint.other].above.push_back(&joint);
  }
  return of;
}

/// Where the forces of a box meet: at the centre of one that carries nothing, else in their middle.
Vec2 hub(const SnapshotBox& box, const Loads& of) {
  if (of.above.empty()) return box.center;
  Vec2 sum = Vec2::Zero();
  double total = 0.0;
  for (const auto* side : {&of.above, &of.below}) {
    for (const SnapshotJoint* joint : *side) {
      sum += joint->force.norm() * joint->point;
      total += joint->force.norm();
    }
  }
  return sum / total;
}

/// Whether the resultant acts at an end of the face: the body is about to turn about it.
bool is_hinge(const SnapshotJoint& joint) {
  constexpr double share = 5e-3;
  const double nearest =
      std::min((joint.point - joint.from).norm(), (joint.point - joint.to).norm());
  return nearest <= share * (joint.to - joint.from).norm();
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
  dot.radius = std::max(parts.weight(radius), 0.8F);
  dot.fill = color;
  parts.list.add(dot);
}

void add_joint_arrows(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const double least = least_arrow(parts);
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    const JointArrow arrow = joint_arrow(parts.snapshot, joint, parts.options.force_scale);
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
                      form, full > scale.longest, magnitude});
  }
}

void add_weights(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const ForceScale& scale = parts.options.force_scale;
  const double least = least_arrow(parts);
  for (const SnapshotBox& box : parts.snapshot.boxes) {
    const Vec2 weight = box.mass * parts.snapshot.gravity;
    const double magnitude = weight.norm();
    if (box.fixed || !(magnitude > 0.0)) continue;
    const double full = magnitude * scale.metres_per_newton;
    const Pixel center = parts.pixel(box.center);
    add_dot(parts, center, parts.style.own_weight, magnitude < least ? force_dot : 1.4 * force_dot);
    if (magnitude < least) continue;
    const Vec2 tip = box.center + std::min(full, scale.longest) / magnitude * weight;
    arrows.push_back({styled_arrow(parts, center, parts.pixel(tip), parts.style.own_weight),
                      ArrowForm::filled, full > scale.longest, magnitude});
  }
}

void add_pressure(const FrameParts& parts) {
  if (parts.options.force_scale.metres_per_newton <= 0.0) return;
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    const Pressure pressure = pressure_of(joint);
    if (pressure.at_from + pressure.at_to > 0.0) add_comb(parts, joint, pressure);
  }
}

void add_thrust(const FrameParts& parts) {
  const std::vector<Loads> of = loads_of_boxes(parts.snapshot);
  for (std::size_t i = 0; i < of.size(); ++i) {
    const auto& [below, above] = of[i];
    if (below.empty()) continue;
    if (below.size() == 1 && above.size() == 1) {
      add_dashes(parts, above.front()->point, below.front()->point);
      continue;
    }
    const Vec2 middle = hub(parts.snapshot.boxes[i], of[i]);
    for (const auto* side : {&above, &below})
      for (const SnapshotJoint* joint : *side)
        add_dashes(parts, joint->point, middle);
  }
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    if (!is_hinge(joint)) continue;
    DiscShape hinge;
    hinge.center = parts.pixel(joint.point);
    hinge.radius = parts.weight(5.0);
    hinge.outline_width = parts.weight(2.2);
    hinge.fill = with_alpha(parts.style.joint, 1.0);
    hinge.outline = parts.style.thrust;
    parts.list.add(hinge);
  }
}

void add_chains(const FrameParts& parts) {
  const ForceScale& scale = parts.options.force_scale;
  SegmentShape chain;
  chain.color = with_alpha(parts.style.chain, 0.85);
  const auto& boxes = parts.snapshot.boxes;
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    const double length = std::min(scale.metres_per_newton * joint.force.norm(), scale.longest);
    const double width = widest_chain * length * parts.view.pixels_per_metre;
    if (width < 0.25) continue;
    chain.half_width = static_cast<float>(0.5 * width);
    const Pixel place = parts.pixel(joint.point);
    const bool box = joint.other >= 0 && joint.other < std::ssize(boxes);
    const Vec2 other =
        box ? boxes[joint.other].center
            : Vec2(joint.point - 0.4 * boxes[joint.body].size.minCoeff() * joint.normal);
    for (const Pixel end : {parts.pixel(boxes[joint.body].center), parts.pixel(other)}) {
      chain.from = place;
      chain.to = end;
      parts.list.add(chain);
    }
  }
}

// Rings that grow and fade; their size tells the impulse, as a share of what a cube gets that falls
// from the height of one side.
void add_impacts(const FrameParts& parts) {
  double mass = 0.0;
  double side = 0.0;
  int count = 0;
  for (const SnapshotBox& box : parts.snapshot.boxes) {
    if (box.fixed) continue;
    mass += box.mass;
    side += std::sqrt(box.size.x() * box.size.y());
    ++count;
  }
  const double gravity = parts.snapshot.gravity.norm();
  const double typical = count == 0 ? 0.0 : mass / count * std::sqrt(2.0 * gravity * side / count);
  for (const SnapshotImpact& impact : parts.snapshot.impacts) {
    const double share = typical > 0.0 ? std::min(impact.impulse / typical, 4.0) : 1.0;
    if (share < 0.05) continue;
    DiscShape ring;
    ring.center = parts.pixel(impact.point);
    ring.radius = parts.weight((4.0 + 9.0 * std::sqrt(share)) * (0.5 + 0.5 * impact.age));
    ring.outline_width = parts.weight(1.0 + 2.0 * (1.0 - impact.age));
    ring.fill = with_alpha(parts.style.contact, 0.25 * (1.0 - impact.age));
    ring.outline = with_alpha(parts.style.contact, 0.9 * (1.0 - impact.age));
    parts.list.add(ring);
  }
}

void add_values(const FrameParts& parts, const std::vector<PendingArrow>& arrows) {
  for (const PendingArrow& arrow : arrows)
    if (arrow.newton > 0.0) label_arrow(parts, arrow.shape, arrow.newton);
}

}  // namespace wuerfel::internal
