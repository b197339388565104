/// Sparse factors K = L D U of non-symmetric matrices of 3x3 blocks with a symmetric pattern: what
/// BlockCholesky is for K = I + G' D G, for contacts that slip. No pivoting beyond the 3x3 blocks;
/// what that loses is for iterative refinement to find. [Davis 2006, ch. 4, 6]
#pragma once

#include <vector>

#include "core/qp/block/block_kernels.h"
#include "core/qp/block/block_pattern.h"

namespace wuerfel {

class BlockLu {
 public:
  /// Plans factors of matrices whose blocks are coupled where `neighbour` says so (as in
  /// elimination_order). `order` becomes the order of elimination, in which all that follows is
  /// numbered.
  void plan(int blocks,
            const std::vector<int>& start,
            const std::vector<int>& neighbour,
            std::vector<int>& order);
  /// Place of block (row, column), row >= column; -1 if it is not in the pattern.
  [[nodiscard]] int place(int row, int column) const { return pattern_.place(row, column); }

  /// K := I; K is then filled through `lower` and `upper`.
  void set_identity();
  /// Three columns of block (row, column) at a place.
  [[nodiscard]] Quad* lower(int place) { return lower_.data() + 3 * place; }
  /// Three columns of the transpose of block (column, row) at a place below the diagonal, until it is factorised.
  [[nodiscard]] Quad* upper(int place) { return upper_.data() + 3 * place; }
  /// Factorises in place; false where a pivot vanished.
  bool factorise();
  /// The sign of det K.
  [[nodiscard]] int sign() const { return sign_; }
  /// v := K^-1 v
  void solve(Quad* v) const;

 private:
  BlockPattern pattern_;
  int sign_ = 1;
  std::vector<int> place_of_;
  std::vector<Quad> lower_, upper_, inverse_;  ///< inverse: of the diagonal blocks, three columns
};

}  // namespace wuerfel
