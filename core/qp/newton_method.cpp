#include "core/qp/newton_method.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/qp/quad_vector.h"

namespace wuerfel {
namespace {

constexpr double first_rho = 1e6;    ///< in units of 1 / |g|^2
constexpr double last_rho = 1e9;     ///< beyond it the dead zone would be too wide
constexpr double dead_zone = 1e-14;  ///< times rho max|h|
constexpr double hard_share = 0.02;
constexpr int most_outer_steps = 100;
constexpr double drifting = 0.5;  ///< the residual after an outer step, in parts of that before

/// The multiplier of a row that is not active.
double bound_of(const LeastDistance& problem, std::size_t row, signed char side) {
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
    lost = worst > 0.5 * outcome.worst && rho_ >= largest_rho_ && !prolonged ? lost + 1 : 0;
    if (worst < outcome.worst) {
      outcome.worst = worst;
      best_ = lambda_;
    }
    // Where the sides were hard to find the program is nearly degenerate and x is less exact than
    // its residual.
    if (worst <= (factorisations_ <= 2 ? goal : hard_share * goal) || lost >= effort.patience)
      break;
    const bool slow = worst > 0.1 * former;
    former = worst;
    if (outer >= 2 && slow && diverges(problem)) {
      outcome.end = MethodEnd::infeasible;
      break;
    }
    if (slow) stiffen();
  }
  if (outcome.worst <= goal && outcome.end == MethodEnd::stalled) outcome.end = MethodEnd::reached;
  outcome.factorisations = factorisations_;
  problem.apply_transposed(best_.data(), y_.data());
  return outcome;
}

/// New multipliers; their residual, and whether they went on along a drift. `former` is the
/// residual of the step before.
std::pair<double, bool> NewtonMethod::outer_step(const LeastDistance& problem,
                                                 const ResidualScales& scales,
                                                 double former) {
  force_ = lambda_;
  update_multipliers(problem);
  const double worst = worst_row(problem, scales, rest_, lambda_);
  const bool drifts = worst > drifting * former && rho_ >= largest_rho_;
  if (!drifts || !prolong(problem)) return {worst, false};
  return {worst_row(problem, scales, rest_, lambda_), true};
}

void NewtonMethod::stiffen() {
  if (rho_ >= largest_rho_) return;
  rho_ *= 10.0;
  factorised_ = false;
}

/// Minimises phi. False if that is more than the effort allowed.
bool NewtonMethod::minimise(LeastDistance& problem, const NewtonEffort& effort) {
  most_first_changes_ = effort.most_changes * static_cast<double>(raw_.size());
  while (!inner_step(problem))
    if (hopeless_ || factorisations_ >= effort.most_factorisations) return false;
  return true;
}

/// Nearly dependent rows that contradict each other a little move their multipliers by the same
/// little change in every outer step. Goes on along that change, with the former multipliers in
/// `force_`, to where the dual objective is largest or a multiplier comes to its bound.
bool NewtonMethod::prolong(const LeastDistance& problem) {
  double slope = 0.0;
  double longest = unbounded;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    const double change = lambda_[i] - force_[i];
    raw_[i] = change;
    if (change == 0.0) continue;
    slope += change * rest_[i];
    const double bound = change > 0.0 ? problem.force_max()[i] : problem.force_min()[i];
    longest = std::min(longest, (bound - lambda_[i]) / change);
  }
  problem.apply_transposed(raw_.data(), d_.data());
  const double curvature = dot(d_, d_);
  if (slope <= 0.0) return false;
  const double step = curvature * longest > slope ? slope / curvature : longest;
  if (step < 1.0 || step == unbounded) return false;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    lambda_[i] = std::min(std::max(lambda_[i] + step * raw_[i], problem.force_min()[i]),
                          problem.force_max()[i]);
  }
  problem.apply_transposed(lambda_.data(), y_.data());
  find_rest(problem);
  return true;
}

/// Whether the last change of the multipliers, with the former ones in `force_`, proves that the
/// rows contradict each other.
bool NewtonMethod::diverges(const LeastDistance& problem) {
  for (std::size_t i = 0; i < force_.size(); ++i)
    raw_[i] = lambda_[i] - force_[i];
  return proves_infeasible(problem, raw_, weight_, d_);
}

