#include "core/geometry/broad_phase.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace wuerfel {
namespace {

constexpr int leaf_size = 4;
/// Margin of the larger bounds, as a share of the smaller extent.
constexpr double margin_share = 0.2;

const BoundingBox& at(std::span<const BoundingBox> bounds, int i) { return bounds[i]; }

}  // namespace

bool BroadPhase::still_serve(std::span<const BoundingBox> bounds) const {
  if (bounds.size() != large_.size()) return false;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const BoundingBox& b = bounds[i];
    const BoundingBox& large = large_[i];
    // Written so that a number that is none does not serve.
    const bool inside = b.low.x() >= large.low.x() && b.low.y() >= large.low.y()
                        && b.high.x() <= large.high.x() && b.high.y() <= large.high.y();
    if (!inside) return false;
  }
  return true;
}

int BroadPhase::build(int begin, int end) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  const auto first = order_.begin();
  BoundingBox all = at(large_, first[begin]);
  BoundingBox centers{all.low + all.high, all.low + all.high};
  for (int i = begin + 1; i < end; ++i) {
    const BoundingBox& b = at(large_, first[i]);
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
      const double a = at(large_, i).low[axis] + at(large_, i).high[axis];
      const double b = at(large_, j).low[axis] + at(large_, j).high[axis];
      return a < b || (a == b && i < j);
    });
    build(begin, middle);
    right = build(middle, end);
  }
  nodes_[index] = {all, begin, end, right};
  return index;
}

/// Pairs of a leaf with itself and with the leaves after it.
void BroadPhase::query(int leaf) {
  const Node& mine = nodes_[leaf];
  stack_.assign(1, 0);
  while (!stack_.empty()) {
    const int index = stack_.back();
    stack_.pop_back();
    const Node& node = nodes_[index];
    if (node.end <= mine.begin || !node.bounds.overlaps(mine.bounds)) continue;
    if (node.right >= 0) {
      stack_.push_back(index + 1);
      stack_.push_back(node.right);
      continue;
    }
    for (int k = mine.begin; k < mine.end; ++k) {
      const int i = order_[k];
      for (int m = std::max(node.begin, k + 1); m < node.end; ++m) {
        const int j = order_[m];
        if (at(large_, i).overlaps(at(large_, j))) unsorted_.emplace_back(std::minmax(i, j));
      }
    }
  }
}

/// By counting the first numbers; the few pairs of one are sorted as such.
void BroadPhase::sort_near_pairs() {
  place_.assign(large_.size() + 1, 0);
  for (const IndexPair& pair : unsorted_)
    ++place_[pair.first + 1];
  std::partial_sum(place_.begin(), place_.end(), place_.begin());
  near_.resize(unsorted_.size());
  for (const IndexPair& pair : unsorted_)
    near_[place_[pair.first]++] = pair;
  // Each place has moved to where the next one began.
  std::ptrdiff_t begin = 0;
  for (std::size_t i = 0; i < large_.size(); ++i) {
    const std::ptrdiff_t end = place_[i];
    std::sort(near_.begin() + begin, near_.begin() + end);
    begin = end;
  }
}

void BroadPhase::find_near_pairs(std::span<const BoundingBox> bounds) {
  large_.clear();
  for (const BoundingBox& b : bounds) {
    const Vec2 margin = Vec2::Constant(margin_share * (b.high - b.low).minCoeff());
    large_.push_back({b.low - margin, b.high + margin});
  }
  nodes_.clear();
  unsorted_.clear();
  const int n = static_cast<int>(bounds.size());
  order_.resize(bounds.size());
  std::iota(order_.begin(), order_.end(), 0);
  build(0, n);
  for (int index = 0; index < static_cast<int>(nodes_.size()); ++index) {
    if (nodes_[index].right < 0) query(index);
  }
  sort_near_pairs();
}

const std::vector<IndexPair>& BroadPhase::overlapping_pairs(std::span<const BoundingBox> bounds) {
  pairs_.clear();
  if (bounds.size() < 2) return pairs_;
  if (!still_serve(bounds)) find_near_pairs(bounds);
  for (const IndexPair& pair : near_) {
    if (at(bounds, pair.first).overlaps(at(bounds, pair.second))) pairs_.push_back(pair);
  }
  return pairs_;
}

}  // namespace wuerfel
