/// A scene at its start, looked at once: what margins, ranges and causes are asked of.
#pragma once

#include <span>
#include <vector>

#include "core/dynamics/forces_at.h"
#include "core/dynamics/verdict.h"
#include "core/settings.h"

namespace wuerfel {

/// Everything but the verdict is meant for scenes in which nothing moves yet.
struct StillScene {
  System system;
  State state;
  InstantForces found;
  Verdict verdict = Verdict::undecided;

  /// Number of the island of a cube, -1 where it touches nothing.
  [[nodiscard]] int island_of(int cube) const;
  /// Per cube whether what it does depends on an island: 0 for cubes that fall without it.
  [[nodiscard]] std::vector<char> concerned(int island) const;
  /// N; of one kilogram where there is no gravity.
  [[nodiscard]] double weight(int cube) const;
  /// Unit vector along gravity; down where there is none.
  [[nodiscard]] Vec2 down() const;
  /// Gravity turned left by a right angle.
  [[nodiscard]] Vec2 right() const { return perp(down()); }
  /// Whether a face with this normal, of any length, is level but for rounding.
  [[nodiscard]] bool is_level(const Vec2& normal) const;
};

/// Of a scene that stands still once the impacts at its start are over, as `check` tells: of its place.
StillScene stopped_scene(const Scene& scene, const MotionSettings& settings);

/// Of the same bodies elsewhere.
StillScene still_scene(const System& system, const State& state, const MotionSettings& settings);

}  // namespace wuerfel
