/// Rods that contradict each other: no accelerations keep all their lengths, as with a point that moves across two rods
/// in one line.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/constraints/islands.h"
#include "core/model/system.h"

namespace wuerfel {

/// How rods go together.
struct RodConsistency {
  /// Numbers in System::rods of some that contradict each other, of which none can be left out; empty: none do.
  std::vector<int> contradicting;
  bool redundant = false;  ///< whether some depend on the others
};
RodConsistency rods_of_island(const System& system, const State& state, const Island& island);

/// Whether accelerations (the velocities of `accelerated`) miss what keeps the lengths of rods, by more than where rows
/// are only nearly dependent, as close to a stretched position that a mechanism passes.
bool misses_rods(const System& system, const State& state, const State& accelerated);

/// Names of rods and pins, each once.
std::vector<std::string> rod_names(const System& system, std::span<const int> rods);

/// Of all rods at a state whose velocities satisfy them.
RodConsistency rod_consistency(const System& system, const State& state);

/// The same a moment later, of what is at rest and begins to move with these accelerations (one per cube): a point
/// between two rods in one line may begin to move across them, but not go on.
RodConsistency rod_consistency_of_start(const System& system,
                                        const State& state,
                                        std::span<const Twist> accelerations);

}  // namespace wuerfel
