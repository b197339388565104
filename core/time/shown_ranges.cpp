#include "core/time/shown_ranges.h"

#include <utility>

namespace wuerfel {
namespace {

State states_of(const Island& island, const State& state) {
  State result;
  for (const int cube : island.cubes)
    result.push_back(state[cube]);
  return result;
}

}  // namespace

RangeFinder::Known RangeFinder::find(const System& system,
                                     const State& state,
                                     const IslandForces& of) const {
  State own = states_of(of.island, state);
  for (const Known& known : known_) {
    if (known.cubes == of.island.cubes && known.state == own) return known;
  }
  InstantForces alone;
  alone.islands = {of};
  alone.accelerations.resize(state.size());
  for (std::size_t k = 0; k < of.accelerations.size(); ++k)
    alone.accelerations[of.island.cubes[k]] = of.accelerations[k];
  const StillScene still{system, state, std::move(alone)};
  return {of.island.cubes, std::move(own), find_ranges(still, {.degree = false})};
}

std::vector<ForceRanges> RangeFinder::at(const System& system,
                                         const State& state,
                                         const InstantForces& found) {
  std::vector<Known> now;
  std::vector<ForceRanges> ranges;
  for (const IslandForces& of : found.islands) {
    ranges.emplace_back();
    if (of.detail < Detail::uniqueness || !stands_still(of.island, state)) continue;
    now.push_back(find(system, state, of));
    ranges.back() = now.back().ranges;
  }
  known_ = std::move(now);
  return ranges;
}

std::optional<SnapshotRange> shown_range(const LoadRange& range) {
  constexpr double width = 1e-9;  // as a share of the force: rounding
  // Not by the difference, which is infinite where there is no most.
  if (is_empty(range) || range.low >= (1.0 - width) * range.high) return std::nullopt;
  return SnapshotRange{range.low, range.high};
}

}  // namespace wuerfel
