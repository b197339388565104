/// The inner loops of the solvers on blocks of three unknowns, twice: for every x86-64 and for
/// AVX2.
///
/// A vector of three is padded to four doubles and a 3x3 block is stored by columns, so that a
/// column is one AVX2 register. Both versions do the same operations in the same order on every
/// element, without fused multiply-add, and so give the same bits.
#pragma once

namespace wuerfel {

/// Three unknowns and a zero. No initialisers: they would be an inline function, compiled for AVX2
/// in one place.
struct alignas(32) Quad {
  double v[4];
};

/// The rows g_i: entries of row i are start[i] .. start[i+1]-1, in increasing blocks.
struct BlockRows {
  int rows = 0;
  int blocks = 0;
  const int* start = nullptr;
  const int* block = nullptr;
  const Quad* g = nullptr;
  /// Where the outer products of a row's entries go in the matrix: for entries a <= b of the row, a
  /// outermost, the place of block (b, a). k (k + 1) / 2 for a row of k entries.
  const int* pair = nullptr;
};

/// K = L D L' with unit lower triangular L of 3x3 blocks and diagonal D. Column j of L is
/// column_start[j] .. column_start[j+1]-1; the first of these is the diagonal block, the others
/// have increasing rows.
struct BlockFactor {
  int blocks = 0;
  const int* column_start = nullptr;
  const int* row = nullptr;
  /// Blocks (j, k), k < j, of row j: entries list_start[j] .. list_start[j+1]-1 name k and the
  /// place of the block.
  const int* list_start = nullptr;
  const int* list_column = nullptr;
  const int* list_place = nullptr;
  Quad* L = nullptr;        ///< three per block
  Quad* pivot = nullptr;    ///< D
  Quad* inverse = nullptr;  ///< 1 / D
  int* place_of = nullptr;  ///< scratch, blocks
};

struct BlockKernels {
  /// out_i = <g_i, y>
  void (*apply)(const BlockRows& rows, const Quad* y, double* out);
  /// out = sum_i factor_i g_i
  void (*apply_transposed)(const BlockRows& rows, const double* factor, Quad* out);
  /// K = I + sum_i d_i g_i g_i' into the places of L, `places` blocks in all
  void (*assemble)(const BlockRows& rows, const double* d, const BlockFactor& factor);
  /// K -> L, D, in place. A pivot that rounding has eaten is set to 1e64, which freezes its
  /// unknown.
  void (*factorise)(const BlockFactor& factor);
  /// v := K^-1 v
  void (*solve)(const BlockFactor& factor, Quad* v);
};

const BlockKernels& plain_block_kernels();
/// Must not be called on a CPU without AVX2.
const BlockKernels& avx2_block_kernels();
/// The fastest that this CPU can run.
const BlockKernels& best_block_kernels();

}  // namespace wuerfel
