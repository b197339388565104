// The inner steps of NewtonMethod: phi is minimised for the multipliers at hand.
#include <algorithm>
#include <utility>

#include "core/qp/block/quad_vector.h"
#include "core/qp/methods/newton_method.h"
#include "core/qp/methods/piecewise_slope.h"

namespace wuerfel {
namespace {

constexpr int most_steps_on_factors = 100;

}  // namespace

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

/// K = I + rho G_A' G_A of the active rows.
void NewtonMethod::factorise(LeastDistance& problem) {
  for (std::size_t i = 0; i < weight_.size(); ++i)
    weight_[i] = side_[i] == 0 ? penalty_.rho : 0.0;
  problem.factorise(weight_.data());
  progress_.factorised = true;
  progress_.steps = 0;
  ++progress_.factorisations;
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
  PiecewiseSlope phi{-dot(step_.rhs, step_.d), dot(step_.d, step_.d)};
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
    if (side_[i] == 0) phi.curvature += rate * step_.Gd[i];
  }
  std::sort(breakpoints_.begin(), breakpoints_.end());
  for (const auto& [next, i] : breakpoints_) {
    if (!phi.goes_on_to(next)) return phi.zero();
    weight_[i] = rho - weight_[i];
    const double change = rho * step_.Gd[i] * step_.Gd[i];
    phi.curvature += weight_[i] > 0.0 ? change : -change;
  }
  return 1.0;
}

}  // namespace wuerfel
