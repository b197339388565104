#include "core/qp/coulomb/block_lu.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/qp/block/clones.h"
#include "core/qp/block/column.h"

namespace wuerfel {
namespace {

/// The columns of a block. An array of them would be copied through memory.
struct Columns {
  Column c0, c1, c2;
};
inline void load(const Quad* A, Columns& to) {
  load(A[0], to.c0);
  load(A[1], to.c1);
  load(A[2], to.c2);
}

/// C -= A B', blocks of three columns.
inline void subtract_product(const Quad* A, const Quad* B, Quad* C) {
  Columns a{};
  load(A, a);
  for (int c = 0; c < 3; ++c) {
    Column column;
    load(C[c], column);
    column -= (a.c0 * B[0].v[c] + a.c1 * B[1].v[c]) + a.c2 * B[2].v[c];
    store(column, C[c]);
  }
}

/// A row of [A X] on the way from [A I] to [I A^-1].
struct Row {
  Column left, right;
};

/// Puts the row with the largest entry in column k in the k-th place; the sign of that exchange, 0 where all are zero.
inline int bring_up_pivot(int k, Row (&a)[3]) {
  int best = k;
  for (int r = k + 1; r < 3; ++r)
    if (std::abs(a[r].left[k]) > std::abs(a[best].left[k])) best = r;
  if (!(std::abs(a[best].left[k]) > 0.0)) return 0;
  if (best == k) return 1;
  std::swap(a[k], a[best]);
  return -1;
}

/// Makes column k one of the identity; columns before it are not looked at any more.
inline void eliminate(int k, Row (&a)[3]) {
  const double inverse = 1.0 / a[k].left[k];
  a[k].left *= inverse;
  a[k].right *= inverse;
  for (int r = 0; r < 3; ++r) {
    if (r == k) continue;
    const double f = a[r].left[k];
    a[r].left -= f * a[k].left;
    a[r].right -= f * a[k].right;
  }
}

/// Inverse of a 3x3 block by Gauss-Jordan with pivoting; returns the sign of its determinant, 0
/// where it has none.
inline int invert(const Quad* A, Quad* X) {
  Row a[3];
  for (int r = 0; r < 3; ++r) {
    a[r].left = Column{A[0].v[r], A[1].v[r], A[2].v[r], 0.0};
    a[r].right = Column{};
    a[r].right[r] = 1.0;
  }
  int sign = 1;
  for (int k = 0; k < 3; ++k) {
    sign *= bring_up_pivot(k, a);
    if (sign == 0) return 0;
    if (a[k].left[k] < 0.0) sign = -sign;
    eliminate(k, a);
  }
  for (int c = 0; c < 3; ++c)
    X[c] = Quad{{a[0].right[c], a[1].right[c], a[2].right[c], 0.0}};
  return sign;
}

/// C := C X, three columns each.
inline void multiply(Quad* C, const Quad* X) {
  Columns columns{};
  load(C, columns);
  for (int c = 0; c < 3; ++c)
    store((columns.c0 * X[c].v[0] + columns.c1 * X[c].v[1]) + columns.c2 * X[c].v[2], C[c]);
}

inline void transpose(Quad* A) {
  std::swap(A[0].v[1], A[1].v[0]);
  std::swap(A[0].v[2], A[2].v[0]);
  std::swap(A[1].v[2], A[2].v[1]);
}

/// column -= A x
inline void subtract_product(const Quad* A, const double* x, Column& column) {
  Columns a{};
  load(A, a);
  column -= (a.c0 * x[0] + a.c1 * x[1]) + a.c2 * x[2];
}

}  // namespace

void BlockLu::plan(int blocks,
                   const std::vector<int>& start,
                   const std::vector<int>& neighbour,
                   std::vector<int>& order) {
  pattern_.plan(blocks, start, neighbour, order);
  lower_.resize(3 * pattern_.row.size());
  upper_.resize(3 * pattern_.row.size());
  inverse_.resize(3 * order.size());
  place_of_.resize(order.size());
}

void BlockLu::set_identity() {
  std::fill(lower_.begin(), lower_.end(), Quad{});
  std::fill(upper_.begin(), upper_.end(), Quad{});
  for (int j = 0; j < pattern_.blocks; ++j) {
    for (int c = 0; c < 3; ++c)
      lower(pattern_.column_start[j])[c].v[c] = 1.0;
  }
}

/// Left-looking: column j of L and row j of U, then the 3x3 pivot; L is divided by it.
WUERFEL_CLONES bool BlockLu::factorise() {
  sign_ = 1;
  bool regular = true;
  for (int j = 0; j < pattern_.blocks; ++j) {
    const int diagonal = pattern_.column_start[j];
    const int end = pattern_.column_start[j + 1];
    for (int q = diagonal; q < end; ++q)
      place_of_[pattern_.row[q]] = q;
    for (int l = pattern_.list_start[j]; l < pattern_.list_start[j + 1]; ++l) {
      const int k = pattern_.list_column[l];
      const int place = pattern_.list_place[l];
      const Quad* L_jk = lower_.data() + 3 * place;
      const Quad* U_kj = upper_.data() + 3 * place;
      subtract_product(L_jk, U_kj, lower_.data() + 3 * diagonal);
      for (int q = place + 1; q < pattern_.column_start[k + 1]; ++q) {
        const int to = 3 * place_of_[pattern_.row[q]];
        subtract_product(lower_.data() + 3 * q, U_kj, lower_.data() + to);
        subtract_product(upper_.data() + 3 * q, L_jk, upper_.data() + to);
      }
    }
    Quad* X = inverse_.data() + 3 * j;
    const int sign = invert(lower_.data() + 3 * diagonal, X);
    sign_ *= sign;
    if (sign == 0) {
      regular = false;
      for (int c = 0; c < 3; ++c)
        X[c] = Quad{};
    }
    for (int q = diagonal + 1; q < end; ++q)
      multiply(lower_.data() + 3 * q, X);
  }
  // Rows were read by entries until now; `solve` adds up columns.
  for (std::size_t q = 0; q < pattern_.row.size(); ++q)
    transpose(upper_.data() + 3 * q);
  return regular;
}

WUERFEL_CLONES void BlockLu::solve(Quad* v) const {
  const int* const start = pattern_.column_start.data();
  const int* const row = pattern_.row.data();
  for (int j = 0; j < pattern_.blocks; ++j) {
    const Quad z = v[j];
    // Of a single contact most blocks are not reached.
    if (z.v[0] == 0.0 && z.v[1] == 0.0 && z.v[2] == 0.0) continue;
    for (int q = start[j] + 1; q < start[j + 1]; ++q) {
      Column t;
      load(v[row[q]], t);
      subtract_product(lower_.data() + 3 * q, z.v, t);
      store(t, v[row[q]]);
    }
  }
  for (int j = pattern_.blocks - 1; j >= 0; --j) {
    Column t;
    load(v[j], t);
    for (int q = start[j] + 1; q < start[j + 1]; ++q)
      subtract_product(upper_.data() + 3 * q, v[row[q]].v, t);
    Columns X{};
    load(inverse_.data() + 3 * j, X);
    store((X.c0 * t[0] + X.c1 * t[1]) + X.c2 * t[2], v[j]);
  }
}

}  // namespace wuerfel
