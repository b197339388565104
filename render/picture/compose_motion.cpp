// Arrows of velocities and accelerations.
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

constexpr double center_dot = 2.6;      ///< px, where velocities start
constexpr double same_way = 0.2;        ///< slope of two arrows that cover each other
constexpr double two_heads = 24.0;      ///< px, beside each other
constexpr double shortest_arrow = 3.0;  ///< px; what is shorter says nothing

/// From a dot, so that it is seen where it belongs to.
void add_vector(const FrameParts& parts,
                const Vec2& from,
                const Vec2& vector,
                ArrowForm form,
                Color color,
                std::vector<PendingArrow>& arrows,
                double dot = 0.0) {
  const Vec2 tip = from + vector;
  if (vector.norm() * parts.view.pixels_per_metre < shortest_arrow * parts.unit) return;
  arrows.push_back(
      {styled_arrow(parts, parts.pixel(from), parts.pixel(tip), color), form, false, 0.0, dot});
}

void add_velocities(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const auto add = [&](const Vec2& place, const Vec2& velocity) {
    add_vector(parts, place, parts.options.metres_per_speed * velocity, ArrowForm::open,
               parts.style.velocity, arrows, center_dot);
  };
  if (shows_symbols(parts)) {
    for (const SnapshotContact& contact : parts.snapshot.contacts) {
      add(contact.p_i, contact.v_i);
      add(contact.p_j, contact.v_j);
      add(contact.p_k, contact.v_k);
    }
    return;
  }
  for (const SnapshotBox& box : parts.snapshot.boxes)
    add(box.center, box.velocity);
  for (const SnapshotMass& mass : parts.snapshot.masses)
    add(mass.position, mass.velocity);
}

/// From the centre to the corners; of a thin body to the middles of its ends, of a small one none: heads would lie on
/// one another.
std::vector<Vec2> corners_apart(const FrameParts& parts, const SnapshotBox& box) {
  const auto half = [&](double size) {
    return size * parts.view.pixels_per_metre < two_heads * parts.unit ? 0.0 : 0.5 * size;
  };
  const Vec2 axis = axis_of(box);
  const Vec2 along = half(box.size.x()) * axis;
  const Vec2 across = half(box.size.y()) * perp(axis);
  std::vector<Vec2> places;
  for (const Vec2& r :
       {Vec2(-along - across), Vec2(along - across), Vec2(along + across), Vec2(across - along)})
    if (!r.isZero(0.0) && std::ranges::find(places, r) == places.end()) places.push_back(r);
  return places;
}

/// m, to the side of the velocity's arrow where an acceleration would lie on it.
Vec2 beside_velocity(const FrameParts& parts, const SnapshotBox& box) {
  const Vec2& v = box.velocity;
  const Vec2& a = box.acceleration;
  const bool on_it = v.dot(a) > 0.0 && std::abs(det(v, a)) < same_way * v.dot(a);
  if (!on_it || !parts.has(Layer::velocities) || shows_symbols(parts)) return Vec2::Zero();
  return parts.metres(parts.style.arrow_head_width * parts.unit * parts.fineness)
         * perp(v).normalized();
}

/// Of the centre, and of the corners where the body turns: a + alpha r^perp - omega^2 r.
void add_accelerations(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const double scale = parts.options.metres_per_acceleration;
  for (const SnapshotBox& box : parts.snapshot.boxes) {
    if (box.fixed) continue;
    const auto add = [&](const Vec2& from, const Vec2& acceleration) {
      const Vec2 shown = shown_acceleration(acceleration, parts.snapshot.gravity);
      const std::size_t before = arrows.size();
      add_vector(parts, from, scale * shown, ArrowForm::twice, parts.style.acceleration, arrows);
      if (arrows.size() > before) arrows.back().cut = shown != acceleration;
    };
    add(box.center + beside_velocity(parts, box), box.acceleration);
    const double turning =
        (std::abs(box.angular_acceleration) + box.spin * box.spin) * 0.5 * box.size.norm();
    if (turning * scale * parts.view.pixels_per_metre < shortest_arrow * parts.unit) continue;
    for (const Vec2& r : corners_apart(parts, box)) {
      add(box.center + r,
          box.acceleration + box.angular_acceleration * perp(r) - box.spin * box.spin * r);
    }
  }
}

}  // namespace

void add_motion_arrows(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  if (parts.has(Layer::accelerations)) add_accelerations(parts, arrows);
  if (parts.has(Layer::velocities)) add_velocities(parts, arrows);
}

}  // namespace wuerfel::internal
