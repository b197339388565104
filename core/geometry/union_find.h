/// Disjoint sets of numbers 0 .. n - 1, with path halving [Tarjan, van Leeuwen 1984].
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace wuerfel {

class UnionFind {
 public:
  explicit UnionFind(int size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The smallest number of the set of i, whatever the order in which sets were united.
  int root(int i) {
    while (parent_[i] != i) {
      int& up = parent_[i];
      up = parent_[up];
      i = up;
    }
    return i;
  }
  /// Makes one set of those of i and j; false where they were one before.
  bool unite(int i, int j) {
    const int a = root(i);
    const int b = root(j);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace wuerfel
