#include "core/statics/level_stack.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// What comes nearer than this share of the smaller side may touch.
constexpr double near = 1e-6;
/// Faces that touch over less than this share of the smaller side are corners.
constexpr double no_face = 1e-6;

}  // namespace

LevelStack::LevelStack(const StillScene& still)
    : still_(&still), right_(still.right()), parts_(still.system.cubes) {
  pose_boxes(still.system, still.state, boxes_);
}

std::optional<LevelStack> LevelStack::of(const StillScene& still, const Island& island) {
  if (!island.rods.empty() || still.system.gravity.isZero(0.0)) return std::nullopt;
  LevelStack stack(still);
  for (const Contact& c : island.contacts)
    if (!stack.add_contact(c)) return std::nullopt;
  for (const int cube : island.cubes) {
    const Part& part = stack.parts_[cube];
    const double least = no_face * still.system.body(cube).smaller_side();
    if (part.below < 0 || part.touch.high - part.touch.low <= least) return std::nullopt;
  }
  stack.add_weights(island);
  return stack;
}

/// False where it is not level, or the second thing that a cube stands on.
bool LevelStack::add_contact(const Contact& c) {
  if (!still_->is_level(c.normal)) return false;
  const bool on = c.normal.dot(still_->down()) < 0.0;
  const int above = on ? c.on : c.from;
  const int below = on ? c.from : c.on;
  if (!still_->system.is_cube(above) || still_->system.body(above).kind == BodyKind::point)
    return false;
  Part& part = parts_[above];
  if (part.below >= 0 && part.below != below) return false;
  part.below = below;
  part.touch.include(right_.dot(c.point));
  return still_->system.body(below).kind != BodyKind::point;
}

/// Of every cube to all that carry it.
void LevelStack::add_weights(const Island& island) {
  for (const int cube : island.cubes) {
    const double mass = still_->system.body(cube).mass;
    const double moment = mass * right_.dot(still_->state[cube].position);
    for (int i = cube; still_->system.is_cube(i); i = parts_[i].below) {
      parts_[i].mass += mass;
      parts_[i].centre += moment;
    }
  }
  for (const int cube : island.cubes)
    parts_[cube].centre /= parts_[cube].mass;
}

bool LevelStack::is_on(int cube, int base) const {
  while (cube != base && cube >= 0 && still_->system.is_cube(cube))
    cube = parts_[cube].below;
  return cube == base;
}

LevelStack::Interval LevelStack::along(int body, const Vec2& axis) const {
  Interval interval;
  for (int k = 0; k < Box::corners; ++k)
    interval.include(axis.dot(boxes_[body].corner(k)));
  return interval;
}

/// Its own face moves with it; what it stands on stays.
LoadRange LevelStack::on_support(int cube) const {
  const int below = parts_[cube].below;
  if (still_->system.body(below).kind == BodyKind::plane) return {};
  const Interval face = along(below, right_);
  return {face.low - parts_[cube].centre, face.high - parts_[cube].centre, 0.0};
}

/// Whether a cube that moves with `base` may touch anything on its way but what that stands on.
bool LevelStack::is_barred_for(int moved, int base, const LoadRange& range) const {
  const System& system = still_->system;
  const double room = near * system.body(moved).smaller_side();
  Interval swept = along(moved, right_);
  const Interval height = along(moved, still_->down());
  swept.low += range.low;
  swept.high += range.high;
  for (int other = 0; other < system.count(); ++other) {
    if (other == parts_[base].below || is_on(other, base)) continue;
    const Body& body = system.body(other);
    if (body.kind != BodyKind::plane) {
      if (swept.meets(along(other, right_), room)
          && height.meets(along(other, still_->down()), room))
        return true;
      continue;
    }
    for (const double s : {range.low, range.high}) {
      for (int k = 0; k < Box::corners; ++k) {
        if ((boxes_[moved].corner(k) + s * right_ - body.point).dot(body.normal) <= room)
          return true;
      }
    }
  }
  return false;
}

bool LevelStack::is_barred(int cube, const LoadRange& asked) const {
  constexpr double far = 1e100;  // m, a number that can be multiplied by zero
  const LoadRange range{std::max(asked.low, -far), std::min(asked.high, far), 0.0};
  for (int other = 0; other < still_->system.cubes; ++other)
    if (is_on(other, cube) && is_barred_for(other, cube, range)) return true;
  return false;
}

std::optional<LoadRange> LevelStack::move_range(int cube) const {
  LoadRange range = on_support(cube);
  for (int i = parts_[cube].below; still_->system.is_cube(i); i = parts_[i].below) {
    const double times = parts_[i].mass / parts_[cube].mass;
    range.low = std::max(range.low, times * (parts_[i].touch.low - parts_[i].centre));
    range.high = std::min(range.high, times * (parts_[i].touch.high - parts_[i].centre));
  }
  range.low = std::min(range.low, 0.0);  // on the edge itself but for rounding
  range.high = std::max(range.high, 0.0);
  if (is_barred(cube, range)) return std::nullopt;
  return range;
}

}  // namespace wuerfel
