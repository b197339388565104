/// Which bodies may touch: bounds of the boxes, and the pairs whose bounds overlap. Planes have no
/// bounds; they are everybody's neighbours.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/broad_phase.h"
#include "core/model/system.h"

namespace wuerfel {

/// Number of the bodies that are boxes: cubes first, then fixed ones.
int box_count(const System& system);

/// Keeps its memory, nothing that changes an answer, from call to call.
class Neighbours {
 public:
  /// Pairs (i, j), i < j, i a cube and j a cube or a fixed box, in ascending order, of which
  /// `bounds_of(i)` and `bounds_of(j)` overlap and that
  /// may touch.
  template <typename BoundsOf>
  std::span<const IndexPair> find(const System& system, BoundsOf&& bounds_of) {
    bounds_.clear();
    for (int i = 0; i < box_count(system); ++i)
      bounds_.push_back(bounds_of(i));
    return pairs_with_cubes(system);
  }

 private:
  std::span<const IndexPair> pairs_with_cubes(const System& system);

  std::vector<BoundingBox> bounds_;
  std::vector<IndexPair> may_touch_;
  BroadPhase broad_phase_;
};

}  // namespace wuerfel
