#include "core/qp/methods/active_set_method.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

constexpr int most_rounds = 8;
/// Share of the largest force, or of the largest bound, below which signs are rounding.
constexpr double sign_noise = 1e-13;
/// What refining may leave of the residual of the whole program.
constexpr double refined_residual = 1e-11;

}  // namespace

/// Lets go of rows that pull and takes hold of rows that are violated. Whether any did either.
bool ActiveSetMethod::revise(const QuadraticProgram& p,
                             std::vector<char>& tight,
                             QpResult& result) {
  double largest_force = 0.0;
  double largest_bound = 0.0;
  for (const double force : result.multiplier)
    largest_force = std::max(largest_force, std::abs(force));
  for (const double b : p.bound)
    largest_bound = std::max(largest_bound, std::abs(b));
  bool changed = false;
  for (int row = 0; row < p.rows(); ++row) {
    if (tight[row] != 0) {
      double& force = result.multiplier[row];
      if (p.is_equality(row) || force >= 0.0) continue;
      const bool pulls = force < -sign_noise * largest_force;
      force = 0.0;
      if (!pulls) continue;
      tight[row] = 0;
      changed = true;
    } else if (p.slack(row, result.x) < -sign_noise * largest_bound) {
      tight[row] = 1;
      changed = true;
    }
  }
  return changed;
}

bool ActiveSetMethod::solve(const QuadraticProgram& program,
                            double tolerance,
                            std::vector<char>& tight,
                            QpResult& result) {
  for (int row = 0; row < program.rows(); ++row) {
    const bool equality = program.is_equality(row);
    if (!equality && (program.force_min[row] != 0.0 || program.force_max[row] != unbounded))
      return false;
    if (equality) tight[row] = 1;
  }
  if (!defect(program).empty()) return false;
  for (int round = 1; round <= most_rounds; ++round) {
    solver_.factorise(program, &tight);
    solver_.solve(program, result.x, result.multiplier);
    if (revise(program, tight, result)) continue;
    result.residual = optimality_residual(program, result.x, result.multiplier);
    result.iterations = round;
    result.status = QpStatus::optimal;
    return result.residual.worst() <= tolerance;
  }
  return false;
}

void ActiveSetMethod::refine(const QuadraticProgram& program, QpResult& result) {
  const ResidualScales& scales = meter_.measure_scales(program);
  const auto error = [&](const QpResult& r) {
    return std::max(r.residual.worst(), meter_.imbalance(program, r.x, r.multiplier));
  };
  const double before = error(result);
  if (before <= exact_residual) return;
  refined_ = result;
  loaded_.assign(program.rows(), 1);
  for (int row = 0; row < program.rows(); ++row) {
    const double force = std::abs(result.multiplier[row]) * scales.row_norm[row];
    if (program.is_equality(row) || force > loaded_share * meter_.row_scale(program, row)) continue;
    loaded_[row] = 0;
    refined_.multiplier[row] = 0.0;
  }
  solver_.factorise(program, &loaded_);
  solver_.refine(program, refined_.x, refined_.multiplier);
  for (int row = 0; row < program.rows(); ++row) {
    refined_.multiplier[row] =
        std::clamp(refined_.multiplier[row], program.force_min[row], program.force_max[row]);
  }
  refined_.residual = meter_.measure(program, refined_.x, refined_.multiplier);
  // A better balance of single bodies is no reason to miss the program.
  const double allowed = std::max(result.residual.worst(), refined_residual);
  if (error(refined_) < before && refined_.residual.worst() <= allowed) std::swap(result, refined_);
}

}  // namespace wuerfel
