#include "core/qp/block_solver.h"

#include <algorithm>
#include <array>

#include "core/qp/quad_vector.h"

namespace wuerfel {
namespace {

constexpr double goal_share = 1e-2;  ///< newton aims this far below the tolerance
constexpr double interior_goal_share =
    1e-1;                            ///< interior_point this far, where every step costs factors
constexpr double best_goal = 2e-14;  ///< but not below rounding
/// Above this tolerance an answer within the goal is not improved, and newton, whose answers are
/// exact or none, is not tried.
constexpr double exact_tolerance = 1e-9;
constexpr int small_problem = 300;              ///< blocks up to which newton is cheap
constexpr int large_problem = 1500;             ///< blocks from which it is not tried again
constexpr int most_newton_factorisations = 20;  ///< then the other method takes over
constexpr double most_wrong_guesses =
    0.2;  ///< part of the rows above which the other method takes over
constexpr double most_wrong_guesses_of_large = 0.02;
constexpr int most_guessing_factorisations = 12;  ///< beyond small problems, without known sides
constexpr int most_guessing_factorisations_of_large = 8;
constexpr int patient_newton_factorisations = 400;  ///< where there is no other method
constexpr int patience = 30;                        ///< likewise
constexpr int retry_newton_after = 32;
constexpr double worth_settling = 1e-4;
constexpr double settling_weight = 1e9;  ///< of tight rows, in units of 1 / |g|^2
/// One after the other: small ones fail less often on jammed walls of very different masses, more
/// often elsewhere.
constexpr std::array proximal_terms{1e-14, 1e-15, 1e-16};

}  // namespace

BlockSolver::BlockSolver(QpMethod method, const QpSettings& settings, const BlockKernels& kernels)
    : method_(method), settings_(settings), problem_(kernels) {}

void BlockSolver::forget() {
  problem_.forget();
  newton_.forget();
  interior_point_.forget();
  newton_won_ = knows_sides_ = tried_newton_ = tried_known_sides_ = false;
  since_newton_ = warm_factorisations_ = cold_factorisations_ = 0;
}

void BlockSolver::solve(const QuadraticProgram& program, QpResult& result) {
  result.status = QpStatus::invalid;
  result.residual = {};
  result.iterations = 0;
  trouble_ = defect(program);
  if (!trouble_.empty()) {
    forget();
    return;
  }
  const ResidualScales& scales = meter_.measure_scales(program);
  problem_.prepare(program);
  if (has_impossible_row(scales)) {
    result.status = QpStatus::infeasible;
    result.residual.primal = unbounded;
    return;
  }
  result.residual.primal = unbounded;
  run(program, scales, result);
  if (result.status == QpStatus::infeasible) return;
  result.status =
      result.residual.worst() <= settings_.tolerance ? QpStatus::optimal : QpStatus::inaccurate;
}

/// A row without coefficients can only be true or false.
bool BlockSolver::has_impossible_row(const ResidualScales& scales) const {
  for (std::size_t i = 0; i < scales.row_norm.size(); ++i) {
    if (problem_.square()[i] > 0.0) continue;
    const double h = problem_.h()[i];
    const double allowed = settings_.tolerance * scales.row_norm[i] * scales.acceleration;
    if (h > allowed && problem_.force_max()[i] == unbounded) return true;
    if (h < -allowed && problem_.force_min()[i] == -unbounded) return true;
  }
  return false;
}

void BlockSolver::run(const QuadraticProgram& program,
                      const ResidualScales& scales,
                      QpResult& result) {
  if (method_ == QpMethod::newton) {
    run_newton(program, scales,
               {.most_factorisations = patient_newton_factorisations, .patience = patience},
               result);
    return;
  }
  if (method_ == QpMethod::automatic && newton_is_due()) {
    NewtonEffort effort{.most_factorisations = most_newton_factorisations};
    if (!knows_sides_ && problem_.blocks() > small_problem) {
      const bool large = problem_.blocks() > large_problem;
      effort.most_changes = large ? most_wrong_guesses_of_large : most_wrong_guesses;
      effort.most_factorisations =
          large ? most_guessing_factorisations_of_large : most_guessing_factorisations;
    }
    since_newton_ = 0;
    // A stalled answer may pass, but nearly degenerate programs turn it into a much larger error of
    // x.
    knows_sides_ = run_newton(program, scales, effort, result) && result.residual.worst() <= goal();
    newton_won_ = knows_sides_ || result.status == QpStatus::infeasible;
    if (newton_won_) return;
  }
  run_interior_point(program, scales, result);
  if (method_ == QpMethod::automatic) {
    newton_.remember(problem_, interior_point_.multiplier());
    knows_sides_ = true;
  }
}

/// After newton itself, or when its turn comes again: at once after the first answer of the other
/// method, later now and then.
bool BlockSolver::newton_is_due() {
  if (settings_.tolerance > exact_tolerance) return false;
  ++since_newton_;
  if (newton_won_) return true;
  if (!tried_newton_) {
    tried_newton_ = true;
    return true;
  }
  if (problem_.blocks() > large_problem) return false;
  if (knows_sides_ && !tried_known_sides_) {
    tried_known_sides_ = true;
    return true;
  }
  return since_newton_ >= retry_newton_after;
}

bool BlockSolver::run_newton(const QuadraticProgram& program,
                             const ResidualScales& scales,
                             const NewtonEffort& effort,
                             QpResult& result) {
  const MethodOutcome outcome = newton_.run(problem_, scales, goal(), effort);
  return take(program, scales, outcome, goal(), newton_.y(), newton_.multiplier(), result);
}

/// Warm as long as that is faster than cold.
void BlockSolver::run_interior_point(const QuadraticProgram& program,
                                     const ResidualScales& scales,
                                     QpResult& result) {
  const auto attempt = [&](bool warm, double proximal) {
    const MethodOutcome outcome = interior_point_.run(
        problem_, scales, interior_goal_share * settings_.tolerance, warm, proximal);
    (warm ? warm_factorisations_ : cold_factorisations_) = outcome.factorisations;
    const double enough = settings_.tolerance > exact_tolerance ? settings_.tolerance : best_goal;
    return take(program, scales, outcome, enough, interior_point_.y(), interior_point_.multiplier(),
                result);
  };
  if (interior_point_.can_start_warm(problem_) && warm_factorisations_ < cold_factorisations_) {
    if (attempt(true, proximal_terms.front())) return;
    warm_factorisations_ = cold_factorisations_;
  }
  for (const double proximal : proximal_terms)
    if (attempt(false, proximal)) return;
}

/// Moves the point onto the rows that carry force, and the multipliers along. Between bodies of
/// very different mass y = G' lambda is the small difference of large forces and misses the rows by
/// their rounding; apart from each other both are exact.
QpResidual BlockSolver::settle(const QuadraticProgram& program,
                               const ResidualScales& scales,
                               std::vector<double>& multiplier,
                               const QpResidual& before,
                               int& factorisations) {
  weight_tight_rows(scales, multiplier);
  problem_.factorise(weight_.data());
  ++factorisations;
  d_.resize(y_.size());
  for (std::size_t i = 0; i < rest_.size(); ++i)
    rest_[i] = problem_.h()[i] - rest_[i];
  moved_ = multiplier;
  unbalance_.assign(y_.size(), Quad{});
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < rest_.size(); ++i)
      change_[i] = weight_[i] * rest_[i];
    problem_.apply_transposed(change_.data(), d_.data());
    add(1.0, unbalance_, d_);
    problem_.solve(d_.data());
    problem_.apply(d_.data(), change_.data());
    add(1.0, d_, y_);
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const double lambda = moved_[i] + weight_[i] * (rest_[i] - change_[i]);
      rest_[i] -= change_[i];
      moved_[i] = std::min(std::max(lambda, problem_.force_min()[i]), problem_.force_max()[i]);
    }
    problem_.apply_transposed(moved_.data(), unbalance_.data());
    add(-1.0, y_, unbalance_);
  }
  former_x_.swap(x_);
  problem_.read(program, y_, x_);
  const QpResidual after = meter_.measure(program, x_, moved_);
  if (after.worst() < before.worst()) {
    multiplier.swap(moved_);
    return after;
  }
  x_.swap(former_x_);
  return before;
}

