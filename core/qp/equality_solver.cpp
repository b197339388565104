#include "core/qp/equality_solver.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// A pivot below this share of its diagonal belongs to a row that depends on those before it.
constexpr double dependent_share = 1e-11;

/// Residuals are refined to this share of the bounds and of J f.
constexpr double refined_share = 4e-16;
constexpr int most_refinements = 3;

/// Sum in four parts, which go on side by side.
double dot(const double* a, const double* b, int n) {
  double s0 = 0.0;
  double s1 = 0.0;
  double s2 = 0.0;
  double s3 = 0.0;
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    s0 += a[k] * b[k];
    s1 += a[k + 1] * b[k + 1];
    s2 += a[k + 2] * b[k + 2];
    s3 += a[k + 3] * b[k + 3];
  }
  for (; k < n; ++k)
    s0 += a[k] * b[k];
  return (s0 + s1) + (s2 + s3);
}

/// Row times x.
double product(const QuadraticProgram& p, int row, const std::vector<double>& x) {
  double sum = 0.0;
  const auto block = static_cast<std::size_t>(p.block_size);
  for (int e = p.row_start[row]; e < p.row_start[static_cast<std::size_t>(row) + 1]; ++e) {
    const double* g = p.coefficients.data() + e * block;
    const double* at = x.data() + p.entry_block[e] * block;
    for (std::size_t k = 0; k < block; ++k)
      sum += g[k] * at[k];
  }
  return sum;
}

/// x += M^-1 row' * factor.
void add_push(const QuadraticProgram& p, int row, double factor, std::vector<double>& x) {
  const auto block = static_cast<std::size_t>(p.block_size);
  for (int e = p.row_start[row]; e < p.row_start[static_cast<std::size_t>(row) + 1]; ++e) {
    const double* g = p.coefficients.data() + e * block;
    const std::size_t at = p.entry_block[e] * block;
    for (std::size_t k = 0; k < block; ++k)
      x[at + k] += g[k] * factor / p.mass[at + k];
  }
}

}  // namespace

/// Reverse Cuthill-McKee order of the rows (George and Liu, chapter 4): neighbours, which share a
/// block, get numbers close to each other.
void EqualitySolver::find_order(const std::vector<std::vector<int>>& rows_of_block) {
  const auto rows = row_start_.size() - 1;
  std::vector<int> degree(rows, 0);
  for (const std::vector<int>& sharing : rows_of_block) {
    for (const int row : sharing)
      degree[row] += static_cast<int>(sharing.size());
  }
  const auto before = [&](int a, int b) {
    const int d_a = degree[a];
    const int d_b = degree[b];
    return d_a != d_b ? d_a < d_b : a < b;
  };
  std::vector<char> seen(rows, 0);
  // Rows reached from `start`, level by level, appended to `order`.
  const auto walk = [&](int start, std::vector<int>& order) {
    std::size_t next = order.size();
    order.push_back(start);
    seen[start] = 1;
    while (next < order.size()) {
      const auto row = static_cast<std::size_t>(order[next++]);
      const auto first = static_cast<std::ptrdiff_t>(order.size());
      for (int e = row_start_[row]; e < row_start_[row + 1]; ++e) {
        for (const int other : rows_of_block[entry_block_[e]]) {
          if (seen[other] != 0) continue;
          seen[other] = 1;
          order.push_back(other);
        }
      }
      std::sort(order.begin() + first, order.end(), before);
    }
  };
  order_.clear();
  std::vector<int> far;
  for (std::size_t row = 0; row < rows; ++row) {
    if (seen[row] != 0) continue;
    // The last row that is reached is a good end to begin from.
    far.clear();
    walk(static_cast<int>(row), far);
    for (const int reached : far)
      seen[reached] = 0;
    walk(far.back(), order_);
  }
  std::ranges::reverse(order_);
}

void EqualitySolver::find_envelope(const QuadraticProgram& p) {
  if (row_start_ == p.row_start && entry_block_ == p.entry_block) return;
  row_start_ = p.row_start;
  entry_block_ = p.entry_block;
  couplings_.clear();
  const auto rows = static_cast<std::size_t>(p.rows());
  std::vector<std::vector<int>> rows_of_block(p.blocks());
  for (std::size_t row = 0; row < rows; ++row) {
    for (int e = row_start_[row]; e < row_start_[row + 1]; ++e)
      rows_of_block[entry_block_[e]].push_back(static_cast<int>(row));
  }
  find_order(rows_of_block);
  std::vector<std::vector<std::pair<int, int>>> places_of_block(rows_of_block.size());
  first_.assign(rows, 0);
  start_.assign(rows, 0);
  std::ptrdiff_t size = 0;
  for (int i = 0; i < static_cast<int>(rows); ++i) {
    const auto row = static_cast<std::size_t>(order_[i]);
    int first = i;
    for (int e = row_start_[row]; e < row_start_[row + 1]; ++e) {
      auto& others = places_of_block[entry_block_[e]];
      others.emplace_back(i, e);
      for (const auto& [j, f] : others) {
        couplings_.push_back({i, j, e, f});
        first = std::min(first, j);
      }
    }
    first_[i] = first;
    start_[i] = size - first;
    size += i - first + 1;
  }
  factor_.resize(size);
  inverse_.resize(rows);
}

void EqualitySolver::factorise(const QuadraticProgram& p) {
  find_envelope(p);
  std::ranges::fill(factor_, 0.0);
  const auto block = static_cast<std::size_t>(p.block_size);
  for (const Coupling& c : couplings_) {
    const double* g = p.coefficients.data() + c.entry_i * block;
    const double* h = p.coefficients.data() + c.entry_j * block;
    const double* m = p.mass.data() + entry_block_[c.entry_i] * block;
    double sum = 0.0;
    for (std::size_t k = 0; k < block; ++k)
      sum += g[k] * h[k] / m[k];
    at(c.i, c.j) += sum;
  }
  dependent_ = 0;
  for (int i = 0; i < p.rows(); ++i) {
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
void EqualitySolver::substitute(std::vector<double>& r) const {
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
    for (int j = first_[i]; j < i; ++j)
      r[j] -= at(i, j) * x;
  }
}

void EqualitySolver::solve(const QuadraticProgram& p,
                           std::vector<double>& x,
                           std::vector<double>& multiplier) {
  const auto rows = static_cast<std::size_t>(p.rows());
  x = p.target;
  multiplier.assign(rows, 0.0);
  residual_.resize(rows);
  double scale = 0.0;
  for (int round = 0; round <= most_refinements; ++round) {
    double worst = 0.0;
    for (std::size_t i = 0; i < rows; ++i) {
      const int row = order_[i];
      const double b = p.bound[row];
      const double reached = product(p, row, x);
      residual_[i] = b - reached;
      if (round == 0) scale = std::max({scale, std::abs(b), std::abs(reached)});
      if (inverse_[i] != 0.0) worst = std::max(worst, std::abs(b - reached));
    }
    if (worst <= refined_share * scale) return;
    substitute(residual_);
    for (std::size_t i = 0; i < rows; ++i) {
      if (residual_[i] == 0.0) continue;
      multiplier[order_[i]] += residual_[i];
      add_push(p, order_[i], residual_[i], x);
    }
  }
}

}  // namespace wuerfel