/// With w = (h - G y) pulled back, the same phi: its minimum has lambda = clamp(rho G w), y =
/// target - w = G' lambda. Kept as w, since rho would blow up the rounding of a difference.
bool NewtonMethod::least_norm(LeastDistance& problem,
                              const std::vector<Quad>& target,
                              double stiffness,
                              double largest_force,
                              int most_factorisations) {
  start(problem);
  rho_ *= stiffness;
  dead_ = dead_zone * largest_force;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    lambda_[i] = 0.0;
    force_[i] = side_[i] == 0 ? 0.0 : bound_of(problem, i, side_[i]);
    weight_[i] = side_[i] == 0 ? rho_ : 0.0;
  }
  problem.apply_transposed(force_.data(), rhs_.data());
  d_ = target;
  add(-1.0, rhs_, d_);
  problem.factorise(weight_.data());
  factorised_ = whole_step_ = true;
  ++factorisations_;
  problem.solve(d_.data());
  problem.apply(d_.data(), rest_.data());
  y_ = target;
  add(-1.0, d_, y_);
  if (!minimise(problem, {.most_factorisations = most_factorisations})) return false;
  best_ = force_;
  problem.apply_transposed(best_.data(), y_.data());
  return true;
}

void NewtonMethod::start(const LeastDistance& problem) {
  const auto rows = static_cast<std::size_t>(problem.rows());
  const auto blocks = static_cast<std::size_t>(problem.blocks());
  guess_sides(problem);
  for (auto* v : {&lambda_, &raw_, &rest_, &Gd_, &weight_, &force_})
    v->resize(rows);
  for (auto* v : {&y_, &d_, &rhs_})
    v->resize(blocks);
  best_.assign(rows, 0.0);
  breakpoints_.reserve(2 * rows);
  choose_rho(problem);
  factorised_ = updated_ = false;
  factorisations_ = 0;
  hopeless_ = false;
}

/// The sides of the last solution where rows are the same; all active where nothing is known:
/// growing the set from nothing would activate a tower one cube at a time.
void NewtonMethod::guess_sides(const LeastDistance& problem) {
  const auto rows = static_cast<std::size_t>(problem.rows());
  // What is remembered may be older than the problem's former rows: another method has answered in
  // between, or none.
  if (side_.size() != rows || !problem.same_rows()) {
    former_side_.swap(side_);
    side_.assign(rows, 0);
    const auto known = static_cast<int>(former_side_.size());
    for (std::size_t i = 0; i < rows; ++i) {
      if (const int former = problem.former_row()[i]; former >= 0 && former < known)
        side_[i] = former_side_[former];
    }
  }
  for (std::size_t i = 0; i < rows; ++i) {
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
void NewtonMethod::choose_rho(const LeastDistance& problem) {
  double size = 0.0;
  double least = unbounded;
  double most = 0.0;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    const double square = problem.square()[i];
    if (square == 0.0) continue;
    if (problem.h()[i] > 0.0 || problem.force_min()[i] < 0.0)
      size = std::max(size, std::abs(problem.h()[i]));
    least = std::min(least, square);
    most = std::max(most, square);
  }
  const double square = most > 0.0 ? std::sqrt(least) * std::sqrt(most) : 1.0;
  rho_ = first_rho / square;
  largest_rho_ = last_rho / square;
  dead_ = dead_zone * rho_ * size;
}

/// The minimum of phi on the guessed sides, from lambda = 0.
void NewtonMethod::first_point(LeastDistance& problem) {
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    lambda_[i] = 0.0;
    const double bound = side_[i] == 0 ? 0.0 : bound_of(problem, i, side_[i]);
    force_[i] = side_[i] == 0 ? rho_ * problem.h()[i] : bound;
    weight_[i] = side_[i] == 0 ? rho_ : 0.0;
  }
  problem.apply_transposed(force_.data(), y_.data());
  problem.factorise(weight_.data());
  factorised_ = true;
  ++factorisations_;
  problem.solve(y_.data());
  find_rest(problem);
  whole_step_ = true;
}

/// Where a row belongs that was on `side`. Active rows leave at their bounds, others come in only
/// `dead` beyond theirs: a row without force and gap would come and go with every rounding error.
signed char NewtonMethod::side_of(const LeastDistance& problem, std::size_t row, double raw) const {
  const double dead = side_[row] == 0 ? 0.0 : dead_;
  const bool low = raw <= problem.force_min()[row] + dead;
  const bool high = raw >= problem.force_max()[row] - dead;
  return static_cast<signed char>(low ? -1 : high ? 1 : 0);
}

/// raw = lambda + rho (h - G y) and on which side of its range it is. True if no side changed.
bool NewtonMethod::find_sides(const LeastDistance& problem) {
  int changes = 0;
  for (std::size_t i = 0; i < raw_.size(); ++i) {
    raw_[i] = lambda_[i] + rho_ * rest_[i];
    const signed char side = side_of(problem, i, raw_[i]);
    if (side != side_[i]) ++changes;
    side_[i] = side;
    force_[i] = side == 0 ? raw_[i] : bound_of(problem, i, side);
  }
  hopeless_ = factorisations_ == 1 && changes > most_first_changes_;
  return changes == 0;
}

