/// A moment of the motion: the state, what touches, and what has been computed about it.
#pragma once

#include <vector>

#include "core/dynamics/gauss.h"

namespace wuerfel {

struct Moment {
  double t = 0.0;  ///< s
  State state;
  std::vector<Island> islands;  ///< of the contacts at `state`
  std::vector<IslandSolution>
      solutions;  ///< accelerations, one per island; without twists until asked for
  std::vector<Twist> accelerations;  ///< one per cube; empty until asked for
  State felt;  ///< what they were found for: `state`, but for velocities that do not count
  std::vector<char> resting;  ///< per cube: certified, v = 0 and a = 0
  /// What carried load in the step of a stepping in which the moment lies: it touches and rests but
  /// roughly.
  std::vector<Contact> loaded;
  std::vector<ContactId> lasting;  ///< contacts of a step ago, sorted: no new impacts of theirs
};

}  // namespace wuerfel
