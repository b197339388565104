/// Cubes moved with all they carry.
#pragma once

#include <optional>
#include <vector>

#include "core/statics/still_scene.h"

namespace wuerfel {

/// A cube and what it carries, and the way along what they stand on.
struct CarriedGroup {
  std::vector<int> cubes;
  int island = -1;
  Vec2 along = Vec2::UnitX();  ///< unit vector, to the right
};

/// None where the cube stands on sides that are not parallel, or on nothing.
std::optional<CarriedGroup> carried_group(const StillScene& still, int cube);

/// Of its cubes, m.
double smallest_side(const StillScene& still, const CarriedGroup& group);

/// The bodies with the group moved.
State moved_state(const StillScene& still, const CarriedGroup& group, double distance);

/// What becomes of the group's island, and of all that stands beside it, when the group is moved.
struct MovedScene {
  Verdict verdict = Verdict::undecided;
  double unrest = 0.0;    ///< largest |a| + side |alpha|, as a share of g
  bool overlaps = false;  ///< the way is barred
};
MovedScene move(const StillScene& still,
                const MotionSettings& settings,
                const CarriedGroup& group,
                double distance);

}  // namespace wuerfel
