// Arrows of every kind, and how they are painted. Kinds differ by form as well as by colour.
#include <algorithm>
#include <array>
#include <cmath>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

constexpr double normal_length = 26.0;  ///< px of a 1280x720 picture
constexpr double hollow_rim = 1.25;     ///< px, of the outline of a hollow arrow
constexpr double hollow_width = 5.0;    ///< px, of its shaft
constexpr double hollow_head = 1.2;     ///< times the width of a filled one's head
constexpr double break_at = 0.3;        ///< of a cut arrow's shaft, from its tail
constexpr double break_gap = 5.0;       ///< px between the strokes of a break
constexpr double break_reach = 5.5;     ///< px that they reach to each side
constexpr float longest_head = 1.35F;   ///< of all forms, of a filled one's: two open ones
constexpr float widest_head = 1.25F;    ///< half a head

/// A place on an arrow: `along` px from its tail, `across` to its left as seen on the screen.
class Frame {
 public:
  explicit Frame(const ArrowShape& arrow) : tail_(arrow.tail) {
    length_ = std::hypot(arrow.tip.x - arrow.tail.x, arrow.tip.y - arrow.tail.y);
    axis_ = {(arrow.tip.x - arrow.tail.x) / length_, (arrow.tip.y - arrow.tail.y) / length_};
  }
  [[nodiscard]] float length() const { return length_; }
  [[nodiscard]] Pixel at(float along, float across) const {
    return {tail_.x + along * axis_.x + across * axis_.y,
            tail_.y + along * axis_.y - across * axis_.x};
  }

 private:
  Pixel tail_;
  Pixel axis_;
  float length_ = 0.0F;
};

void add_stroke(const ArrowShape& arrow, Pixel from, Pixel to, DrawList& list) {
  list.add(SegmentShape{from, to, arrow.half_width + arrow.grow, 1.0F, arrow.color});
}

/// A head of two strokes, with its point `back` px behind the tip.
void add_open_head(const ArrowShape& arrow, const Frame& frame, float back, DrawList& list) {
  const Pixel point = frame.at(frame.length() - back - arrow.half_width, 0.0F);
  const float foot = frame.length() - back - 0.8F * arrow.head_length;
  for (const float side : {1.0F, -1.0F})
    add_stroke(arrow, frame.at(foot, side * 0.8F * arrow.head_half_width), point, list);
}

void add_open(const ArrowShape& arrow, int heads, DrawList& list) {
  const Frame frame(arrow);
  add_stroke(arrow, arrow.tail, frame.at(frame.length() - arrow.half_width, 0.0F), list);
  for (int k = 0; k < heads; ++k)
    add_open_head(arrow, frame, static_cast<float>(k) * 0.55F * arrow.head_length, list);
}

/// Half a head, on the left of the shaft.
void add_half(const ArrowShape& arrow, DrawList& list) {
  const Frame frame(arrow);
  const float base = frame.length() - 1.15F * arrow.head_length;
  add_stroke(arrow, arrow.tail, frame.at(frame.length() - arrow.half_width, 0.0F), list);
  const float reach = arrow.half_width + arrow.grow;
  TriangleShape head;
  head.a = frame.at(frame.length() + 1.5F * arrow.grow, -reach);
  head.b = frame.at(base - arrow.grow, -reach);
  head.c = frame.at(base - arrow.grow, 1.25F * arrow.head_half_width + 1.5F * arrow.grow);
  head.fill = head.outline = arrow.color;
  list.add(head);
}

/// A shaft of dashes, and a filled head.
void add_dashed(const ArrowShape& arrow, DrawList& list) {
  const Frame frame(arrow);
  const float shaft = frame.length() - arrow.head_length;
  const float dash = std::max(3.0F * arrow.half_width, 2.0F);
  for (float at = 0.0F; at < shaft - 0.5F * dash; at += 2.2F * dash)
    add_stroke(arrow, frame.at(at, 0.0F), frame.at(std::min(at + dash, shaft), 0.0F), list);
  ArrowShape head = arrow;
  head.tail = frame.at(shaft, 0.0F);
  list.add(head);
}

/// The inside of a hollow arrow: all of its outline moved inwards by the rim.
ArrowShape inside_of(const FrameParts& parts, const ArrowShape& arrow) {
  const Frame frame(arrow);
  const float head = arrow.head_length;
  const float wing = arrow.head_half_width;
  const float notch = 0.25F * head;
  const float slant = std::hypot(wing, head);
  // A corner of the head moves inwards by so many rims; at least half of a small head stays hollow.
  const float corner = (slant + std::hypot(wing, notch)) / (head - notch);
  const float rim = std::min(std::max(parts.weight(hollow_rim), 0.7F), 0.5F * wing / corner);
  ArrowShape inside = arrow;
  inside.tail = frame.at(rim, 0.0F);
  inside.tip = frame.at(frame.length() - rim * slant / wing, 0.0F);
  inside.half_width = std::max(arrow.half_width - rim, 0.0F);
  inside.head_half_width = wing - rim * corner;
  inside.head_length = head * inside.head_half_width / wing;
  inside.color = with_alpha(parts.style.halo, 1.0);
  return inside;
}

ArrowShape widened(const FrameParts& parts, ArrowShape arrow) {
  const float wider = std::max(0.5F * parts.weight(hollow_width), 1.2F);
  arrow.half_width = std::max(arrow.half_width, std::min(wider, 0.6F * arrow.head_half_width));
  arrow.head_half_width *= static_cast<float>(hollow_head);
  return arrow;
}

