/// Which cubes may meet within a while: those belong to one group.
#pragma once

#include <vector>

#include "core/geometry/broad_phase.h"
#include "core/model/system.h"

namespace wuerfel {

/// Groups of numbers, each ascending, in the order of their first.
using Parts = std::vector<std::vector<int>>;

class Meetings {
 public:
  /// `apart`: else all cubes are one group.
  Meetings(const System& system, bool apart) : system_(&system), apart_(apart) {}

  /// Cubes whose predicted sweeps of `length` s overlap, or that rods join. `resting` per cube.
  Parts within(const State& state, const std::vector<char>& resting, double length);
  /// The groups that there are, joined where what their cubes really swept overlaps; empty where
  /// nobody has met. `swept` and `group_of` per cube.
  Parts joined(const std::vector<BoundingBox>& swept, const std::vector<int>& group_of, int groups);

 private:
  void predict(const State& state, const std::vector<char>& resting, double length);

  const System* system_;
  bool apart_;
  std::vector<BoundingBox> bounds_;  ///< of what cubes may sweep
  BroadPhase broad_phase_;
};

}  // namespace wuerfel
