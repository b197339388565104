// Numbers beside arrows.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "render/picture/frame_parts.h"
#include "render/picture/units.h"

namespace wuerfel::internal {
namespace {

constexpr int digits = 3;  ///< of the numbers

TextShape number_of(const FrameParts& parts, double newton, Color color) {
  TextShape text;
  // A hair more, so that equal forces are rounded alike: 4.905 N is half-way between two numbers.
  text.text = with_prefix(newton * (1.0 + 1e-9), "N", digits, Zeros::kept);
  text.size = static_cast<float>(0.86 * parts.style.text_size * parts.unit);
  text.color = color;
  text.halo = parts.style.halo;
  text.halo_width = static_cast<float>(2.0 * parts.unit);
  return text;
}

/// Where a number may begin: behind its arrow's tail, right or left of its middle or of its tail; else before its tip,
/// and around its middle. Tails of weights are centres, and what stands behind them would seem to belong to the body.
std::vector<Pixel> places_of(const FrameParts& parts,
                             const PendingArrow& pending,
                             const TextShape& text) {
  const ArrowShape& arrow = pending.shape;
  const auto width =
      static_cast<float>(parts.font.width(text.text, static_cast<double>(text.size)));
  const float gap =
      parts.weight(parts.style.arrow_head_width) * 0.5F + static_cast<float>(4.0 * parts.unit);
  const float down = 0.36F * text.size;
  const Pixel middle{0.5F * (arrow.tail.x + arrow.tip.x), 0.5F * (arrow.tail.y + arrow.tip.y)};
  const float length = std::hypot(arrow.tip.x - arrow.tail.x, arrow.tip.y - arrow.tail.y);
  const Pixel back{(arrow.tail.x - arrow.tip.x) / length, (arrow.tail.y - arrow.tip.y) / length};
  const float away = static_cast<float>(5.0 * parts.unit) + 0.5F * std::abs(back.x) * width
                     + 0.48F * std::abs(back.y) * text.size;
  std::vector<Pixel> places;
  const auto add = [&](Pixel centre, float x, float y) {
    places.push_back({centre.x + x - 0.5F * width, centre.y + y + down});
  };
  if (pending.dot == 0.0) add(arrow.tail, away * back.x, away * back.y);
  const float aside = gap + 0.5F * width;
  for (const Pixel& at : {middle, arrow.tail}) {
    for (const float side : {1.0F, -1.0F})
      add(at, side * aside, 0.0F);
  }
  for (const float ahead : {-away, -1.5F * away})
    add(arrow.tip, ahead * back.x, ahead * back.y);
  for (const float ring : {1.0F, 1.8F, 2.6F}) {
    const float above = ring * (gap + 0.48F * text.size);
    for (const float x : {0.0F, ring * aside, -ring * aside}) {
      for (const float y : {-above, above})
        add(middle, x, y);
    }
  }
  return places;
}

void label_arrow(const FrameParts& parts, const PendingArrow& pending) {
  TextShape text = number_of(parts, pending.newton, pending.shape.color);
  const std::vector<Pixel> places = places_of(parts, pending, text);
  parts.labels.place(std::move(text), places, parts.font, parts.list);
}

/// Beside the dot of a force too small for an arrow.
void label_dot(const FrameParts& parts, const Vec2& at, double newton, Color color) {
  TextShape text = number_of(parts, newton, color);
  const auto width =
      static_cast<float>(parts.font.width(text.text, static_cast<double>(text.size)));
  const Pixel dot = parts.pixel(at);
  const float down = 0.36F * text.size;
  std::vector<Pixel> places;
  for (const float ring : {1.0F, 2.0F}) {
    const float gap = ring * static_cast<float>(7.0 * parts.unit);
    places.push_back({dot.x + gap, dot.y + down});
    places.push_back({dot.x - gap - width, dot.y + down});
    for (const float above : {1.0F, -1.0F})
      places.push_back({dot.x - 0.5F * width, dot.y + down - above * (gap + 0.4F * text.size)});
  }
  parts.labels.place(std::move(text), places, parts.font, parts.list);
}

}  // namespace

void add_dot_values(const FrameParts& parts) {
  constexpr double rounding = 1e-6;  // of the largest force
  const double least = least_arrow(parts);
  if (parts.has(Layer::contact_forces)) {
    double largest = 0.0;
    for (const SnapshotForce& force : parts.snapshot.forces)
      largest = std::max(largest, force.force.norm());
    for (const SnapshotForce& force : parts.snapshot.forces) {
      const double newton = force.force.norm();
      if (newton < least && newton > rounding * largest)
        label_dot(parts, force.point, newton, force_color(parts.style, force.kind));
    }
  }
  if (!parts.has(Layer::weights)) return;
  const auto add = [&](const Vec2& place, double mass) {
    const double newton = mass * parts.snapshot.gravity.norm();
    if (newton > 0.0 && newton < least) label_dot(parts, place, newton, parts.style.own_weight);
  };
  for (const SnapshotBox& box : parts.snapshot.boxes)
    if (!box.fixed) add(box.center, box.mass);
  for (const SnapshotMass& mass : parts.snapshot.masses)
    add(mass.position, mass.mass);
}

// Behind the pressure on a face; at a corner, which shows no pressure, beside it.
void add_joint_values(const FrameParts& parts) {
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    const double newton = joint.force.norm();
    if (!(newton * parts.options.force_scale.metres_per_newton > 0.0)) continue;
    const double depth = pressure_depth(parts, joint);
    if (joint.from == joint.to || !(depth > 0.0)) {
      label_dot(parts, joint.point, newton, parts.style.contact);
      continue;
    }
    const ArrowShape shape = styled_arrow(parts, parts.pixel(joint.point - depth * joint.normal),
                                          parts.pixel(joint.point), parts.style.contact);
    label_arrow(parts, {shape, ArrowForm::filled, false, newton});
  }
}

void add_values(const FrameParts& parts, const std::vector<PendingArrow>& arrows) {
  for (const PendingArrow& arrow : arrows)
    if (arrow.newton > 0.0) label_arrow(parts, arrow);
}

}  // namespace wuerfel::internal
