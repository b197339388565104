// Numbers beside arrows.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "render/picture/frame_parts.h"
#include "render/picture/units.h"

namespace wuerfel::internal {
namespace {

constexpr int digits = 3;  ///< of the numbers

TextShape number_of(const FrameParts& parts, const PendingArrow& pending) {
  TextShape text;
  // A hair more, so that equal forces are rounded alike: 4.905 N is half-way between two numbers.
  text.text = with_prefix(pending.newton * (1.0 + 1e-9), "N", digits, Zeros::kept);
  text.size = static_cast<float>(0.86 * parts.style.text_size * parts.unit);
  text.color = pending.shape.color;
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
  TextShape text = number_of(parts, pending);
  const std::vector<Pixel> places = places_of(parts, pending, text);
  parts.labels.place(std::move(text), places, parts.font, parts.list);
}

}  // namespace

void add_joint_values(const FrameParts& parts) {
  const ForceScale& scale = parts.options.force_scale;
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    const JointArrow arrow = joint_arrow(parts.snapshot, joint, scale);
    if (!(arrow.length() > 0.0)) continue;
    const ArrowShape shape =
        styled_arrow(parts, parts.pixel(arrow.tail), parts.pixel(arrow.tip), parts.style.contact);
    label_arrow(parts, {shape, ArrowForm::filled, false, joint.force.norm()});
  }
}

void add_values(const FrameParts& parts, const std::vector<PendingArrow>& arrows) {
  for (const PendingArrow& arrow : arrows)
    if (arrow.newton > 0.0) label_arrow(parts, arrow);
}

}  // namespace wuerfel::internal
