#include "core/qp/methods/block_methods.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/qp/block/quad_vector.h"

namespace wuerfel {
namespace {

constexpr double goal_share = 1e-2;  ///< newton aims this far below the tolerance
/// interior_point this far, where every step costs factors
constexpr double interior_goal_share = 1e-1;
constexpr double best_goal = 2e-14;      ///< but not below rounding
constexpr double settling_weight = 1e9;  ///< of tight rows, in units of 1 / |g|^2
constexpr int settling_rounds = 3;
/// One after the other: small ones fail less often on jammed walls of very different masses, more
/// often elsewhere.
constexpr std::array proximal_terms{1e-14, 1e-15, 1e-16};

}  // namespace

BlockMethods::BlockMethods(const QpSettings& settings, const BlockKernels& kernels)
    : settings_(settings), problem_(kernels) {}

void BlockMethods::forget() {
  problem_.forget();
  newton_.forget();
  interior_point_.forget();
  warm_factorisations_ = cold_factorisations_ = 0;
}

bool BlockMethods::begin(const QuadraticProgram& program, QpResult& result) {
  result.status = QpStatus::invalid;
  result.residual = {};
  result.iterations = 0;
  trouble_ = defect(program);
  if (!trouble_.empty()) return false;
  meter_.measure_scales(program);
  problem_.prepare(program);
  result.residual.primal = unbounded;
  if (!has_impossible_row()) return true;
  result.status = QpStatus::infeasible;
  return false;
}

void BlockMethods::end(QpResult& result) const {
  if (result.status == QpStatus::infeasible) return;
  result.status =
      result.residual.worst() <= settings_.tolerance ? QpStatus::optimal : QpStatus::inaccurate;
}

/// A row without coefficients can only be true or false.
bool BlockMethods::has_impossible_row() const {
  const ResidualScales& scales = meter_.scales();
  for (std::size_t i = 0; i < scales.row_norm.size(); ++i) {
    if (problem_.square()[i] > 0.0) continue;
    const double h = problem_.h()[i];
    const double allowed = settings_.tolerance * scales.row_norm[i] * scales.acceleration;
    if (h > allowed && problem_.force_max()[i] == unbounded) return true;
    if (h < -allowed && problem_.force_min()[i] == -unbounded) return true;
  }
  return false;
}

double BlockMethods::goal() const { return std::max(goal_share * settings_.tolerance, best_goal); }

bool BlockMethods::run_newton(const QuadraticProgram& program,
                              const NewtonEffort& effort,
                              QpResult& result) {
  const MethodOutcome outcome =
      newton_.run(problem_, meter_.scales(), {goal(), settings_.tolerance}, effort);
  return take(program, outcome, goal(), newton_.y(), newton_.multiplier(), result);
}

void BlockMethods::run_interior_point(const QuadraticProgram& program, QpResult& result) {
  if (interior_point_.can_start_warm(problem_) && warm_factorisations_ < cold_factorisations_) {
    if (try_interior_point(program, true, proximal_terms.front(), result)) return;
    warm_factorisations_ = cold_factorisations_;
  }
  for (const double proximal : proximal_terms)
    if (try_interior_point(program, false, proximal, result)) return;
}

bool BlockMethods::try_interior_point(const QuadraticProgram& program,
                                      bool warm,
                                      double proximal,
                                      QpResult& result) {
  const MethodOutcome outcome = interior_point_.run(
      problem_, meter_.scales(), {interior_goal_share * settings_.tolerance, settings_.tolerance},
      warm, proximal);
  (warm ? warm_factorisations_ : cold_factorisations_) = outcome.factorisations;
  const double enough = settings_.wants_exact() ? best_goal : settings_.tolerance;
  return take(program, outcome, enough, interior_point_.y(), interior_point_.multiplier(), result);
}

/// Keeps the answer if it is better than the one in `result`; true if it is good enough or proves
/// that there is none.
bool BlockMethods::take(const QuadraticProgram& program,
                        const MethodOutcome& outcome,
                        double enough,
                        const std::vector<Quad>& y,
                        const std::vector<double>& multiplier,
                        QpResult& result) {
  result.iterations += outcome.factorisations;
  if (outcome.end == MethodEnd::infeasible) {
    result.status = QpStatus::infeasible;
    return true;
  }
  problem_.read(program, y, answer_.x);
  answer_.multiplier = multiplier;
  answer_.residual = meter_.measure(program, answer_.x, answer_.multiplier);
  if (answer_.residual.worst() < worth_settling && answer_.residual.worst() > enough) {
    settle(program, answer_);
    ++result.iterations;
  }
  if (answer_.residual.worst() < result.residual.worst()) {
    result.residual = answer_.residual;
    result.x = answer_.x;
    result.multiplier = answer_.multiplier;
  }
  return answer_.residual.worst() <= settings_.tolerance;
}

/// Moves the point onto the rows that carry force, and the multipliers along, if that makes them
/// better. Between bodies of very different mass y = G' lambda is the small difference of large
/// forces and misses the rows by their rounding; apart from each other both are exact.
void BlockMethods::settle(const QuadraticProgram& program, Answer& answer) {
  Answer& moved = settled_;
  weight_tight_rows(answer.multiplier);
  problem_.factorise(weight_.data());
  d_.resize(y_.size());
  for (std::size_t i = 0; i < rest_.size(); ++i)
    rest_[i] = problem_.h()[i] - rest_[i];
  moved.multiplier = answer.multiplier;
  unbalance_.assign(y_.size(), Quad{});
  for (int round = 0; round < settling_rounds; ++round) {
    for (std::size_t i = 0; i < rest_.size(); ++i)
      change_[i] = weight_[i] * rest_[i];
    problem_.apply_transposed(change_.data(), d_.data());
    add(1.0, unbalance_, d_);
    problem_.solve(d_.data());
    problem_.apply(d_.data(), change_.data());
    add(1.0, d_, y_);
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const double lambda = moved.multiplier[i] + weight_[i] * (rest_[i] - change_[i]);
      rest_[i] -= change_[i];
      moved.multiplier[i] =
          std::min(std::max(lambda, problem_.force_min()[i]), problem_.force_max()[i]);
    }
    problem_.apply_transposed(moved.multiplier.data(), unbalance_.data());
    add(-1.0, y_, unbalance_);
  }
  problem_.read(program, y_, moved.x);
  moved.residual = meter_.measure(program, moved.x, moved.multiplier);
  if (moved.residual.worst() < answer.residual.worst()) std::swap(answer, moved);
}

/// Rows whose slack is small rather than their force, seen from y = G' lambda; leaves y and, in `rest_`,
/// G y.
void BlockMethods::weight_tight_rows(const std::vector<double>& multiplier) {
  const ResidualScales& scales = meter_.scales();
  const int rows = problem_.rows();
  weight_.resize(rows);
  rest_.resize(rows);
  change_.resize(rows);
  y_.resize(problem_.blocks());
  double force = scales.weight;
  for (int i = 0; i < rows; ++i)
    force = std::max(force, std::abs(multiplier[i]) * scales.row_norm[i]);
  problem_.apply_transposed(multiplier.data(), y_.data());
  problem_.apply(y_.data(), rest_.data());
  for (int i = 0; i < rows; ++i) {
    const double slack = rest_[i] - problem_.h()[i];
    const double distance = slack > 0.0 ? multiplier[i] - problem_.force_min()[i]
                                        : problem_.force_max()[i] - multiplier[i];
    const double norm = scales.row_norm[i];
    const bool tight = distance * norm * scales.acceleration > std::abs(slack) / norm * force;
    weight_[i] = tight && problem_.square()[i] > 0.0 ? settling_weight / problem_.square()[i] : 0.0;
  }
}

}  // namespace wuerfel
