#include "core/qp/methods/newton_method.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/qp/block/quad_vector.h"

namespace wuerfel {
namespace {

constexpr double first_rho = 1e6;    ///< in units of 1 / |g|^2
constexpr double last_rho = 1e9;     ///< beyond it the dead zone would be too wide
constexpr double dead_zone = 1e-14;  ///< times rho max|h|
constexpr double hard_share = 0.02;
constexpr int most_outer_steps = 100;
constexpr double drifting = 0.5;  ///< the residual after an outer step, in parts of that before

}  // namespace

MethodOutcome NewtonMethod::run(LeastDistance& problem,
                                const ResidualScales& scales,
                                const Aim& aim,
                                const NewtonEffort& effort) {
  start(problem);
  first_point(problem);
  MethodOutcome outcome{MethodEnd::stalled, unbounded, 0};
  double former = unbounded;
  int lost = 0;
  for (int outer = 0; outer < most_outer_steps && minimise(problem, effort); ++outer) {
    const auto [worst, prolonged] = outer_step(problem, scales, former);
    const bool stiff = penalty_.rho >= penalty_.largest_rho;
    lost = worst > 0.5 * outcome.worst && stiff && !prolonged ? lost + 1 : 0;
    if (worst < outcome.worst) {
      outcome.worst = worst;
      best_ = at_.lambda;
    }
    // Where the sides were hard to find the program is nearly degenerate and x is less exact than
    // its residual.
    const double enough = progress_.factorisations <= 2 ? aim.residual : hard_share * aim.residual;
    if (worst <= enough || lost >= effort.patience) break;
    const bool slow = worst > 0.1 * former;
    former = worst;
    if (!aim.solvable && outer >= 2 && slow
        && proves_infeasible(problem, scales, aim.tolerance, change_, weight_, step_.d)) {
      outcome.end = MethodEnd::infeasible;
      break;
    }
    if (slow) stiffen();
  }
  if (outcome.worst <= aim.residual && outcome.end == MethodEnd::stalled)
    outcome.end = MethodEnd::reached;
  outcome.factorisations = progress_.factorisations;
  problem.apply_transposed(best_.data(), at_.y.data());
  return outcome;
}

/// New multipliers; their residual, and whether they went on along a drift. `former` is the
/// residual of the step before.
std::pair<double, bool> NewtonMethod::outer_step(const LeastDistance& problem,
                                                 const ResidualScales& scales,
                                                 double former) {
  change_ = at_.lambda;
  update_multipliers(problem);
  for (std::size_t i = 0; i < change_.size(); ++i)
    change_[i] = at_.lambda[i] - change_[i];
  const double worst = worst_row(problem, scales, at_.rest, at_.lambda);
  const bool drifts = worst > drifting * former && penalty_.rho >= penalty_.largest_rho;
  if (!drifts || !prolong(problem)) return {worst, false};
  return {worst_row(problem, scales, at_.rest, at_.lambda), true};
}

void NewtonMethod::stiffen() {
  if (penalty_.rho >= penalty_.largest_rho) return;
  penalty_.rho *= 10.0;
  progress_.factorised = false;
}

/// Nearly dependent rows that contradict each other a little move their multipliers by the same
/// little change in every outer step. Goes on along that change to where the dual objective is
/// largest or a multiplier comes to its bound.
bool NewtonMethod::prolong(const LeastDistance& problem) {
  double slope = 0.0;
  double longest = unbounded;
  for (std::size_t i = 0; i < change_.size(); ++i) {
    if (change_[i] == 0.0) continue;
    slope += change_[i] * at_.rest[i];
    const double bound = change_[i] > 0.0 ? problem.force_max()[i] : problem.force_min()[i];
    longest = std::min(longest, (bound - at_.lambda[i]) / change_[i]);
  }
  problem.apply_transposed(change_.data(), step_.d.data());
  const double curvature = dot(step_.d, step_.d);
  if (slope <= 0.0) return false;
  const double step = curvature * longest > slope ? slope / curvature : longest;
  if (step < 1.0 || step == unbounded) return false;
  for (std::size_t i = 0; i < change_.size(); ++i) {
    at_.lambda[i] = std::min(std::max(at_.lambda[i] + step * change_[i], problem.force_min()[i]),
                             problem.force_max()[i]);
    change_[i] *= 1.0 + step;
  }
  problem.apply_transposed(at_.lambda.data(), at_.y.data());
  find_rest(problem);
  return true;
}

void NewtonMethod::start(const LeastDistance& problem) {
  guess_sides(problem);
  for (auto* v : {&at_.lambda, &at_.raw, &at_.rest, &at_.force, &step_.Gd, &weight_})
    v->resize(problem.rows());
  for (auto* v : {&at_.y, &step_.d, &step_.rhs})
    v->resize(problem.blocks());
  best_.assign(problem.rows(), 0.0);
  breakpoints_.reserve(2 * problem.rows());
  choose_penalty(problem);
  progress_ = {};
}

/// The sides of the last solution where rows are the same; all active where nothing is known:
/// growing the set from nothing would activate a tower one cube at a time.
void NewtonMethod::guess_sides(const LeastDistance& problem) {
  const auto rows = problem.rows();
  // What is remembered may be older than the problem's former rows: another method has answered in
  // between, or none.
  if (std::ssize(side_) != rows || !problem.same_rows()) {
    former_side_.swap(side_);
    side_.assign(rows, 0);
    const auto known = static_cast<int>(former_side_.size());
    for (int i = 0; i < rows; ++i) {
      if (const int former = problem.former_row()[i]; former >= 0 && former < known)
        side_[i] = former_side_[former];
    }
  }
  for (int i = 0; i < rows; ++i) {
    // A side without a bound cannot be taken, and a row without a range has no choice.
    const double force_min = problem.force_min()[i];
    const double force_max = problem.force_max()[i];
    if (side_[i] != 0 && std::isinf(bound_of(problem, i, side_[i]))) side_[i] = 0;
    if (force_min == force_max || problem.square()[i] == 0.0) side_[i] = force_min == 0.0 ? -1 : 1;
  }
}

void NewtonMethod::remember(const LeastDistance& problem, const std::vector<double>& multiplier) {
  side_.resize(multiplier.size());
  for (std::size_t i = 0; i < multiplier.size(); ++i) {
    const bool low = multiplier[i] <= problem.force_min()[i];
    const bool high = multiplier[i] >= problem.force_max()[i];
    side_[i] = static_cast<signed char>(low ? -1 : high ? 1 : 0);
  }
}

/// One rho for all rows, or the multipliers would not be those of least norm; in the middle between
/// light and heavy ones.
void NewtonMethod::choose_penalty(const LeastDistance& problem) {
  double size = 0.0;
  double least = unbounded;
  double most = 0.0;
  for (int i = 0; i < problem.rows(); ++i) {
    const double square = problem.square()[i];
    if (square == 0.0) continue;
    if (problem.h()[i] > 0.0 || problem.force_min()[i] < 0.0)
      size = std::max(size, std::abs(problem.h()[i]));
    least = std::min(least, square);
    most = std::max(most, square);
  }
  const double square = most > 0.0 ? std::sqrt(least) * std::sqrt(most) : 1.0;
  penalty_.rho = first_rho / square;
  penalty_.largest_rho = last_rho / square;
  penalty_.dead = dead_zone * penalty_.rho * size;
}

/// The minimum of phi on the guessed sides, from lambda = 0.
void NewtonMethod::first_point(LeastDistance& problem) {
  for (int i = 0; i < problem.rows(); ++i) {
    at_.lambda[i] = 0.0;
    at_.force[i] = side_[i] == 0 ? penalty_.rho * problem.h()[i] : bound_of(problem, i, side_[i]);
  }
  problem.apply_transposed(at_.force.data(), at_.y.data());
  factorise(problem);
  problem.solve(at_.y.data());
  find_rest(problem);
  progress_.whole_step = true;
}

/// lambda := clamp(raw), y := G' lambda, which makes stationarity exact and large rho harmless.
void NewtonMethod::update_multipliers(const LeastDistance& problem) {
  for (int i = 0; i < problem.rows(); ++i)
    at_.lambda[i] = side_[i] == 0 ? at_.raw[i] : bound_of(problem, i, side_[i]);
  problem.apply_transposed(at_.lambda.data(), at_.y.data());
  find_rest(problem);
  progress_.whole_step = false;
  progress_.updated = true;
}

void NewtonMethod::find_rest(const LeastDistance& problem) {
  problem.apply(at_.y.data(), at_.rest.data());
  for (int i = 0; i < problem.rows(); ++i)
    at_.rest[i] = problem.h()[i] - at_.rest[i];
}

}  // namespace wuerfel
