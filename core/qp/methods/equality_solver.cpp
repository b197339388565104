#include "core/qp/methods/equality_solver.h"

#include <algorithm>
#include <cmath>

#include "core/qp/block/clones.h"
#include "core/qp/block/column.h"
#include "core/qp/methods/few_rows.h"
#include "core/qp/methods/row_order.h"
#include "core/qp/refinement.h"

namespace wuerfel {
namespace {

constexpr int lanes = sizeof(Column) / sizeof(double);

/// Sum in four parts, which go on side by side.
inline double dot(const double* a, const double* b, int n) {
  Column sum = {0.0, 0.0, 0.0, 0.0};
  int k = 0;
  for (; k + lanes <= n; k += lanes) {
    Column x;
    Column y;
    load(a + k, x);
    load(b + k, y);
    sum += x * y;
  }
  double first = sum[0];
  for (; k < n; ++k)
    first += a[k] * b[k];
  return (first + sum[1]) + (sum[2] + sum[3]);
}

/// r -= a * factor, n numbers.
inline void subtract(const double* a, double factor, int n, double* r) {
  int k = 0;
  for (; k + lanes <= n; k += lanes) {
    Column x;
    Column y;
    load(a + k, x);
    load(r + k, y);
    store(y - x * factor, r + k);
  }
  for (; k < n; ++k)
    r[k] -= a[k] * factor;
}

/// x += M^-1 row' * factor.
void add_push(const QuadraticProgram& p, int row, double factor, double* x) {
  const double* mass = p.mass.data();
  p.for_each_entry(row, [&](const double* J, int first, int size) {
    for (int c = 0; c < size; ++c)
      x[first + c] += J[c] * factor / mass[first + c];
  });
}

/// So many lists, which keep their memory.
template <typename T>
void empty(int count, std::vector<std::vector<T>>& lists) {
  lists.resize(count);
  for (std::vector<T>& list : lists)
    list.clear();
}

}  // namespace

bool EqualitySolver::fits(const QuadraticProgram& p, const std::vector<char>* tight) const {
  const bool same_tight = tight != nullptr ? tight_ == *tight : tight_.empty();
  return same_tight && row_start_ == p.row_start && entry_block_ == p.entry_block;
}

/// Of the rows at the places i and j of the order.
void EqualitySolver::add_couplings(int i, int j) {
  for (int e = row_start_[order_[i]]; e < row_start_[order_[i] + 1]; ++e) {
    for (int f = row_start_[order_[j]]; f < row_start_[order_[j] + 1]; ++f) {
      if (entry_block_[e] == entry_block_[f])
        couplings_.push_back({place(i, j), entry_block_[e], e, f});
    }
  }
}

/// The whole lower triangle, for few rows: there is nothing to be saved by an order.
void EqualitySolver::fill_triangle() {
  const int rows = static_cast<int>(row_.size());
  order_ = row_;
  couplings_.clear();
  couplings_.reserve(rows * (rows + 1));
  first_.assign(rows, 0);
  start_.resize(rows);
  for (int i = 0; i < rows; ++i) {
    start_[i] = i * (i + 1) / 2;
    for (int j = 0; j <= i; ++j)
      add_couplings(i, j);
  }
  factor_.resize(rows * (rows + 1) / 2);
  inverse_.resize(rows);
}

void EqualitySolver::find_envelope() {
  const int rows = static_cast<int>(row_.size());
  const int blocks = entry_block_.empty() ? 0 : std::ranges::max(entry_block_) + 1;
  empty(blocks, rows_of_block_);
  empty(blocks, entries_of_block_);
  for (int i = 0; i < rows; ++i) {
    for (int e = row_start_[row_[i]]; e < row_start_[row_[i] + 1]; ++e)
      rows_of_block_[entry_block_[e]].push_back(i);
  }
  find_row_order({row_, row_start_, entry_block_, rows_of_block_}, order_);
  couplings_.clear();
  first_.resize(rows);
  start_.resize(rows);
  std::ptrdiff_t size = 0;
  for (int i = 0; i < rows; ++i) {
    first_[i] = i;
    for (int e = row_start_[order_[i]]; e < row_start_[order_[i] + 1]; ++e) {
      auto& others = entries_of_block_[entry_block_[e]];
      others.push_back({i, e});
      first_[i] = std::min(first_[i], others.front().i);
    }
    start_[i] = size - first_[i];
    size += i - first_[i] + 1;
    for (int e = row_start_[order_[i]]; e < row_start_[order_[i] + 1]; ++e) {
      for (const Entry& other : entries_of_block_[entry_block_[e]])
        couplings_.push_back({place(i, other.i), entry_block_[e], e, other.entry});
    }
  }
  factor_.resize(size);
  inverse_.resize(rows);
}

// Few rows are solved again and again, at every look at a smooth motion: calls count there.

/// J M^-1 J' over the tight rows, in the order of elimination.
inline void EqualitySolver::assemble(const QuadraticProgram& p) {
  for (double& f : factor_)
    f = 0.0;
  const auto add_products = [&](int size) {
    const double* J = p.coefficients.data();
    const double* mass = p.mass.data();
    double* factor = factor_.data();
    for (const Coupling& c : couplings_) {
      const double* g = J + c.entry_i * size;
      const double* h = J + c.entry_j * size;
      const double* m = mass + c.block * size;
      double sum = 0.0;
      for (int k = 0; k < size; ++k)
        sum += g[k] * h[k] / m[k];
      factor[c.place] += sum;
    }
  };
  if (p.block_size == cube_size) {
    add_products(cube_size);  // known to the compiler it is faster
  } else {
    add_products(p.block_size);
  }
}

void EqualitySolver::factorise(const QuadraticProgram& p, const std::vector<char>* tight) {
  if (!fits(p, tight)) {
    row_start_ = p.row_start;
    entry_block_ = p.entry_block;
    tight_.clear();
    if (tight != nullptr) tight_ = *tight;
    row_.clear();
    for (int row = 0; row < p.rows(); ++row)
      if (tight == nullptr || (*tight)[row] != 0) row_.push_back(row);
    if (std::ssize(row_) <= few_rows) {
      fill_triangle();
    } else {
      find_envelope();
    }
  }
  factorise_again(p);
}

WUERFEL_CLONES void EqualitySolver::factorise_again(const QuadraticProgram& p) {
  assemble(p);
  dependent_ = 0;
  for (int i = 0; i < static_cast<int>(row_.size()); ++i) {
    const int first = first_[i];
    double* row = &factor_[place(i, first)];
    double squares = 0.0;
    for (int j = first; j < i; ++j) {
      const int from = std::max(first, first_[j]);
      const double* a = row + (from - first);
      const double* b = &factor_[place(j, from)];
      const double sum = (row[j - first] - dot(a, b, j - from)) * inverse_[j];
      row[j - first] = sum;
      squares += sum * sum;
    }
    const double diagonal = row[i - first];
    const double pivot = diagonal - squares;
    const bool independent = pivot > dependent_share * diagonal;
    if (!independent) ++dependent_;
    row[i - first] = independent ? std::sqrt(pivot) : 0.0;
    inverse_[i] = independent ? 1.0 / row[i - first] : 0.0;
  }
}

/// r := S^-1 r over the rows that are kept, 0 on the others.
WUERFEL_CLONES void EqualitySolver::substitute(std::vector<double>& r) const {
  const int rows = static_cast<int>(r.size());
  for (int i = 0; i < rows; ++i) {
    double sum = r[i];
    for (int j = first_[i]; j < i; ++j)
      sum -= at(i, j) * r[j];
    r[i] = sum * inverse_[i];
  }
  for (int i = rows - 1; i >= 0; --i) {
    const double x = r[i] * inverse_[i];
    r[i] = x;
    subtract(factor_.data() + place(i, first_[i]), x, i - first_[i], r.data() + first_[i]);
  }
}

/// What the rows miss at x, into `residual_`.
inline EqualitySolver::Missed EqualitySolver::find_residual(const QuadraticProgram& p,
                                                            const std::vector<double>& x) {
  Missed missed;
  double* rest = residual_.data();
  const double* inverse = inverse_.data();
  for (const int row : order_) {
    const double b = p.bound[row];
    const double reached = p.row_value(row, x);
    missed.scale = std::max(missed.scale, std::max(std::abs(b), std::abs(reached)));
    *rest = b - reached;
    if (*inverse++ != 0.0) missed.worst = std::max(missed.worst, std::abs(*rest));
    ++rest;
  }
  return missed;
}

/// Moves x = f + M^-1 J' lambda onto the rows, and lambda along.
void EqualitySolver::move_onto_rows(const QuadraticProgram& p,
                                    std::vector<double>& x,
                                    std::vector<double>& multiplier) {
  residual_.resize(order_.size());
  double scale = 0.0;
  for (int round = 0; round <= most_refinements; ++round) {
    const Missed missed = find_residual(p, x);
    if (round == 0) scale = missed.scale;
    if (missed.worst <= refined_share * scale) return;
    substitute(residual_);
    const double* change = residual_.data();
    for (const int row : order_) {
      if (*change != 0.0) {
        multiplier[row] += *change;
        add_push(p, row, *change, x.data());
      }
      ++change;
    }
  }
}

void EqualitySolver::solve(const QuadraticProgram& p,
                           std::vector<double>& x,
                           std::vector<double>& multiplier) {
  if (x.size() != p.target.size()) x.resize(p.target.size());
  const double* f = p.target.data();
  for (double& x_i : x)
    x_i = *f++;
  if (std::ssize(multiplier) != p.rows()) multiplier.resize(p.rows());
  for (double& lambda : multiplier)
    lambda = 0.0;
  const auto rows = std::ssize(order_);
  if (rows > few_rows || p.block_size != cube_size) return move_onto_rows(p, x, multiplier);
  move_onto_few_rows(p, order_, factor_.data(), inverse_.data(), x.data(), multiplier.data());
}

void EqualitySolver::refine(const QuadraticProgram& p,
                            std::vector<double>& x,
                            std::vector<double>& multiplier) {
  x = p.target;
  for (const int row : order_)
    if (multiplier[row] != 0.0) add_push(p, row, multiplier[row], x.data());
  move_onto_rows(p, x, multiplier);
}

}  // namespace wuerfel
