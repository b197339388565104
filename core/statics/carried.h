/// Cubes moved with all they carry.
#pragma once

#include <optional>
#include <vector>

#include "core/statics/load_factor.h"
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

/// From where to where (m, to the right) a cube can be moved with what it carries so that the scene
/// stands all the way: outwards from where it is, up to the first change. Of a scene that falls:
/// around the nearest place that is known to help; empty where none is.
LoadRange move_range(const StillScene& still, const MotionSettings& settings, int cube);

/// The least move of a cube, with what it carries, that makes a falling scene stand.
std::optional<double> mending_move(const StillScene& still,
                                   const MotionSettings& settings,
                                   int cube);

}  // namespace wuerfel