/// Rows whose slack is small rather than their force, seen from y = G' lambda; leaves y and G y.
void BlockSolver::weight_tight_rows(const ResidualScales& scales,
                                    const std::vector<double>& multiplier) {
  const auto rows = static_cast<std::size_t>(problem_.rows());
  weight_.resize(rows);
  rest_.resize(rows);
  change_.resize(rows);
  y_.resize(problem_.blocks());
  double force = scales.weight;
  for (std::size_t i = 0; i < rows; ++i)
    force = std::max(force, std::abs(multiplier[i]) * scales.row_norm[i]);
  problem_.apply_transposed(multiplier.data(), y_.data());
  problem_.apply(y_.data(), rest_.data());
  for (std::size_t i = 0; i < rows; ++i) {
    const double slack = rest_[i] - problem_.h()[i];
    const double distance = slack > 0.0 ? multiplier[i] - problem_.force_min()[i]
                                        : problem_.force_max()[i] - multiplier[i];
    const double norm = scales.row_norm[i];
    const bool tight = distance * norm * scales.acceleration > std::abs(slack) / norm * force;
    weight_[i] = tight && problem_.square()[i] > 0.0 ? settling_weight / problem_.square()[i] : 0.0;
  }
}

double BlockSolver::goal() const { return std::max(goal_share * settings_.tolerance, best_goal); }

/// Keeps the answer if it is better than the one in `result`; true if it is good enough or proves
/// that there is none.
bool BlockSolver::take(const QuadraticProgram& program,
                       const ResidualScales& scales,
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
  problem_.read(program, y, x_);
  multiplier_ = multiplier;
  QpResidual residual = meter_.measure(program, x_, multiplier_);
  if (residual.worst() < worth_settling && residual.worst() > enough)
    residual = settle(program, scales, multiplier_, residual, result.iterations);
  if (residual.worst() < result.residual.worst()) {
    result.residual = residual;
    result.x = x_;
    result.multiplier = multiplier_;
  }
  return residual.worst() <= settings_.tolerance;
}

}  // namespace wuerfel
