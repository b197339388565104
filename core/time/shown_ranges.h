/// Which forces are possible at an instant, for pictures.
#pragma once

#include <vector>

#include "core/snapshot.h"
#include "core/statics/ranges.h"

namespace wuerfel {

/// Looks at one instant after the other. What it knows of cubes that are where they were it keeps.
class RangeFinder {
 public:
  /// One for each island of `found`; empty of islands that move, of whose forces only those that are
  /// shown are known.
  std::vector<ForceRanges> at(const System& system, const State& state, const InstantForces& found);

 private:
  struct Known {
    std::vector<int> cubes;
    State state;  ///< of those
    ForceRanges ranges;
  };
  [[nodiscard]] Known find(const System& system, const State& state, const IslandForces& of) const;

  std::vector<Known> known_;  ///< at the last look
};

/// None where it is not known, or where there is one force alone.
std::optional<SnapshotRange> shown_range(const LoadRange& range);

}  // namespace wuerfel
