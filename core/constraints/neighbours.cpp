#include "core/constraints/neighbours.h"

#include <algorithm>

namespace wuerfel {

int box_count(const System& system) {
  int count = system.cubes;
  while (count < system.count() && system.body(count).kind != BodyKind::plane)
    ++count;
  return count;
}

std::span<const IndexPair> Neighbours::pairs_with_cubes(const System& system) {
  const std::vector<IndexPair>& pairs = broad_phase_.overlapping_pairs(bounds_);
  const auto end = std::ranges::lower_bound(pairs, IndexPair{system.cubes, 0});
  if (system.all_may_touch()) return {pairs.begin(), end};
  may_touch_.clear();
  std::copy_if(pairs.begin(), end, std::back_inserter(may_touch_),
               [&](const IndexPair& pair) { return system.may_touch(pair.first, pair.second); });
  return may_touch_;
}

}  // namespace wuerfel
