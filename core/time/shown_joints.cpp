#include "core/time/shown_joints.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "core/time/shown_ranges.h"

namespace wuerfel {
namespace {

/// A joint that grows contact by contact.
struct Growing {
  SnapshotJoint joint;
  double pressure = 0.0;           ///< N, sum of the normal forces so far
  Vec2 moment = Vec2::Zero();      ///< N m, sum of the places so far, each times its normal force
  std::pair<double, double> span;  ///< m, along perp(normal) from the first contact
  Vec2 origin = Vec2::Zero();      ///< m, the first contact
};

Growing start(const System& system, const Contact& c) {
  Growing of;
  const bool on = is_carried(system, c);
  of.joint.body = on ? c.on : c.from;
  of.joint.other = on ? c.from : c.on;
  of.joint.normal = on ? c.normal : Vec2(-c.normal);
  of.origin = c.point;
  return of;
}

void include(const IslandForces& found, int k, Growing& of) {
  const Contact& c = found.island.contacts[k];
  const double offset = (c.point - of.origin).dot(perp(of.joint.normal));
  of.span.first = std::min(of.span.first, offset);
  of.span.second = std::max(of.span.second, offset);
  const double sign = of.joint.body == c.on ? 1.0 : -1.0;
  const double normal = found.forces.force[k];
  of.joint.force += sign * normal * c.normal;
  if (!found.forces.tangential.empty())
    of.joint.force += sign * found.forces.tangential[k] * perp(c.normal);
  of.pressure += normal;
  of.moment += normal * c.point;
  if (found.detail == Detail::uniqueness && found.forces.unique[k] == 0) of.joint.unique = false;
}

SnapshotJoint finish(const System& system, Growing of) {
  of.joint.body = box_of(system, of.joint.body);
  of.joint.other = box_of(system, of.joint.other);
  const Vec2 along = perp(of.joint.normal);
  of.joint.from = of.origin + of.span.first * along;
  of.joint.to = of.origin + of.span.second * along;
  of.joint.point = of.moment / of.pressure;
  return of.joint;
}

/// Of the face by which two bodies touch.
std::optional<SnapshotRange> range_of(const ForceRanges& ranges, const SnapshotJoint& joint) {
  const auto pair = std::minmax(joint.body, joint.other);
  const auto face = std::ranges::find_if(
      ranges.interfaces, [&](const Interface& f) { return std::minmax(f.on, f.from) == pair; });
  return face == ranges.interfaces.end() ? std::nullopt : shown_range(face->force_range);
}

/// Per contact the first one between the same two bodies.
std::vector<int> first_of_pairs(std::span<const Contact> contacts) {
  const auto pair = [&](int k) { return std::minmax(contacts[k].on, contacts[k].from); };
  std::vector<int> order(contacts.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return std::pair<int, int>(pair(k)); });
  std::vector<int> first(contacts.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && pair(order[i]) == pair(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// Points have no faces: their forces are shown contact by contact.
bool rests_on_point(const System& system, const SnapshotJoint& joint) {
  return system.body(joint.body).kind == BodyKind::point
         || system.body(joint.other).kind == BodyKind::point;
}

}  // namespace

int box_of(const System& system, int body) {
  if (body < system.cubes - system.points) return body;
  return body < system.cubes ? -1 : body - system.points;
}

bool is_carried(const System& system, const Contact& contact) {
  const bool carries = system.gravity.dot(contact.normal) <= 0.0;
  return system.is_cube(contact.on) && (carries || !system.is_cube(contact.from));
}

// Two boxes, or a box and a plane, are convex: they touch by one face.
void add_joints(const System& system,
                const IslandForces& of,
                const ForceRanges& ranges,
                std::vector<SnapshotJoint>& joints) {
  const std::vector<int> first = first_of_pairs(of.island.contacts);
  std::vector<Growing> growing;
  std::vector<int> place(first.size());
  for (int k = 0; k < std::ssize(first); ++k) {
    if (first[k] == k) {
      place[k] = static_cast<int>(growing.size());
      growing.push_back(start(system, of.island.contacts[k]));
    }
    include(of, k, growing[place[first[k]]]);
  }
  const double least = of.forces.least_pressing();
  for (const Growing& joint : growing) {
    if (joint.pressure <= least || rests_on_point(system, joint.joint)) continue;
    const std::optional<SnapshotRange> range = range_of(ranges, joint.joint);
    joints.push_back(finish(system, joint));
    joints.back().range = range;
  }
}

}  // namespace wuerfel
