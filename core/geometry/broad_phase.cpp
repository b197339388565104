#include "core/geometry/broad_phase.h"

#include <algorithm>

namespace wuerfel {
namespace {

constexpr int leaf_size = 4;

const BoundingBox& at(std::span<const BoundingBox> bounds, int i) {
  return bounds[static_cast<std::size_t>(i)];
}

}  // namespace

int BroadPhase::build(std::span<const BoundingBox> bounds, int begin, int end) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  const auto first = order_.begin();
  BoundingBox all = at(bounds, first[begin]);
  BoundingBox centers{all.low + all.high, all.low + all.high};
  for (int i = begin + 1; i < end; ++i) {
    const BoundingBox& b = at(bounds, first[i]);
    all.low = all.low.cwiseMin(b.low);
    all.high = all.high.cwiseMax(b.high);
    centers.low = centers.low.cwiseMin(b.low + b.high);
    centers.high = centers.high.cwiseMax(b.low + b.high);
  }
  int right = -1;
  if (end - begin > leaf_size) {
    const Vec2 spread = centers.high - centers.low;
    const int axis = spread.x() >= spread.y() ? 0 : 1;
    const int middle = begin + (end - begin) / 2;
    // The index breaks ties, so that the tree is the same on every machine.
    std::nth_element(first + begin, first + middle, first + end, [&](int i, int j) {
      const double a = at(bounds, i).low[axis] + at(bounds, i).high[axis];
      const double b = at(bounds, j).low[axis] + at(bounds, j).high[axis];
      return a < b || (a == b && i < j);
    });
    build(bounds, begin, middle);
    right = build(bounds, middle, end);
  }
  nodes_[static_cast<std::size_t>(index)] = {all, begin, end, right};
  return index;
}

void BroadPhase::query(std::span<const BoundingBox> bounds, int leaf_item) {
  const BoundingBox& mine = at(bounds, leaf_item);
  stack_.assign(1, 0);
  while (!stack_.empty()) {
    const int index = stack_.back();
    stack_.pop_back();
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (!node.bounds.overlaps(mine)) continue;
    if (node.right >= 0) {
      stack_.push_back(index + 1);
      stack_.push_back(node.right);
      continue;
    }
    for (int i = node.begin; i < node.end; ++i) {
      const int other = order_[static_cast<std::size_t>(i)];
      if (other > leaf_item && at(bounds, other).overlaps(mine)) {
        pairs_.emplace_back(leaf_item, other);
      }
    }
  }
}

const std::vector<IndexPair>& BroadPhase::overlapping_pairs(std::span<const BoundingBox> bounds) {
  pairs_.clear();
  nodes_.clear();
  const int n = static_cast<int>(bounds.size());
  if (n < 2) return pairs_;
  order_.resize(bounds.size());
  for (int i = 0; i < n; ++i) {
    order_[static_cast<std::size_t>(i)] = i;
  }
  build(bounds, 0, n);
  for (int i = 0; i < n; ++i) {
    const auto begin = static_cast<std::ptrdiff_t>(pairs_.size());
    query(bounds, i);
    std::sort(pairs_.begin() + begin, pairs_.end());
  }
  return pairs_;
}

std::vector<IndexPair> overlapping_pairs_brute_force(std::span<const BoundingBox> bounds) {
  std::vector<IndexPair> pairs;
  const int n = static_cast<int>(bounds.size());
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      if (at(bounds, i).overlaps(at(bounds, j))) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

}  // namespace wuerfel
