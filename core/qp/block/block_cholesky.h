/// Sparse Cholesky factors K = L D L' of matrices of 3x3 blocks. The symbolic part is kept as long
/// as patterns fit into it.
#pragma once

#include <vector>

#include "core/qp/block/block_kernels.h"
#include "core/qp/block/block_pattern.h"

namespace wuerfel {

class BlockCholesky {
 public:
  explicit BlockCholesky(const BlockKernels& kernels) : kernels_(&kernels) {}

  /// Plans the factors of matrices whose blocks (a, b) are coupled where `neighbour` says so (as in
  /// elimination_order). `order` becomes the order of elimination, in which all that follows is
  /// numbered.
  void plan(int blocks,
            const std::vector<int>& start,
            const std::vector<int>& neighbour,
            std::vector<int>& order);

  /// Place of block (row, column), row >= column, both in the order of elimination; -1 if it is not
  /// in the pattern of L.
  [[nodiscard]] int place(int row, int column) const { return pattern_.place(row, column); }
  [[nodiscard]] int blocks() const { return pattern_.blocks; }
  /// Number of blocks of L.
  [[nodiscard]] int fill() const { return pattern_.fill(); }

  /// K = I + sum_i d_i g_i g_i'.
  void factorise(const BlockRows& rows, const double* d);
  /// v := K^-1 v.
  void solve(Quad* v) { kernels_->solve(view(), v); }

 private:
  [[nodiscard]] BlockFactor view();

  const BlockKernels* kernels_;
  BlockPattern pattern_;
  std::vector<Quad> L_, pivot_, inverse_;
  std::vector<int> place_of_;
};

}  // namespace wuerfel
