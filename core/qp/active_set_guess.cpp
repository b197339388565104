#include "core/qp/active_set_guess.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

constexpr int most_rounds = 8;
/// Shares of the largest force and of the largest bound below which signs are rounding.
constexpr double force_noise = 1e-13;
constexpr double slack_noise = 1e-13;

double slack(const QuadraticProgram& p, std::size_t row, const std::vector<double>& x) {
  double sum = -p.bound[row];
  const auto block = static_cast<std::size_t>(p.block_size);
  for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e) {
    const double* g = p.coefficients.data() + e * block;
    const double* at = x.data() + p.entry_block[e] * block;
    for (std::size_t k = 0; k < block; ++k)
      sum += g[k] * at[k];
  }
  return sum;
}

}  // namespace

void ActiveSetGuess::reduce(const QuadraticProgram& p, const std::vector<char>& tight) {
  reduced_.clear(p.block_size);
  reduced_.mass = p.mass;
  reduced_.target = p.target;
  for (std::size_t row = 0; row < tight.size(); ++row) {
    if (tight[row] == 0) continue;
    reduced_.add_equality(p.bound[row]);
    for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e)
      reduced_.add_entry(p.entry_block[e], p.entry(e));
  }
}

/// Whether the set has changed.
bool ActiveSetGuess::revise(const QuadraticProgram& p,
                            std::vector<char>& tight,
                            QpResult& result) const {
  double largest_force = 0.0;
  double largest_bound = 0.0;
  for (const double force : forces_)
    largest_force = std::max(largest_force, std::abs(force));
  for (const double b : p.bound)
    largest_bound = std::max(largest_bound, std::abs(b));
  result.multiplier.assign(tight.size(), 0.0);
  bool changed = false;
  std::size_t next = 0;
  for (std::size_t row = 0; row < tight.size(); ++row) {
    if (tight[row] != 0) {
      const double force = forces_[next++];
      const bool pulls = !p.is_equality(static_cast<int>(row)) && force < 0.0;
      result.multiplier[row] = pulls ? 0.0 : force;
      if (!pulls || force >= -force_noise * largest_force) continue;
      tight[row] = 0;
      changed = true;
    } else if (slack(p, row, result.x) < -slack_noise * largest_bound) {
      tight[row] = 1;
      changed = true;
    }
  }
  return changed;
}

bool ActiveSetGuess::solve(const QuadraticProgram& program,
                           double tolerance,
                           std::vector<char>& tight,
                           QpResult& result) {
  for (std::size_t row = 0; row < tight.size(); ++row) {
    const bool equality = program.is_equality(static_cast<int>(row));
    if (!equality && (program.force_min[row] != 0.0 || program.force_max[row] != unbounded))
      return false;
    if (equality) tight[row] = 1;
  }
  if (!defect(program).empty()) return false;
  for (int round = 1; round <= most_rounds; ++round) {
    reduce(program, tight);
    solver_.factorise(reduced_);
    solver_.solve(reduced_, result.x, forces_);
    if (revise(program, tight, result)) continue;
    result.residual = optimality_residual(program, result.x, result.multiplier);
    result.iterations = round;
    result.status = QpStatus::optimal;
    return result.residual.worst() <= tolerance;
  }
  return false;
}

}  // namespace wuerfel
