#include "core/qp/block/block_cholesky.h"

#include <algorithm>
#include <cstddef>

#include "core/qp/block/elimination_order.h"

namespace wuerfel {
namespace {}  // namespace

void BlockCholesky::plan(int blocks,
                         const std::vector<int>& start,
                         const std::vector<int>& neighbour,
                         std::vector<int>& order) {
  blocks_ = blocks;
  elimination_order(blocks, start, neighbour, order);
  find_columns(start, neighbour, order);
  list_rows();
  L_.resize(3 * fill());
  pivot_.resize(blocks);
  inverse_.resize(blocks);
  place_of_.resize(blocks);
}

/// Column j holds what K has there and what its children in the elimination tree pass on: all but
/// themselves.
void BlockCholesky::find_columns(const std::vector<int>& start,
                                 const std::vector<int>& neighbour,
                                 const std::vector<int>& order) {
  position_.resize(blocks_);
  for (int j = 0; j < blocks_; ++j)
    position_[order[j]] = j;
  mark_.assign(blocks_, -1);
  first_child_.assign(blocks_, -1);
  next_sibling_.assign(blocks_, -1);
  column_start_.assign(1, 0);
  row_.clear();
  for (int j = 0; j < blocks_; ++j) {
    const auto first = static_cast<std::ptrdiff_t>(row_.size());
    const auto add = [&](int i) {
      if (i < j || mark_[i] == j) return;
      mark_[i] = j;
      row_.push_back(i);
    };
    add(j);
    for (int e = start[order[j]]; e < start[order[j] + 1]; ++e)
      add(position_[neighbour[e]]);
    for (int child = first_child_[j]; child >= 0; child = next_sibling_[child]) {
      for (int q = column_start_[child] + 1; q < column_start_[child + 1]; ++q)
        add(row_[q]);
    }
    std::sort(row_.begin() + first, row_.end());
    column_start_.push_back(static_cast<int>(row_.size()));
    if (static_cast<std::ptrdiff_t>(row_.size()) == first + 1) continue;
    const int parent = row_[first + 1];
    next_sibling_[j] = first_child_[parent];
    first_child_[parent] = j;
  }
}

void BlockCholesky::list_rows() {
  list_start_.assign(blocks_ + 1, 0);
  for (int j = 0; j < blocks_; ++j) {
    for (int q = column_start_[j] + 1; q < column_start_[j + 1]; ++q)
      ++list_start_[row_[q] + 1];
  }
  for (int j = 0; j < blocks_; ++j)
    list_start_[j + 1] += list_start_[j];
  list_column_.resize(list_start_.back());
  list_place_.resize(list_start_.back());
  std::copy(list_start_.begin(), list_start_.end() - 1, mark_.begin());
  for (int j = 0; j < blocks_; ++j) {
    for (int q = column_start_[j] + 1; q < column_start_[j + 1]; ++q) {
      const int l = mark_[row_[q]]++;
      list_column_[l] = j;
      list_place_[l] = q;
    }
  }
}

int BlockCholesky::place(int row, int column) const {
  const auto first = row_.begin() + column_start_[column];
  const auto last = row_.begin() + column_start_[column + 1];
  const auto found = std::lower_bound(first, last, row);
  return found != last && *found == row ? static_cast<int>(found - row_.begin()) : -1;
}

BlockFactor BlockCholesky::view() const {
  return {blocks_,
          column_start_.data(),
          row_.data(),
          list_start_.data(),
          list_column_.data(),
          list_place_.data(),
          L_.data(),
          pivot_.data(),
          inverse_.data(),
          place_of_.data()};
}

void BlockCholesky::factorise(const BlockRows& rows, const double* d) {
  const BlockFactor factor = view();
  kernels_->assemble(rows, d, factor);
  kernels_->factorise(factor);
}

}  // namespace wuerfel
