#include "render/picture/explode.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "render/picture/view.h"

namespace wuerfel {
namespace {

/// The place that stays: the middle of the lowest edge of all that moves.
Vec2 foot_of(const Snapshot& snapshot) {
  double left = 1e300;
  double right = -1e300;
  double low = 1e300;
  for (const SnapshotBox& box : snapshot.boxes) {
    if (box.fixed) continue;
    const Vec2 axis = axis_of(box).cwiseAbs();
    const double reach = 0.5 * (axis.x() * box.size.y() + axis.y() * box.size.x());
    left = std::min(left, box.center.x());
    right = std::max(right, box.center.x());
    low = std::min(low, box.center.y() - reach);
  }
  return left > right ? Vec2(Vec2::Zero()) : Vec2(0.5 * (left + right), low);
}

/// Rods and points stand cube by cube, the same number for each.
void move_parts(Snapshot& apart, const std::vector<Vec2>& ways) {
  const auto cubes = static_cast<std::ptrdiff_t>(ways.size());
  if (cubes == 0) return;
  const std::ptrdiff_t rods = std::ssize(apart.rods) / cubes;
  const std::ptrdiff_t points = std::ssize(apart.points) / cubes;
  for (std::ptrdiff_t k = 0; k < rods * cubes; ++k) {
    apart.rods[k].a += ways[k / rods];
    apart.rods[k].b += ways[k / rods];
  }
  for (std::ptrdiff_t k = 0; k < points * cubes; ++k)
    apart.points[k].position += ways[k / points];
}

/// What lies between bodies, and has no place when they are apart.
void clear_places(Snapshot& apart) {
  apart.impacts.clear();
  apart.contacts.clear();
  apart.sides.clear();
  apart.trails.clear();
  for (SnapshotCause& cause : apart.causes)
    cause = {.part = cause.part};
}

}  // namespace

Snapshot exploded(const Snapshot& snapshot, double share) {
  Snapshot apart = snapshot;
  const Vec2 foot = foot_of(snapshot);
  const auto step = [&](const Vec2& place) { return Vec2(share * (place - foot)); };
  std::map<std::string_view, Vec2> steps;  // of what moves, by its name
  std::vector<Vec2> ways;                  // of cubes
  for (SnapshotBox& box : apart.boxes) {
    const Vec2 way = step(box.center);
    box.center += way;
    if (box.fixed) continue;
    steps.emplace(box.name, way);
    ways.push_back(way);
  }
  move_parts(apart, ways);
  for (SnapshotMass& mass : apart.masses) {
    const Vec2 way = step(mass.position);
    mass.position += way;
    steps.emplace(mass.name, way);
  }
  // A plane is nowhere but along its normal.
  for (SnapshotPlane& plane : apart.planes)
    plane.point += step(plane.point).dot(plane.normal) * plane.normal;
  apart.joints.clear();
  apart.forces.clear();
  const auto boxes = static_cast<int>(snapshot.boxes.size());
  const auto add = [&](const SnapshotJoint& joint, int body, const Vec2& force) {
    if (body < 0 || body >= boxes) return;  // planes are not cut free
    apart.forces.push_back({joint.point + step(snapshot.boxes[body].center), force,
                            ForceKind::contact, body, joint.unique, joint.range});
  };
  for (const SnapshotJoint& joint : snapshot.joints) {
    add(joint, joint.body, joint.force);
    add(joint, joint.other, -joint.force);
  }
  // The ends of rods and pins go with their bodies, and pull or push there.
  for (SnapshotLink& link : apart.links) {
    const auto free_end = [&](const std::string& body, Vec2& end, const Vec2& force) {
      const auto way = steps.find(body);
      end += way == steps.end() ? step(end) : way->second;
      if (way != steps.end() && !force.isZero(0.0)) apart.forces.push_back({end, force});
    };
    free_end(link.bodies[0], link.a, link.force);
    free_end(link.bodies[1], link.b, -link.force);
  }
  clear_places(apart);
  return apart;
}

}  // namespace wuerfel
