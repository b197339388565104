#include "core/statics/move_margins.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/dynamics/momentum.h"
#include "core/statics/limit_motion.h"
#include "core/statics/margins.h"

namespace wuerfel {
namespace {

/// Ends are bracketed to this share of the smaller side.
constexpr double bracketed = 1e-9;
constexpr double seen_to_fall = 1e-7;
/// Likewise, where the motion behind an end is looked at to find that end exactly.
constexpr double seen_to_move = 1e-5;
constexpr int most_looks = 80;
/// Of a way, as a share of the side.
constexpr double rounding = 1e-15;

/// Looks at moved scenes, and finds where they change.
class MoveSearch {
 public:
  MoveSearch(const StillScene& still, const MotionSettings& settings, const CarriedGroup& group)
      : still_(still), settings_(settings), group_(group) {
    side_ = unbounded;
    for (const int cube : group.cubes) {
      const Body& body = still.system.body(cube);
      if (body.kind == BodyKind::cube) side_ = std::min(side_, body.smaller_side());
    }
  }

  [[nodiscard]] MovedScene at(double s) const { return move(still_, settings_, group_, s); }
  [[nodiscard]] bool stands(double s) const { return at(s).verdict == Verdict::stands; }
  [[nodiscard]] double side() const { return side_; }

  /// Whether the scene stands up to a place, as looks in between tell, and not beyond. On the edge itself
  /// rounding decides, and just behind it high parts move too slowly to be seen.
  [[nodiscard]] bool changes_at(double s, double sense) const {
    if (!std::isfinite(s) || s == 0.0) return false;
    return stands(s - sense * bracketed * side_) && !stands(s + sense * seen_to_fall * side_)
           && stands(0.5 * s);
  }

  /// The last place where a scene stands, and how exactly it is known.
  struct End {
    double s = 0.0;
    double error = 0.0;
  };

  /// Between a place where the scene stands and one where it does not.
  [[nodiscard]] End end(double in, double out) const {
    const double s = edge(in, out);
    const double step = std::copysign(side_, out - in);
    const double behind = s + seen_to_move * step;
    const std::optional<double> exact =
        at(behind).overlaps
            ? end_of_room(still_, settings_, group_, behind, s + 2.0 * seen_to_move * step)
            : end_of_rest(still_, settings_, group_, s, behind);
    if (exact && std::abs(*exact - s) <= seen_to_fall * side_ && stands(*exact)) return {*exact};
    // The last place on a face that is left: on its end itself nothing holds.
    constexpr double brackets = 4.0;
    if (const auto touch = end_of_touch(still_, group_, s, brackets * bracketed * side_))
      return {*touch};
    return {s, bracketed * side_};
  }

  /// The same by looks alone.
  [[nodiscard]] double edge(double in, double out) const {
    double before = out;  // the last place outside but one
    double unrest_before = 0.0;
    MovedScene there = at(out);
    for (int k = 0; k < most_looks && std::abs(out - in) > bracketed * side_; ++k) {
      const double s = guess(in, out, there, before, unrest_before, k);
      const MovedScene now = at(s);
      if (now.verdict == Verdict::stands) {
        in = s;
        // A step on, to see whether that was it.
        const double on = s + std::copysign(bracketed * side_, out - in);
        if (std::abs(out - in) > bracketed * side_ && !stands(on)) return in;
        continue;
      }
      before = out;
      unrest_before = there.unrest;
      out = s;
      there = now;
    }
    return in;
  }

  /// Outwards from a place where the scene stands, to the right (+1) or to the left: the last place
  /// before the first change; infinite where none is found beyond all bodies.
  [[nodiscard]] End first_change(double from, double sense) const {
    constexpr int even_steps = 8;
    const double far = extent() + std::abs(from);
    double in = from;
    double step = 0.25 * side_;
    for (int k = 0; std::abs(in) <= far; ++k) {
      const double out = in + sense * step;
      if (!stands(out)) return end(in, out);
      in = out;
      if (k >= even_steps) step *= 2.0;
    }
    return {sense * unbounded};
  }

 private:
  /// Where the motion begins, as two places outside tell; the end of an overlap; or the middle.
  [[nodiscard]] double guess(double in,
                             double out,
                             const MovedScene& there,
                             double before,
                             double unrest_before,
                             int k) const {
    const double middle = 0.5 * (in + out);
    constexpr int in_turn = 4;
    if (k % in_turn == in_turn - 1) return middle;
    double s = middle;
    if (there.overlaps) {
      s = out - std::copysign(there.unrest, out - in);
    } else if (before != out && unrest_before != there.unrest) {
      s = out - there.unrest * (before - out) / (unrest_before - there.unrest);
    }
    const bool inside = (s - in) * (out - s) > 0.0;
    return inside ? s : middle;
  }

  /// The length of the scene along the way, m.
  [[nodiscard]] double extent() const {
    double low = unbounded;
    double high = -unbounded;
    std::vector<Box> boxes;
    pose_boxes(still_.system, still_.state, boxes);
    for (int i = 0; i < still_.system.count(); ++i) {
      if (still_.system.body(i).kind == BodyKind::plane) continue;
      const double at = group_.along.dot(boxes[i].center);
      low = std::min(low, at - boxes[i].radius());
      high = std::max(high, at + boxes[i].radius());
    }
    return high - low;
  }

  const StillScene& still_;
  const MotionSettings& settings_;
  const CarriedGroup& group_;
  double side_ = 0.0;
};

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
    if (std::ranges::binary_search(cubes, cube)) moved += still.system.body(cube).mass;
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
    const double times = part.mass / (moved * group.along.dot(right_of(still.down())));
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
  if (!still.falls(of)) level_ = LevelStack::of(still, of.island);
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
    const double along = group.along.dot(right_of(still_->down()));
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
    const bool on = std::ranges::binary_search(group.cubes, c.on);
    const int other = on ? c.from : c.on;
    if (on == std::ranges::binary_search(group.cubes, c.from)) continue;
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
  if (still_->falls(still_->found.islands[island_])) {
    const std::optional<double> mended = mending_move(*still_, *settings_, cube);
    if (!mended) return no_load;
    const MoveSearch::End beyond = search.first_change(*mended, *mended < 0.0 ? -1.0 : 1.0);
    return {std::min(*mended, beyond.s), std::max(*mended, beyond.s),
            std::max(beyond.error, bracketed * search.side())};
  }
  const auto end = [&](double sense) -> MoveSearch::End {
    for (const double expected : {expected_change(group, sense), end_of_faces(group, sense)})
      if (search.changes_at(expected, sense)) return {expected};
    return search.first_change(0.0, sense);
  };
  const MoveSearch::End left = end(-1.0);
  const MoveSearch::End right = end(1.0);
  const auto rounded = [&](double s) { return std::abs(s) <= rounding * search.side() ? 0.0 : s; };
  return {rounded(left.s), rounded(right.s), std::max(left.error, right.error)};
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
