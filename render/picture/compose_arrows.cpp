// Arrows: forces, velocities, normals. An arrow of a force starts at the contact and points where
// the force pushes.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

constexpr double normal_length = 30.0;   ///< px of a 1280x720 picture
constexpr double shortest_arrow = 3.0;   ///< px; what is shorter says nothing
constexpr double second_head_at = 0.75;  ///< head lengths behind the first

/// A little step (m) from the contact towards the pushed body, across the arrow, so that the arrows
/// of two cubes that stand side by side lie side by side too.
Vec2 step_aside(const FrameParts& parts, const SnapshotForce& force) {
  const auto& boxes = parts.snapshot.boxes;
  if (force.body < 0 || static_cast<std::size_t>(force.body) >= boxes.size()) return Vec2::Zero();
  const SnapshotBox& box = boxes[force.body];
  const Vec2 across = perp(force.force).normalized();
  const double offset = (box.center - force.point).dot(across);
  const double wanted = (0.5 * parts.style.arrow_width + parts.style.halo_width + 0.3) * parts.unit
                        * parts.fineness / parts.view.pixels_per_metre;
  return std::clamp(offset, -wanted, wanted) * across;
}

void add_forces(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const ForceScale& scale = parts.options.force_scale;
  if (scale.metres_per_newton <= 0.0) return;
  for (const SnapshotForce& force : parts.snapshot.forces) {
    const double magnitude = force.force.norm();
    const double full = magnitude * scale.metres_per_newton;
    const double length = std::min(full, scale.longest);
    if (!(magnitude > scale.hidden_below)
        || length * parts.view.pixels_per_metre < shortest_arrow * parts.unit) {
      continue;
    }
    const Vec2 tail = force.point + step_aside(parts, force);
    const Vec2 tip = tail + length / magnitude * force.force;
    arrows.push_back({styled_arrow(parts, parts.pixel(tail), parts.pixel(tip),
                                   force_color(parts.style, force.kind)),
                      full > scale.longest});
  }
}

void add_velocities(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  for (const SnapshotBox& box : parts.snapshot.boxes) {
    const Vec2 tip = box.center + parts.options.metres_per_speed * box.velocity;
    if ((tip - box.center).norm() * parts.view.pixels_per_metre < shortest_arrow * parts.unit)
      continue;
    arrows.push_back(
        {styled_arrow(parts, parts.pixel(box.center), parts.pixel(tip), parts.style.velocity)});
  }
}

void add_normals(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const double length = normal_length * parts.unit * parts.fineness / parts.view.pixels_per_metre;
  for (const SnapshotContact& contact : parts.snapshot.contacts) {
    ArrowShape arrow =
        styled_arrow(parts, parts.pixel(contact.p_k),
                     parts.pixel(contact.p_k + length * contact.normal), parts.style.normal);
    arrow.half_width *= 0.7F;
    arrows.push_back({arrow});
  }
}

/// The head alone, behind the first one: this force is longer than it is drawn.
ArrowShape second_head(const ArrowShape& arrow) {
  const float dx = arrow.tip.x - arrow.tail.x;
  const float dy = arrow.tip.y - arrow.tail.y;
  const float back = static_cast<float>(second_head_at) * arrow.head_length / std::hypot(dx, dy);
  ArrowShape head = arrow;
  head.tip = {arrow.tip.x - back * dx, arrow.tip.y - back * dy};
  return head;
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
  if (parts.style.halo.a > 0) {
    for (const PendingArrow& arrow : arrows) {
      ArrowShape halo = arrow.shape;
      halo.grow = parts.weight(parts.style.halo_width);
      halo.color = parts.style.halo;
      parts.list.add(halo);
      if (arrow.capped) parts.list.add(second_head(halo));
    }
  }
  for (const PendingArrow& arrow : arrows) {
    parts.list.add(arrow.shape);
    if (arrow.capped) parts.list.add(second_head(arrow.shape));
  }
}

void add_arrows(const FrameParts& parts) {
  std::vector<PendingArrow> arrows;
  if (parts.has(Layer::normals)) add_normals(parts, arrows);
  if (parts.has(Layer::velocities)) add_velocities(parts, arrows);
  if (parts.has(Layer::forces)) add_forces(parts, arrows);
  paint_arrows(parts, arrows);
}

}  // namespace wuerfel::internal
