#include "core/qp/block/block_pattern.h"

#include <algorithm>

#include "core/qp/block/elimination_order.h"

namespace wuerfel {

void BlockPattern::plan(int count,
                        const std::vector<int>& start,
                        const std::vector<int>& neighbour,
                        std::vector<int>& order) {
  blocks = count;
  elimination_order(blocks, start, neighbour, order);
  find_columns(start, neighbour, order);
  list_rows();
}

/// Column j holds what K has there and what its children in the elimination tree pass on: all but
/// themselves.
void BlockPattern::find_columns(const std::vector<int>& start,
                                const std::vector<int>& neighbour,
                                const std::vector<int>& order) {
  position_.resize(blocks);
  for (int j = 0; j < blocks; ++j)
    position_[order[j]] = j;
  mark_.assign(blocks, -1);
  first_child_.assign(blocks, -1);
  next_sibling_.assign(blocks, -1);
  column_start.assign(1, 0);
  row.clear();
  for (int j = 0; j < blocks; ++j) {
    const auto first = std::ssize(row);
    const auto add = [&](int i) {
      if (i < j || mark_[i] == j) return;
      mark_[i] = j;
      row.push_back(i);
    };
    add(j);
    for (int e = start[order[j]]; e < start[order[j] + 1]; ++e)
      add(position_[neighbour[e]]);
    for (int child = first_child_[j]; child >= 0; child = next_sibling_[child]) {
      for (int q = column_start[child] + 1; q < column_start[child + 1]; ++q)
        add(row[q]);
    }
    std::sort(row.begin() + first, row.end());
    column_start.push_back(static_cast<int>(row.size()));
    if (std::ssize(row) == first + 1) continue;
    const int parent = row[first + 1];
    next_sibling_[j] = first_child_[parent];
    first_child_[parent] = j;
  }
}

void BlockPattern::list_rows() {
  list_start.assign(blocks + 1, 0);
  for (int j = 0; j < blocks; ++j) {
    for (int q = column_start[j] + 1; q < column_start[j + 1]; ++q)
      ++list_start[row[q] + 1];
  }
  for (int j = 0; j < blocks; ++j)
    list_start[j + 1] += list_start[j];
  list_column.resize(list_start.back());
  list_place.resize(list_start.back());
  std::copy(list_start.begin(), list_start.end() - 1, mark_.begin());
  for (int j = 0; j < blocks; ++j) {
    for (int q = column_start[j] + 1; q < column_start[j + 1]; ++q) {
      const int l = mark_[row[q]]++;
      list_column[l] = j;
      list_place[l] = q;
    }
  }
}

int BlockPattern::place(int i, int column) const {
  const auto first = row.begin() + column_start[column];
  const auto last = row.begin() + column_start[column + 1];
  const auto found = std::lower_bound(first, last, i);
  return found != last && *found == i ? static_cast<int>(found - row.begin()) : -1;
}

}  // namespace wuerfel
