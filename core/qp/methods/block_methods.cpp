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
  solvable_ = program.allows_rest();
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
      newton_.run(problem_, meter_.scales(), {goal(), settings_.tolerance, solvable_}, effort);
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
      problem_, meter_.scales(),
      {interior_goal_share * settings_.tolerance, settings_.tolerance, solvable_}, warm, proximal);
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
  start_settling(answer.multiplier, settling_);
  weight_tight_rows(answer.multiplier, settling_);
  problem_.factorise(settling_.weight.data());
  Answer& moved = settled_;
  moved.multiplier = answer.multiplier;
  for (int round = 0; round < settling_rounds; ++round)
    move_onto_tight_rows(settling_, moved.multiplier);
  problem_.read(program, settling_.y, moved.x);
  moved.residual = meter_.measure(program, moved.x, moved.multiplier);
  if (moved.residual.worst() < answer.residual.worst()) std::swap(answer, moved);
}

/// y = G' lambda and what rows miss there.
void BlockMethods::start_settling(const std::vector<double>& multiplier, Settling& point) const {
  for (auto* v : {&point.rest, &point.weight, &point.pull, &point.Gd})
    v->resize(problem_.rows());
  for (auto* v : {&point.y, &point.d})
    v->resize(problem_.blocks());
  point.unbalance.assign(problem_.blocks(), Quad{});
  problem_.apply_transposed(multiplier.data(), point.y.data());
  problem_.apply(point.y.data(), point.rest.data());
  for (int i = 0; i < problem_.rows(); ++i)
    point.rest[i] = problem_.h()[i] - point.rest[i];
}

/// Rows whose slack is small rather than their force.
void BlockMethods::weight_tight_rows(const std::vector<double>& multiplier, Settling& point) const {
  const ResidualScales& scales = meter_.scales();
  const double force = scales.largest_force(multiplier);
  for (int i = 0; i < problem_.rows(); ++i) {
    const double rest = point.rest[i];
    const double distance = rest < 0.0 ? multiplier[i] - problem_.force_min()[i]
                                       : problem_.force_max()[i] - multiplier[i];
    const double norm = scales.row_norm[i];
    const double square = problem_.square()[i];
    const bool tight = distance * norm * scales.acceleration > std::abs(rest) / norm * force;
    point.weight[i] = tight && square > 0.0 ? settling_weight / square : 0.0;
  }
}

/// One solve with the factors at hand.
void BlockMethods::move_onto_tight_rows(Settling& point, std::vector<double>& multiplier) {
  auto& [y, rest, weight, unbalance, d, pull, Gd] = point;
  for (std::size_t i = 0; i < rest.size(); ++i)
    pull[i] = weight[i] * rest[i];
  problem_.apply_transposed(pull.data(), d.data());
  add(1.0, unbalance, d);
  problem_.solve(d.data());
  problem_.apply(d.data(), Gd.data());
  add(1.0, d, y);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    rest[i] -= Gd[i];
    multiplier[i] = std::min(std::max(multiplier[i] + weight[i] * rest[i], problem_.force_min()[i]),
                             problem_.force_max()[i]);
  }
  problem_.apply_transposed(multiplier.data(), unbalance.data());
  add(-1.0, y, unbalance);
}

}  // namespace wuerfel
