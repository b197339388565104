#include "core/qp/methods/row_order.h"

#include <algorithm>
#include <cstddef>

namespace wuerfel {
namespace {

class Walk {
 public:
  explicit Walk(const RowsOnBlocks& rows)
      : rows_(rows), degree_(rows.row.size(), 0), seen_(rows.row.size(), 0) {
    for (const std::vector<int>& sharing : rows.rows_of_block) {
      for (const int i : sharing)
        degree_[i] += static_cast<int>(sharing.size());
    }
  }

  [[nodiscard]] bool has_seen(int i) const { return seen_[i] != 0; }
  void forget(int i) { seen_[i] = 0; }

  /// Appends the rows reached from `start`, level by level.
  void go(int start, std::vector<int>& order) {
    std::size_t next = order.size();
    order.push_back(start);
    seen_[start] = 1;
    while (next < order.size()) {
      const auto first = static_cast<std::ptrdiff_t>(order.size());
      add_neighbours(rows_.row[order[next++]], order);
      std::sort(order.begin() + first, order.end(), [this](int a, int b) { return before(a, b); });
    }
  }

 private:
  [[nodiscard]] bool before(int a, int b) const {
    return degree_[a] != degree_[b] ? degree_[a] < degree_[b] : a < b;
  }

  void add_neighbours(int row, std::vector<int>& order) {
    for (int e = rows_.row_start[row]; e < rows_.row_start[row + 1]; ++e) {
      for (const int other : rows_.rows_of_block[rows_.entry_block[e]]) {
        if (seen_[other] != 0) continue;
        seen_[other] = 1;
        order.push_back(other);
      }
    }
  }

  const RowsOnBlocks& rows_;
  std::vector<int> degree_;
  std::vector<char> seen_;
};

}  // namespace

void find_row_order(const RowsOnBlocks& rows, std::vector<int>& order) {
  Walk walk(rows);
  order.clear();
  std::vector<int> far;
  for (int i = 0; i < static_cast<int>(rows.row.size()); ++i) {
    if (walk.has_seen(i)) continue;
    // The last row that is reached is a good end to begin from.
    far.clear();
    walk.go(i, far);
    for (const int reached : far)
      walk.forget(reached);
    walk.go(far.back(), order);
  }
  std::ranges::reverse(order);
  for (int& i : order)
    i = rows.row[i];
}

}  // namespace wuerfel
