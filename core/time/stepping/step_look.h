/// Looks between the ends of a step.
#pragma once

#include "core/time/stepping/overlap_removal.h"

namespace wuerfel {

/// Closing speeds and changes of velocity within a step that exceed so many g h make it rough: an
/// impact, and of order one.
inline constexpr double rough_steps = 3.0;

/// Takes from the velocities what a state's energy exceeds `ceiling` (J) by: J v >= 0 is true of a
/// share of v, too.
void bring_down(const System& system, double ceiling, State& state);

class StepLook {
 public:
  StepLook(const System& system, const MotionSettings& settings)
      : system_(&system), removal_(system, settings) {}

  /// Where the cubes are at `share` of a step of `h` s from one state to the next: without overlap,
  /// and with no more energy than at its ends.
  [[nodiscard]] State at(const State& from, const State& to, double h, double share);

 private:
  const System* system_;
  OverlapRemoval removal_;
};

}  // namespace wuerfel