/// The sign of a broken axis across the shaft: what is drawn is not all of it.
void add_break(const FrameParts& parts, const ArrowShape& arrow) {
  const Frame frame(arrow);
  const float gap = 0.5F * parts.weight(break_gap);
  const float reach = parts.weight(break_reach);
  const float place = static_cast<float>(break_at) * (frame.length() - arrow.head_length);
  const auto stroke = [&](float along, float half_width, Color color) {
    parts.list.add(SegmentShape{frame.at(along - 0.45F * reach, -reach),
                                frame.at(along + 0.45F * reach, reach), half_width, 0.0F, color});
  };
  stroke(place, gap, with_alpha(parts.style.halo, 1.0));
  for (const float side : {-1.0F, 1.0F})
    stroke(place + side * gap, std::max(0.5F * parts.weight(1.5), 0.4F), arrow.color);
}

void paint(const FrameParts& parts, const PendingArrow& arrow, const ArrowShape& shape) {
  switch (arrow.form) {
    case ArrowForm::open:
      return add_open(shape, 1, parts.list);
    case ArrowForm::twice:
      return add_open(shape, 2, parts.list);
    case ArrowForm::half:
      return add_half(shape, parts.list);
    case ArrowForm::dashed:
      return add_dashed(shape, parts.list);
    case ArrowForm::hollow:
    case ArrowForm::filled:
      return parts.list.add(shape);
  }
}

}  // namespace

ArrowShape styled_arrow(const FrameParts& parts, Pixel tail, Pixel tip, Color color) {
  ArrowShape arrow;
  arrow.tail = tail;
  arrow.tip = tip;
  arrow.color = color;
  const float length = std::hypot(tip.x - tail.x, tip.y - tail.y);
  const float full_head = parts.weight(parts.style.arrow_head_length);
  const float shrink = std::min(1.0F, length / (1.35F * full_head));
  arrow.half_width =
      std::max(0.5F * parts.weight(parts.style.arrow_width) * std::sqrt(shrink), 0.5F);
  arrow.head_length = full_head * shrink;
  arrow.head_half_width = 0.5F * parts.weight(parts.style.arrow_head_width) * shrink;
  arrow.head_half_width = std::max(arrow.head_half_width, 1.4F * arrow.half_width);
  return arrow;
}

void paint_arrows(const FrameParts& parts, const std::vector<PendingArrow>& arrows) {
  const auto shape_of = [&parts](const PendingArrow& arrow) {
    return arrow.form == ArrowForm::hollow ? widened(parts, arrow.shape) : arrow.shape;
  };
  if (parts.style.halo.a > 0) {
    for (const PendingArrow& arrow : arrows) {
      ArrowShape halo = shape_of(arrow);
      halo.grow = parts.weight(parts.style.halo_width);
      halo.color = parts.style.halo;
      paint(parts, arrow, halo);
    }
  }
  for (const PendingArrow& arrow : arrows) {
    const ArrowShape shape = shape_of(arrow);
    if (arrow.dot > 0.0) add_dot(parts, shape.tail, shape.color, arrow.dot);
    paint(parts, arrow, shape);
    if (arrow.form == ArrowForm::hollow) parts.list.add(inside_of(parts, shape));
    if (arrow.cut) add_break(parts, shape);
  }
}

void paint_normal(const FrameParts& parts, Pixel tail, Pixel tip) {
  ArrowShape arrow = styled_arrow(parts, tail, tip, parts.style.normal);
  arrow.half_width *= 0.45F;
  arrow.head_length *= 0.7F;
  arrow.head_half_width *= 0.7F;
  add_open(arrow, 1, parts.list);
}

Vec2 normal_tip(const FrameParts& parts, const SnapshotContact& contact) {
  const double length = shows_symbols(parts) ? 2.0 * normal_length : normal_length;
  return contact.p_k + parts.metres(length * parts.unit * parts.fineness) * contact.normal;
}

void add_normals(const FrameParts& parts) {
  for (const SnapshotContact& contact : parts.snapshot.contacts)
    paint_normal(parts, parts.pixel(contact.p_k), parts.pixel(normal_tip(parts, contact)));
}

std::vector<PendingArrow> add_arrows(const FrameParts& parts) {
  std::vector<PendingArrow> arrows;
  add_motion_arrows(parts, arrows);
  if (parts.options.force_scale.metres_per_newton > 0.0) {
    if (parts.has(Layer::weights)) add_weights(parts, arrows);
    if (parts.has(Layer::contact_forces)) add_contact_arrows(parts, arrows);
    if (parts.has(Layer::forces) && !is_crowd(parts.snapshot)) add_joint_arrows(parts, arrows);
  }
  paint_arrows(parts, arrows);
  for (const PendingArrow& arrow : arrows) {
    const ArrowShape& shape = arrow.shape;
    const Frame frame(shape);
    // Strokes are as wide beyond their ends.
    const float head = widest_head * shape.head_half_width;
    const float start = frame.length() - longest_head * shape.head_length + head;
    const Pixel neck = frame.at(std::clamp(start, 0.0F, frame.length()), 0.0F);
    parts.labels.keep_off(shape.tail, neck, static_cast<double>(shape.half_width));
    parts.labels.keep_off(neck, shape.tip, static_cast<double>(head));
  }
  return arrows;
}

}  // namespace wuerfel::internal
