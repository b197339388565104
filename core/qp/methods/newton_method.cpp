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
constexpr int most_steps_on_factors = 100;
constexpr double drifting = 0.5;  ///< the residual after an outer step, in parts of that before

/// The multiplier of a row that is not active.
double bound_of(const LeastDistance& problem, int row, signed char side) {
  return side < 0 ? problem.force_min()[row] : problem.force_max()[row];
}

}  // namespace

MethodOutcome NewtonMethod::run(LeastDistance& problem,
                                const ResidualScales& scales,
                                double goal,
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
    const double enough = progress_.factorisations <= 2 ? goal : hard_share * goal;
    if (worst <= enough || lost >= effort.patience) break;
    const bool slow = worst > 0.1 * former;
    former = worst;
    if (outer >= 2 && slow && diverges(problem)) {
      outcome.end = MethodEnd::infeasible;
      break;
    }
    if (slow) stiffen();
  }
  if (outcome.worst <= goal && outcome.end == MethodEnd::stalled) outcome.end = MethodEnd::reached;
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

/// Minimises phi. False if that is more than the effort allowed.
bool NewtonMethod::minimise(LeastDistance& problem, const NewtonEffort& effort) {
  const double most_changes = effort.most_changes * problem.rows();
  progress_.steps = 0;
  while (!inner_step(problem, most_changes)) {
    if (progress_.hopeless || progress_.factorisations >= effort.most_factorisations) return false;
    // Where rounding has eaten the slope, steps of no length would go on for ever.
    if (++progress_.steps >= most_steps_on_factors) return false;
  }
  return true;
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

/// Whether the last change of the multipliers proves that the rows contradict each other.
bool NewtonMethod::diverges(const LeastDistance& problem) {
  return proves_infeasible(problem, change_, weight_, step_.d);
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

/// K = I + rho G_A' G_A of the active rows.
void NewtonMethod::factorise(LeastDistance& problem) {
  for (std::size_t i = 0; i < weight_.size(); ++i)
    weight_[i] = side_[i] == 0 ? penalty_.rho : 0.0;
  problem.factorise(weight_.data());
  progress_.factorised = true;
  progress_.steps = 0;
  ++progress_.factorisations;
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

/// Where a row belongs that was on `side`. Active rows leave at their bounds, others come in only
/// `dead` beyond theirs: a row without force and gap would come and go with every rounding error.
signed char NewtonMethod::side_of(const LeastDistance& problem, int row, double raw) const {
  const double dead = side_[row] == 0 ? 0.0 : penalty_.dead;
  const bool low = raw <= problem.force_min()[row] + dead;
  const bool high = raw >= problem.force_max()[row] - dead;
  return static_cast<signed char>(low ? -1 : high ? 1 : 0);
}

/// raw = lambda + rho (h - G y) and on which side of its range it is. True if no side changed.
bool NewtonMethod::find_sides(const LeastDistance& problem, double most_changes) {
  int changes = 0;
  for (int i = 0; i < problem.rows(); ++i) {
    at_.raw[i] = at_.lambda[i] + penalty_.rho * at_.rest[i];
    const signed char side = side_of(problem, i, at_.raw[i]);
    if (side != side_[i]) ++changes;
    side_[i] = side;
    at_.force[i] = side == 0 ? at_.raw[i] : bound_of(problem, i, side);
  }
  progress_.hopeless = progress_.factorisations == 1 && changes > most_changes;
  return changes == 0;
}

/// The same with every row on the side where it was.
void NewtonMethod::stay(const LeastDistance& problem) {
  for (int i = 0; i < problem.rows(); ++i) {
    at_.raw[i] = at_.lambda[i] + penalty_.rho * at_.rest[i];
    at_.force[i] = side_[i] == 0 ? at_.raw[i] : bound_of(problem, i, side_[i]);
  }
}

/// One Newton step towards the minimum of phi; true if it has been reached, that is, if the last
/// step was a whole one and left all rows on their sides. A test on the gradient would never pass:
/// rho turns rounding of y into large gradients.
bool NewtonMethod::inner_step(LeastDistance& problem, double most_changes) {
  // After an outer step the sides are expected to stay, whatever rounding of y = G' lambda makes of
  // them on the way.
  const bool expectant = std::exchange(progress_.updated, false);
  bool same = true;
  if (expectant) {
    stay(problem);
  } else {
    same = find_sides(problem, most_changes);
    if (same && progress_.factorised && progress_.whole_step) return true;
  }
  if (progress_.hopeless) return false;
  problem.apply_transposed(at_.force.data(), step_.rhs.data());
  add(-1.0, at_.y, step_.rhs);
  if (!same || !progress_.factorised) factorise(problem);
  step_.d = step_.rhs;
  problem.solve(step_.d.data());
  problem.apply(step_.d.data(), step_.Gd.data());
  const bool whole = keeps_sides(problem);
  if (expectant && !whole) return false;
  const double length = whole ? 1.0 : line_search(problem);
  add(length, step_.d, at_.y);
  for (std::size_t i = 0; i < at_.rest.size(); ++i)
    at_.rest[i] -= length * step_.Gd[i];
  progress_.whole_step = length == 1.0;
  return false;
}

bool NewtonMethod::keeps_sides(const LeastDistance& problem) const {
  for (int i = 0; i < problem.rows(); ++i)
    if (side_of(problem, i, at_.raw[i] - penalty_.rho * step_.Gd[i]) != side_[i]) return false;
  return true;
}

/// The step in (0, 1] at which phi is least along d: its derivative is piecewise linear, so its
/// root is found by walking the places where a row changes sides.
double NewtonMethod::line_search(const LeastDistance& problem) {
  breakpoints_.clear();
  const double rho = penalty_.rho;
  double slope = -dot(step_.rhs, step_.d);
  double curvature = dot(step_.d, step_.d);
  for (int i = 0; i < problem.rows(); ++i) {
    const double rate = rho * step_.Gd[i];
    if (rate == 0.0) continue;
    // The row's range as side_of sees it: that of an inactive row is narrower by the dead zone.
    const double dead = side_[i] == 0 ? 0.0 : penalty_.dead;
    for (const double bound : {problem.force_min()[i] + dead, problem.force_max()[i] - dead}) {
      const double step = (at_.raw[i] - bound) / rate;
      if (step > 0.0 && step < 1.0) breakpoints_.emplace_back(step, i);
    }
    weight_[i] = side_[i] == 0 ? rho : 0.0;
    if (side_[i] == 0) curvature += rate * step_.Gd[i];
  }
  std::sort(breakpoints_.begin(), breakpoints_.end());
  double at = 0.0;
  for (const auto& [next, i] : breakpoints_) {
    if (slope + curvature * (next - at) >= 0.0) return at - slope / curvature;
    slope += curvature * (next - at);
    at = next;
    weight_[i] = rho - weight_[i];
    const double change = rho * step_.Gd[i] * step_.Gd[i];
    curvature += weight_[i] > 0.0 ? change : -change;
  }
  return 1.0;
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
