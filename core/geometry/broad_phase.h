/// Which boxes are near enough to matter: all pairs of overlapping axis-aligned bounds.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/geometry/bounds.h"

namespace wuerfel {

using IndexPair = std::pair<int, int>;

/// Finds overlapping pairs with a balanced tree of bounds (median split of the centres); O(N log N
/// + pairs) whatever the sizes and the arrangement. Keeps its memory from call to call, and the
/// pairs of somewhat larger bounds, which serve until one of the bounds has left its larger one.
class BroadPhase {
 public:
  /// Pairs (i, j), i < j, in ascending order.
  const std::vector<IndexPair>& overlapping_pairs(std::span<const BoundingBox> bounds);

 private:
  struct Node {
    BoundingBox bounds;
    int begin = 0;  ///< range of order_ below this node
    int end = 0;
    int right = -1;  ///< right child; the left one follows its parent; -1: leaf
  };
  [[nodiscard]] bool still_serve(std::span<const BoundingBox> bounds) const;
  void find_near_pairs(std::span<const BoundingBox> bounds);
  int build(int begin, int end);
  void query(int leaf);
  void sort_near_pairs();

  std::vector<BoundingBox> large_;  ///< bounds with a margin
  std::vector<int> order_;
  std::vector<Node> nodes_;
  std::vector<int> stack_;
  std::vector<IndexPair> near_;  ///< pairs of the large ones, ascending
  std::vector<IndexPair> unsorted_;
  std::vector<int> place_;
  std::vector<IndexPair> pairs_;
};

}  // namespace wuerfel
