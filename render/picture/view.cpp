#include "render/picture/view.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/trig.h"
#include "render/error.h"

namespace wuerfel {
namespace {

/// `size` m: of the numbers that the point was computed from.
bool inside_any(const std::vector<SnapshotPlane>& planes, const Vec2& point, double size) {
  constexpr double tolerance = 1e-9;
  return std::ranges::any_of(planes, [&](const SnapshotPlane& plane) {
    return (point - plane.point).dot(plane.normal) < -tolerance * size;
  });
}

/// The places on the ground below the bodies, and the room for arrows so long in the ground that
/// they may touch. Ground farther away than the bodies are wide does not
/// pull the picture towards it.
void include_near_ground(const Snapshot& snapshot, double depth, Bounds& bounds) {
  constexpr double touching = 1.001;
  const double reach = 4.0 * std::max(bounds.size().x(), bounds.size().y());
  for (const SnapshotPlane& plane : snapshot.planes) {
    for (const SnapshotBox& box : snapshot.boxes) {
      const double distance = (box.center - plane.point).dot(plane.normal);
      const Vec2 foot = box.center - distance * plane.normal;
      const double size = box.center.norm() + box.size.norm();
      if (distance >= reach || inside_any(snapshot.planes, foot, size)) continue;
      bounds.include(foot);
      const bool may_touch = distance <= touching * 0.5 * box.size.norm();
      if (may_touch) bounds.include(Vec2(foot - depth * plane.normal));
    }
  }
}

}  // namespace

Vec2 axis_of(const SnapshotBox& box) {
  Vec2 axis;
  sin_cos(box.angle, axis.y(), axis.x());
  return axis;
}

std::array<Vec2, 4> corners(const SnapshotBox& box) {
  const Vec2 axis = axis_of(box);
  const Vec2 along = 0.5 * box.size.x() * axis;
  const Vec2 across = 0.5 * box.size.y() * perp(axis);
  return {box.center - along - across, box.center + along - across, box.center + along + across,
          box.center - along + across};
}

SnapshotBox moved_by(const SnapshotBox& box, const SnapshotMotion& motion, double reach) {
  SnapshotBox moved = box;
  moved.center += reach * motion.way;
  moved.angle += reach * motion.turn;
  return moved;
}

SnapshotBox moved_by(const SnapshotBox& box, const Vec2& way) {
  SnapshotBox moved = box;
  moved.center += way;
  return moved;
}

double motion_scale(const Snapshot& snapshot) {
  constexpr double reach = 0.4;  // of a typical side
  double side = 0.0;
  int count = 0;
  for (const SnapshotBox& box : snapshot.boxes) {
    if (box.fixed) continue;
    side += typical_side_of(box);
    ++count;
  }
  return count == 0 ? 0.0 : reach * side / count;
}

void Bounds::include(const Vec2& point) {
  min = min.cwiseMin(point);
  max = max.cwiseMax(point);
}

void Bounds::include(const SnapshotBox& box) {
  for (const Vec2& corner : corners(box))
    include(corner);
}

void Bounds::include(const Snapshot& snapshot, const ForceScale& force_scale) {
  for (const SnapshotBox& box : snapshot.boxes)
    include(box);
  for (const SnapshotMotion& motion : snapshot.mechanism)
    include(moved_by(snapshot.boxes[motion.box], motion, motion_scale(snapshot)));
  for (const SnapshotMass& mass : snapshot.masses)
    include(mass.position);
  for (const SnapshotLink& link : snapshot.links) {
    include(link.a);
    include(link.b);
  }
  const bool arrows = force_scale.metres_per_newton > 0.0;
  const double depth = arrows && force_scale.longest < 1e300 ? force_scale.longest : 0.0;
  if (!empty()) include_near_ground(snapshot, depth, *this);
  if (!arrows) return;
  for (const SnapshotForce& force : snapshot.forces) {
    const double length = force_scale.metres_per_newton * force.force.norm();
    const double shown = std::min(length, force_scale.longest);
    if (shown > 0.0)
      include(Vec2(force.point + force_scale.metres_per_newton * shown / length * force.force));
  }
}

View fit_view(const Bounds& bounds, int width, int height, const Insets& insets) {
  const double room_x = std::max(width - insets.left - insets.right, 0.25 * width);
  const double room_y = std::max(height - insets.top - insets.bottom, 0.25 * height);
  Vec2 size = bounds.size();
  if (std::max(size.x(), size.y()) <= 0.0) size = Vec2::Ones();
  View view;
  view.width = width;
  view.height = height;
  view.pixels_per_metre =
      std::min(room_x / std::max(size.x(), 1e-300), room_y / std::max(size.y(), 1e-300));
  if (bounds.empty()) return view;
  const double middle_x = insets.left + 0.5 * (width - insets.left - insets.right);
  view.center.x() =
      0.5 * (bounds.min.x() + bounds.max.x()) + (0.5 * width - middle_x) / view.pixels_per_metre;
  view.center.y() = bounds.min.y() + (0.5 * height - insets.bottom) / view.pixels_per_metre;
  return view;
}

View fixed_view(const Vec2& center, double world_width, int width, int height) {
  if (!(world_width > 0.0) || !std::isfinite(world_width) || !center.allFinite()) {
    throw RenderError("a view needs a finite centre and a width greater than 0 m");
  }
  View view;
  view.width = width;
  view.height = height;
  view.center = center;
  view.pixels_per_metre = width / world_width;
  return view;
}

}  // namespace wuerfel
