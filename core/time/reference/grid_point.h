/// A grid time of a method with fixed steps: the state, what touches, and what was found about it.
#pragma once

#include <vector>

#include "core/dynamics/gauss.h"
#include "core/dynamics/push.h"

namespace wuerfel {

struct GridPoint {
  double t = 0.0;  ///< s
  State state;
  std::vector<Island> islands;  ///< of the contacts at `state`
  std::vector<IslandSolution>
      solutions;                     ///< of Eq. (9), one per island; without twists until asked
  std::vector<Twist> accelerations;  ///< one per cube; empty until asked for
  Push push;                         ///< by fixed bodies, in the step that leads here
  std::vector<char> resting;         ///< per cube: certified, v = 0 and a = 0
  std::vector<int> jammed;           ///< rods that contradicted each other

  /// Whether every cube rests, so that steps change nothing but the time.
  [[nodiscard]] bool at_rest() const;
};

/// Contacts of an island that press with the forces or impulses of a solution.
void add_pressed(const Island& island,
                 const IslandSolution& solution,
                 std::vector<Contact>& pressed);

}  // namespace wuerfel
