/// Islands that rest while others of their group are stepped: nothing is solved for them until something comes near.
#pragma once

#include <map>
#include <vector>

#include "core/time/stepping/stride.h"
#include "core/time/workspace.h"

namespace wuerfel {

/// A certificate of rest: from these places, without velocities, the contacts leave all cubes where they are.
struct RestingIsland {
  std::vector<int> cubes;         ///< ascending
  State places;                   ///< of these
  std::vector<Contact> contacts;  ///< that carry load
  std::vector<Vec2> forces;       ///< N, on the body of the corner, of each
};

class RestingIslands {
 public:
  explicit RestingIslands(Workspace& work) : system_(work.system), work_(&work) {}

  /// Islands that rub and that a step left where they were, but for rounding, rest at its end. Their solvers forget them,
  /// so that what follows does not depend on what was solved meanwhile.
  void find(const Stride& stride, const std::vector<Island>& islands, State& end);
  /// The certificate of an island that is as it was when it was found to rest; none: it is to be solved.
  [[nodiscard]] const RestingIsland* skipped(const Island& island, const State& start) const {
    return work_->skips.resting_steps ? of(island, start) : nullptr;
  }

 private:
  [[nodiscard]] const RestingIsland* of(const Island& island, const State& start) const;
  [[nodiscard]] bool stays(const Stride& stride,
                           const Island& island,
                           const State& end,
                           double share) const;
  void certify(const Stride& stride, const Island& island, const State& end);

  const System* system_;
  Workspace* work_;
  std::map<int, RestingIsland> resting_;  ///< by the first cube
};

/// Whether its cubes are at their places, and without velocities.
bool is_at(const RestingIsland& island, const State& state);
bool rests_at(const RestingIsland& island, const State& state);

}  // namespace wuerfel
