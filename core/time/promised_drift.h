/// How far the energy of a motion may be away from what its losses explain.
#pragma once

#include "core/model/scales.h"
#include "core/model/system.h"

namespace wuerfel {

class PromisedDrift {
 public:
  PromisedDrift() = default;
  /// From the start of the motion, whose steps keep to a tolerance.
  PromisedDrift(const System& system, const State& start, const Scales& scales, double tolerance);

  /// J, from event to event up to t.
  [[nodiscard]] double of_events(double t) const;
  /// J, where steps were taken and so much was lost.
  [[nodiscard]] double of_steps(double lost) const;

 private:
  double in_motion_ = 0.0;  ///< J, of all that moves or hangs at the start
  double per_time_ = 0.0;   ///< J, per L / V
  double time_ = 1.0;       ///< s, L / V
};

}  // namespace wuerfel
