/// What the choice of an integrator means, said once; everybody else asks this.
#pragma once

#include "core/settings.h"

namespace wuerfel {

struct MotionPolicy {
  enum class Method {
    groups,       ///< IslandMotion
    algorithm_1,  ///< FixedStepMotion
    moreau,       ///< likewise
  };
  Method method = Method::groups;
  bool as_printed = false;  ///< Algorithm 1 moves places by the old velocities
  bool only_steps = false;  ///< groups are stepped all the time
  bool only_events =
      false;          ///< groups are stepped only where the motion would not get on otherwise
  bool parts = true;  ///< few cubes of a group may move on others that stand
  double step = 0.0;  ///< s, the only one, or the longest; 0: it follows from the motion
  double allowed_error =
      0.0;  ///< of a step in which groups are stepped, as a share of the smallest side
  double sway =
      0.0;  ///< share of what is in motion that the energy of such steps may be away from its true value
};

MotionPolicy policy_of(const MotionSettings& settings);

}  // namespace wuerfel
