/// The smallest changes that make a falling scene stand, each verified on the mended scene.
#pragma once

#include <cmath>
#include <vector>

#include "core/statics/causes.h"

namespace wuerfel {

struct Fix {
  enum class Kind { move, force };
  Kind kind = Kind::move;
  int cube = 0;
  double distance = 0.0;      ///< m, of a move of the cube with what it carries; positive: right
  int carried = 1;            ///< cubes that move
  Vec2 along = Vec2::Zero();  ///< unit vector of the move
  Vec2 point = Vec2::Zero();  ///< m, where a force acts: a corner; of a move the cube's centre
  Vec2 force = Vec2::Zero();  ///< N
  Verdict verified = Verdict::undecided;  ///< of the mended island and all that stands beside it
  [[nodiscard]] double size() const {
    return kind == Kind::move ? std::abs(distance) : force.norm();
  }
};

/// For each island that falls: up to three moves of one cube, and up to three forces at one corner of
/// one cube, the smallest first. Those that cannot be verified are left out.
std::vector<Fix> find_fixes(const StillScene& still,
                            const MotionSettings& settings,
                            const Causes& causes);

/// What becomes of the island of a cube, and of all that stands beside it, under a force at a point.
Verdict verdict_with_force(const StillScene& still, int cube, const Vec2& point, const Vec2& force);

}  // namespace wuerfel
