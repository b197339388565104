#include "core/statics/move_margins.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/dynamics/momentum.h"
#include "core/statics/move_search.h"
#include "core/statics/sets.h"

namespace wuerfel {
namespace {

/// Of a way, as a share of the side.
constexpr double way_rounding = 1e-15;

/// Whether the group is all there is beside planes: it can be moved as far as one likes.
bool is_alone(const StillScene& still, const CarriedGroup& group) {
  if (static_cast<int>(group.cubes.size()) < still.system.cubes) return false;
  for (int i = still.system.cubes; i < still.system.count(); ++i)
    if (still.system.body(i).kind != BodyKind::plane) return false;
  const std::vector<Contact>& contacts = still.found.islands[group.island].island.contacts;
  return std::ranges::all_of(contacts, [&](const Contact& c) {
    const bool inside = still.system.is_cube(c.on) && still.system.is_cube(c.from);
    return inside || std::abs(c.normal.dot(group.along)) <= parallel;
  });
}

/// kg, of a part that moves with the group.
double moved_mass(const StillScene& still,
                  const CarriedGroup& group,
                  const std::vector<int>& cubes) {
  double moved = 0.0;
  for (const int cube : group.cubes)
    if (has(cubes, cube)) moved += still.system.body(cube).mass;
  return moved;
}

/// How far the group has to go so that the centre of every part that fails comes to where it stands;
/// empty where it cannot do that. These are necessary, and mostly sufficient.
LoadRange needed(const StillScene& still, const Island& island, const CarriedGroup& group) {
  LoadRange needed;
  const PartJudge judge(still, island);
  for (const std::vector<int>& cubes : carried_parts(still, island)) {
    const PartStand part = judge.judge(cubes, Shift::of_what_falls);
    if (part.stands()) continue;
    const double moved = moved_mass(still, group, cubes);
    if (moved == 0.0 || is_empty(part.shift)) return no_load;
    const double times = part.mass / (moved * group.along.dot(still.right()));
    needed.low = std::max(needed.low, part.shift.low * times);
    needed.high = std::min(needed.high, part.shift.high * times);
  }
  return needed;
}

/// From a place where the scene falls to one where it stands, the first place that does.
std::optional<double> mended_on_the_way(const MoveSearch& search, double nearest, double farthest) {
  constexpr std::array on_the_way{0.0, 0.05, 0.25, 0.5, 1.0};
  double before = 0.0;
  for (const double share : on_the_way) {
    const double s = nearest + share * (farthest - nearest);
    if (search.stands(s)) {
      constexpr double nearly = 0.9995;
      if (!search.stands(nearly * s)) return s;
      const double end = search.end(s, before).s;
      return search.stands(end) ? end : search.edge(s, before);
    }
    before = s;
  }
  return std::nullopt;
}

}  // namespace

MoveMargins::MoveMargins(const StillScene& still, const MotionSettings& settings, int island)
    : still_(&still), settings_(&settings), island_(island) {
  const IslandForces& of = still.found.islands[island];
  if (of.rests) level_ = LevelStack::of(still, of.island);
}

/// Where the centre of a part leaves what it stands on; mostly that is the first change.
double MoveMargins::expected_change(const CarriedGroup& group, double sense) {
  if (parts_.empty()) {
    const Island& island = still_->found.islands[island_].island;
    const PartJudge judge(*still_, island);
    for (const std::vector<int>& cubes : carried_parts(*still_, island))
      parts_.push_back(judge.judge(cubes, Shift::of_all));
  }
  double nearest = unbounded;
  for (const PartStand& part : parts_) {
    const double moved = moved_mass(*still_, group, part.cubes);
    const double reach = sense > 0.0 ? part.shift.high : -part.shift.low;
    const double along = group.along.dot(still_->right());
    if (moved > 0.0) nearest = std::min(nearest, reach * part.mass / (moved * along));
  }
  return sense * nearest;
}

/// Where the centre of the group comes to the end of a face that it stands on: the first change where
/// corners of its own, which move with it, are what bounds it now.
double MoveMargins::end_of_faces(const CarriedGroup& group, double sense) const {
  Vec2 centre = Vec2::Zero();
  for (const int cube : group.cubes)
    centre += still_->system.body(cube).mass * still_->state[cube].position;
  centre /= moved_mass(*still_, group, group.cubes);
  std::vector<Box> boxes;
  pose_boxes(still_->system, still_->state, boxes);
  double end = -unbounded;
  for (const Contact& c : still_->found.islands[group.island].island.contacts) {
    const bool on = has(group.cubes, c.on);
    const int other = on ? c.from : c.on;
    if (on == has(group.cubes, c.from)) continue;
    if (still_->system.body(other).kind == BodyKind::plane) return sense * unbounded;
    for (int k = 0; k < Box::corners; ++k) {
      const Vec2 corner = boxes[other].corner(k);
      if (std::abs(c.normal.dot(corner - c.point)) > parallel * boxes[other].radius()) continue;
      end = std::max(end, sense * group.along.dot(corner - centre));
    }
  }
  return sense * end;
}

LoadRange MoveMargins::range(int cube) {
  if (level_ && still_->system.body(cube).kind == BodyKind::cube) {
    if (const std::optional<LoadRange> range = level_->move_range(cube)) return *range;
  }
  const std::optional<CarriedGroup> group = carried_group(*still_, cube);
  return group ? range_of(cube, *group) : no_load;
}

LoadRange MoveMargins::range_of(int cube, const CarriedGroup& group) {
  const MoveSearch search(*still_, *settings_, group);
  if (is_alone(*still_, group) && still_->verdict == Verdict::stands) return {};
  if (!still_->found.islands[island_].rests) {
    const std::optional<double> mended = mending_move(*still_, *settings_, cube);
    if (!mended) return no_load;
    const MoveSearch::End beyond = search.first_change(*mended, *mended < 0.0 ? -1.0 : 1.0);
    return {std::min(*mended, beyond.s), std::max(*mended, beyond.s),
            std::max(beyond.error, MoveSearch::bracketed * search.side())};
  }
  const auto end = [&](double sense) -> MoveSearch::End {
    for (const double expected : {expected_change(group, sense), end_of_faces(group, sense)})
      if (search.changes_at(expected, sense)) return {expected};
    return search.first_change(0.0, sense);
  };
  const MoveSearch::End left = end(-1.0);
  const MoveSearch::End right = end(1.0);
  const auto rounded = [&](double s) {
    return std::abs(s) <= way_rounding * search.side() ? 0.0 : s;
  };
  return {std::min(0.0, rounded(left.s)), std::max(0.0, rounded(right.s)),
          std::max(left.error, right.error)};
}

std::optional<double> mending_move(const StillScene& still,
                                   const MotionSettings& settings,
                                   int cube) {
  const std::optional<CarriedGroup> group = carried_group(still, cube);
  if (!group) return std::nullopt;
  const Island& island = still.found.islands[still.island_of(cube)].island;
  const LoadRange range = needed(still, island, *group);
  if (is_empty(range)) return std::nullopt;
  const MoveSearch search(still, settings, *group);
  if (!range.contains(0.0)) {
    const bool right = range.low > 0.0;
    return mended_on_the_way(search, right ? range.low : range.high,
                             right ? std::min(range.high, range.low + search.side())
                                   : std::max(range.low, range.high - search.side()));
  }
  // No part fails alone: look both ways.
  const std::optional<double> right =
      mended_on_the_way(search, 1e-3 * search.side(), search.side());
  const std::optional<double> left =
      mended_on_the_way(search, -1e-3 * search.side(), -search.side());
  if (!right || (left && -*left < *right)) return left;
  return right;
}

}  // namespace wuerfel
