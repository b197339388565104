#include "core/statics/carried.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/momentum.h"
#include "core/statics/parts.h"
#include "core/statics/sets.h"

namespace wuerfel {
namespace {

/// One island's part of a cube, by its place in it.
std::vector<int> part_of(const StillScene& still, const Island& island, int cube) {
  const auto at = std::ranges::lower_bound(island.cubes, cube);
  return carried_parts(still, island)[at - island.cubes.begin()];
}

/// Whether a rod joins cubes to anything else.
bool tied(const StillScene& still, const Island& island, const std::vector<int>& cubes) {
  const auto inside = [&](int body) { return has(cubes, body); };
  return std::ranges::any_of(island.rods, [&](int number) {
    const Rod& rod = still.system.rods[number];
    return inside(rod.i.body) != inside(rod.j.body);
  });
}

}  // namespace

std::optional<CarriedGroup> carried_group(const StillScene& still, int cube) {
  const int m = still.island_of(cube);
  if (m < 0 || still.system.body(cube).kind == BodyKind::point) return std::nullopt;
  const Island& island = still.found.islands[m].island;
  CarriedGroup group{part_of(still, island, cube), m};
  if (tied(still, island, group.cubes)) return std::nullopt;
  std::optional<Vec2> normal;
  for (const Contact& c : island.contacts) {
    const bool on = has(group.cubes, c.on);
    const bool from = has(group.cubes, c.from);
    if (on == from) continue;
    const Vec2 n = on ? c.normal : Vec2(-c.normal);
    if (-n.dot(still.down()) <= parallel) continue;  // beside it, or above
    if (normal && std::abs(det(*normal, n)) > parallel) return std::nullopt;
    normal = n;
  }
  if (!normal) return std::nullopt;
  group.along = -perp(*normal);
  if (group.along.dot(still.right()) < 0.0) group.along = -group.along;
  return group;
}

double smallest_side(const StillScene& still, const CarriedGroup& group) {
  double side = unbounded;
  for (const int cube : group.cubes) {
    const Body& body = still.system.body(cube);
    if (body.kind == BodyKind::cube) side = std::min(side, body.smaller_side());
  }
  return side;
}

State moved_state(const StillScene& still, const CarriedGroup& group, double distance) {
  State state = still.state;
  for (const int cube : group.cubes)
    state[cube].position += distance * group.along;
  return state;
}

MovedScene move(const StillScene& still,
                const MotionSettings& settings,
                const CarriedGroup& group,
                double distance) {
  const State state = moved_state(still, group, distance);
  ContactFinder finder;
  finder.find(still.system, state);
  const ContactFinder::Overlap& deepest = finder.deepest();
  if (deepest.depth > touching_tolerance * deepest.scale)
    return {Verdict::undecided, deepest.depth, true};
  const InstantForces found = forces_at(still.system, settings, state, Detail::accelerations);
  const std::vector<char> watched = still.concerned(group.island);
  return {judge(still.system, state, found, watched), unrest(still.system, state, found, watched),
          false};
}

}  // namespace wuerfel
