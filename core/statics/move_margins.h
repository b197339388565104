/// From where to where cubes can be moved, and the least move that mends a scene.
#pragma once

#include <optional>
#include <vector>

#include "core/statics/carried.h"
#include "core/statics/level_stack.h"
#include "core/statics/load_factor.h"
#include "core/statics/parts.h"

namespace wuerfel {

/// From where to where cubes of an island can be moved.
class MoveMargins {
 public:
  MoveMargins(const StillScene& still, const MotionSettings& settings, int island);

  /// m, to the right: of a cube with what it carries, so that the scene stands all the way; outwards
  /// from where it is, up to the first change. Of a scene that falls: around the nearest place that is
  /// known to help; empty where none is.
  [[nodiscard]] LoadRange range(int cube);

 private:
  [[nodiscard]] LoadRange range_of(int cube, const CarriedGroup& group);
  [[nodiscard]] double expected_change(const CarriedGroup& group, double sense);
  [[nodiscard]] double end_of_faces(const CarriedGroup& group, double sense) const;

  const StillScene* still_;
  const MotionSettings* settings_;
  int island_;
  std::optional<LevelStack> level_;  ///< of an island that stands
  std::vector<PartStand> parts_;     ///< of one where they are needed
};

/// The least move of a cube, with what it carries, that makes a falling scene stand.
std::optional<double> mending_move(const StillScene& still,
                                   const MotionSettings& settings,
                                   int cube);

}  // namespace wuerfel
