/// Cubes moved with all they carry.
#pragma once

#include <optional>
#include <vector>

#include "core/statics/load_factor.h"
#include "core/statics/parts.h"
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

/// From where to where cubes of an island can be moved.
class MoveMargins {
 public:
  MoveMargins(const StillScene& still, const MotionSettings& settings, int island);

  /// m, to the right: of a cube with what it carries, so that the scene stands all the way; outwards
  /// from where it is, up to the first change. Of a scene that falls: around the nearest place that is
  /// known to help; empty where none is.
  [[nodiscard]] LoadRange range(int cube) const;

 private:
  [[nodiscard]] double expected_change(const CarriedGroup& group, double sense) const;

  const StillScene* still_;
  const MotionSettings* settings_;
  std::vector<PartStand> parts_;  ///< of an island that stands
};

/// The least move of a cube, with what it carries, that makes a falling scene stand.
std::optional<double> mending_move(const StillScene& still,
                                   const MotionSettings& settings,
                                   int cube);

}  // namespace wuerfel