/// One Newton step towards the minimum of phi; true if it has been reached, that is, if the last
/// step was a whole one and left all rows on their sides. A test on the gradient would never pass:
/// rho turns rounding of y into large gradients.
bool NewtonMethod::inner_step(LeastDistance& problem) {
  // After an outer step the sides are expected to stay, whatever rounding of y = G' lambda makes of
  // them on the way.
  const bool expectant = std::exchange(updated_, false);
  const bool same = expectant ? stay(problem) : find_sides(problem);
  if (!expectant && same && factorised_ && whole_step_) return true;
  if (hopeless_) return false;
  problem.apply_transposed(force_.data(), rhs_.data());
  add(-1.0, y_, rhs_);
  if (!same || !factorised_) {
    for (std::size_t i = 0; i < weight_.size(); ++i)
      weight_[i] = side_[i] == 0 ? rho_ : 0.0;
    problem.factorise(weight_.data());
    factorised_ = true;
    ++factorisations_;
  }
  d_ = rhs_;
  problem.solve(d_.data());
  problem.apply(d_.data(), Gd_.data());
  const bool whole = keeps_sides(problem);
  if (expectant && !whole) return false;
  const double step = whole ? 1.0 : line_search(problem, -dot(rhs_, d_));
  add(step, d_, y_);
  for (std::size_t i = 0; i < rest_.size(); ++i)
    rest_[i] -= step * Gd_[i];
  whole_step_ = step == 1.0;
  return false;
}

/// raw = lambda + rho (h - G y) with every row on the side where it was.
bool NewtonMethod::stay(const LeastDistance& problem) {
  for (std::size_t i = 0; i < raw_.size(); ++i) {
    raw_[i] = lambda_[i] + rho_ * rest_[i];
    force_[i] = side_[i] == 0 ? raw_[i] : bound_of(problem, i, side_[i]);
  }
  return true;
}

bool NewtonMethod::keeps_sides(const LeastDistance& problem) const {
  for (std::size_t i = 0; i < raw_.size(); ++i)
    if (side_of(problem, i, raw_[i] - rho_ * Gd_[i]) != side_[i]) return false;
  return true;
}

/// The step in (0, 1] at which phi is least along d: its derivative is piecewise linear, so its
/// root is found by walking the places where a row changes sides.
double NewtonMethod::line_search(const LeastDistance& problem, double slope) {
  breakpoints_.clear();
  double curvature = dot(d_, d_);
  for (std::size_t i = 0; i < raw_.size(); ++i) {
    const double rate = rho_ * Gd_[i];
    if (rate == 0.0) continue;
    // The row's range as side_of sees it: that of an inactive row is narrower by the dead zone.
    const double dead = side_[i] == 0 ? 0.0 : dead_;
    for (const double bound : {problem.force_min()[i] + dead, problem.force_max()[i] - dead}) {
      const double step = (raw_[i] - bound) / rate;
      if (step > 0.0 && step < 1.0) breakpoints_.emplace_back(step, static_cast<int>(i));
    }
    weight_[i] = side_[i] == 0 ? rho_ : 0.0;
    if (side_[i] == 0) curvature += rate * Gd_[i];
  }
  std::sort(breakpoints_.begin(), breakpoints_.end());
  double at = 0.0;
  for (const auto& [next, row] : breakpoints_) {
    const auto i = static_cast<std::size_t>(row);
    if (slope + curvature * (next - at) >= 0.0) return at - slope / curvature;
    slope += curvature * (next - at);
    at = next;
    weight_[i] = rho_ - weight_[i];
    const double change = rho_ * Gd_[i] * Gd_[i];
    curvature += weight_[i] > 0.0 ? change : -change;
  }
  return 1.0;
}

/// lambda := clamp(raw), y := G' lambda, which makes stationarity exact and large rho harmless.
void NewtonMethod::update_multipliers(const LeastDistance& problem) {
  for (std::size_t i = 0; i < lambda_.size(); ++i)
    lambda_[i] = side_[i] == 0 ? raw_[i] : bound_of(problem, i, side_[i]);
  problem.apply_transposed(lambda_.data(), y_.data());
  find_rest(problem);
  whole_step_ = false;
  updated_ = true;
}

void NewtonMethod::find_rest(const LeastDistance& problem) {
  problem.apply(y_.data(), rest_.data());
  for (std::size_t i = 0; i < rest_.size(); ++i)
    rest_[i] = problem.h()[i] - rest_[i];
}

}  // namespace wuerfel
