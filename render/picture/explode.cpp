#include "render/picture/explode.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// The place that stays: the middle of the lowest edge of all that moves.
Vec2 foot_of(const Snapshot& snapshot) {
  double left = 1e300;
  double right = -1e300;
  double low = 1e300;
  for (const SnapshotBox& box : snapshot.boxes) {
    if (box.fixed) continue;
    const double reach = 0.5
                         * (std::abs(std::cos(box.angle)) * box.size.y()
                            + std::abs(std::sin(box.angle)) * box.size.x());
    left = std::min(left, box.center.x());
    right = std::max(right, box.center.x());
    low = std::min(low, box.center.y() - reach);
  }
  return left > right ? Vec2(Vec2::Zero()) : Vec2(0.5 * (left + right), low);
}

}  // namespace

Snapshot exploded(const Snapshot& snapshot, double share) {
  Snapshot apart = snapshot;
  const Vec2 foot = foot_of(snapshot);
  const auto step = [&](const Vec2& place) { return Vec2(share * (place - foot)); };
  for (SnapshotBox& box : apart.boxes)
    box.center += step(box.center);
  // A plane is nowhere but along its normal.
  const auto plane_step = [&](const SnapshotPlane& plane) {
    return Vec2(step(plane.point).dot(plane.normal) * plane.normal);
  };
  for (SnapshotPlane& plane : apart.planes)
    plane.point += plane_step(plane);
  apart.joints.clear();
  apart.forces.clear();
  const auto boxes = static_cast<int>(snapshot.boxes.size());
  const auto add = [&](const SnapshotJoint& joint, int body, const Vec2& force) {
    if (body < 0 || body >= boxes) return;  // planes are not cut free
    apart.forces.push_back({joint.point + step(snapshot.boxes[body].center), force,
                            ForceKind::contact, body, joint.unique});
  };
  for (const SnapshotJoint& joint : snapshot.joints) {
    add(joint, joint.body, joint.force);
    add(joint, joint.other, -joint.force);
  }
  return apart;
}

}  // namespace wuerfel
