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

/// Row times x.
double product(const QuadraticProgram& p, int row, const std::vector<double>& x) {
  double sum = 0.0;
  const auto block = static_cast<std::size_t>(p.block_size);
  for (int e = p.row_start[static_cast<std::size_t>(row)];
       e < p.row_start[static_cast<std::size_t>(row) + 1]; ++e) {
    const double* g = p.coefficients.data() + static_cast<std::size_t>(e) * block;
    const double* at =
        x.data() + static_cast<std::size_t>(p.entry_block[static_cast<std::size_t>(e)]) * block;
    for (std::size_t k = 0; k < block; ++k)
      sum += g[k] * at[k];
  }
  return sum;
}

/// x += M^-1 row' * factor.
void add_push(const QuadraticProgram& p, int row, double factor, std::vector<double>& x) {
  const auto block = static_cast<std::size_t>(p.block_size);
  for (int e = p.row_start[static_cast<std::size_t>(row)];
       e < p.row_start[static_cast<std::size_t>(row) + 1]; ++e) {
    const double* g = p.coefficients.data() + static_cast<std::size_t>(e) * block;
    const std::size_t at =
        static_cast<std::size_t>(p.entry_block[static_cast<std::size_t>(e)]) * block;
    for (std::size_t k = 0; k < block; ++k)
      x[at + k] += g[k] * factor / p.mass[at + k];
  }
}

}  // namespace

void EqualitySolver::find_envelope(const QuadraticProgram& p) {
  if (row_start_ == p.row_start && entry_block_ == p.entry_block) return;
  row_start_ = p.row_start;
  entry_block_ = p.entry_block;
  couplings_.clear();
  const int rows = p.rows();
  std::vector<std::vector<std::pair<int, int>>> of_block(static_cast<std::size_t>(p.blocks()));
  first_.assign(static_cast<std::size_t>(rows), 0);
  start_.assign(static_cast<std::size_t>(rows), 0);
  int size = 0;
  for (int i = 0; i < rows; ++i) {
    int first = i;
    for (int e = row_start_[static_cast<std::size_t>(i)];
         e < row_start_[static_cast<std::size_t>(i) + 1]; ++e) {
      auto& others = of_block[static_cast<std::size_t>(entry_block_[static_cast<std::size_t>(e)])];
      others.emplace_back(i, e);
      for (const auto& [j, f] : others) {
        couplings_.push_back({i, j, e, f});
        first = std::min(first, j);
      }
    }
    first_[static_cast<std::size_t>(i)] = first;
    start_[static_cast<std::size_t>(i)] = size - first;
    size += i - first + 1;
  }
  factor_.resize(static_cast<std::size_t>(size));
  inverse_.resize(static_cast<std::size_t>(rows));
}

void EqualitySolver::factorise(const QuadraticProgram& p) {
  find_envelope(p);
  std::ranges::fill(factor_, 0.0);
  const auto block = static_cast<std::size_t>(p.block_size);
  for (const Coupling& c : couplings_) {
    const double* g = p.coefficients.data() + static_cast<std::size_t>(c.entry_i) * block;
    const double* h = p.coefficients.data() + static_cast<std::size_t>(c.entry_j) * block;
    const double* m =
        p.mass.data()
        + static_cast<std::size_t>(entry_block_[static_cast<std::size_t>(c.entry_i)]) * block;
    double sum = 0.0;
    for (std::size_t k = 0; k < block; ++k)
      sum += g[k] * h[k] / m[k];
    at(c.i, c.j) += sum;
  }
  dependent_ = 0;
  for (int i = 0; i < p.rows(); ++i) {
    double* row = &factor_[static_cast<std::size_t>(start_[static_cast<std::size_t>(i)]
                                                    + first_[static_cast<std::size_t>(i)])];
    const int first = first_[static_cast<std::size_t>(i)];
    double squares = 0.0;
    for (int j = first; j < i; ++j) {
      const int from = std::max(first, first_[static_cast<std::size_t>(j)]);
      const double* a = row + (from - first);
      const double* b =
          &factor_[static_cast<std::size_t>(start_[static_cast<std::size_t>(j)] + from)];
      double sum = row[j - first];
      for (int k = from; k < j; ++k)
        sum -= *a++ * *b++;
      sum *= inverse_[static_cast<std::size_t>(j)];
      row[j - first] = sum;
      squares += sum * sum;
    }
    const double diagonal = row[i - first];
    const double pivot = diagonal - squares;
    const bool independent = pivot > dependent_share * diagonal;
    if (!independent) ++dependent_;
    row[i - first] = independent ? std::sqrt(pivot) : 0.0;
    inverse_[static_cast<std::size_t>(i)] = independent ? 1.0 / row[i - first] : 0.0;
  }
}

/// r := S^-1 r over the rows that are kept, 0 on the others.
void EqualitySolver::substitute(std::vector<double>& r) const {
  const int rows = static_cast<int>(r.size());
  for (int i = 0; i < rows; ++i) {
    double sum = r[static_cast<std::size_t>(i)];
    for (int j = first_[static_cast<std::size_t>(i)]; j < i; ++j)
      sum -= at(i, j) * r[static_cast<std::size_t>(j)];
    r[static_cast<std::size_t>(i)] = sum * inverse_[static_cast<std::size_t>(i)];
  }
  for (int i = rows - 1; i >= 0; --i) {
    const double x = r[static_cast<std::size_t>(i)] * inverse_[static_cast<std::size_t>(i)];
    r[static_cast<std::size_t>(i)] = x;
    for (int j = first_[static_cast<std::size_t>(i)]; j < i; ++j)
      r[static_cast<std::size_t>(j)] -= at(i, j) * x;
  }
}

void EqualitySolver::solve(const QuadraticProgram& p,
                           std::vector<double>& x,
                           std::vector<double>& multiplier) {
  const int rows = p.rows();
  x = p.target;
  multiplier.assign(static_cast<std::size_t>(rows), 0.0);
  residual_.resize(static_cast<std::size_t>(rows));
  double scale = 0.0;
  for (int round = 0; round <= most_refinements; ++round) {
    double worst = 0.0;
    for (int i = 0; i < rows; ++i) {
      const double b = p.bound[static_cast<std::size_t>(i)];
      const double reached = product(p, i, x);
      residual_[static_cast<std::size_t>(i)] = b - reached;
      if (round == 0) scale = std::max({scale, std::abs(b), std::abs(reached)});
      if (inverse_[static_cast<std::size_t>(i)] != 0.0)
        worst = std::max(worst, std::abs(b - reached));
    }
    if (worst <= refined_share * scale) return;
    substitute(residual_);
    for (int i = 0; i < rows; ++i) {
      const double d = residual_[static_cast<std::size_t>(i)];
      if (d == 0.0) continue;
      multiplier[static_cast<std::size_t>(i)] += d;
      add_push(p, i, d, x);
    }
  }
}

}  // namespace wuerfel
