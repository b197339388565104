/// Rods that contradict each other: no accelerations keep all their lengths, as with a point that moves across two rods
/// in one line.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/model/system.h"

namespace wuerfel {

struct RodConsistency {
  /// Names of rods and pins that contradict each other, of which none can be left out; empty where there are none.
  std::vector<std::string> contradicting;
  bool redundant = false;  ///< whether some depend on the others
};

/// Of rods at a state whose velocities satisfy them.
RodConsistency rod_consistency(const System& system, const State& state);

/// The same a moment later, of what is at rest and begins to move with these accelerations (one per cube): a point
/// between two rods in one line may begin to move across them, but not go on.
RodConsistency rod_consistency_of_start(const System& system,
                                        const State& state,
                                        std::span<const Twist> accelerations);

}  // namespace wuerfel
