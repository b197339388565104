#include "core/qp/methods/least_norm_method.h"

#include <algorithm>
#include <cmath>

#include "core/qp/block/quad_vector.h"
#include "core/qp/methods/piecewise_slope.h"

namespace wuerfel {
namespace {

constexpr double first_penalty = 1e8;  ///< in units of 1 / |g|^2
constexpr double last_penalty = 1e12;  ///< beyond it bodies that are free to move drown in rounding
constexpr double stiffening = 1e2;     ///< where nearly dependent rows settle slowly
constexpr double dead_share = 1e-14;   ///< of a row's scale: less force is none
constexpr double exact_misfit = 2e-15;  ///< a misfit that is nothing but rounding
constexpr double good_misfit = 1e-12;   ///< a misfit that is not worth another factorisation
constexpr double halved = 0.5;
constexpr int most_lost = 3;  ///< steps on the same rows that halve nothing
constexpr int most_newton_steps = 300;
constexpr int most_factorisations = 100;

/// Just after the start of a step that changes a value at `rate`, `low` above its least and `high` below its largest.
bool is_inside_after(double low, double high, double rate) {
  return (low > 0.0 || (low == 0.0 && rate > 0.0)) && (high > 0.0 || (high == 0.0 && rate < 0.0));
}

}  // namespace

LeastNormOutcome LeastNormMethod::run(LeastDistance& problem,
                                      const std::vector<Quad>& target,
                                      const std::vector<double>& weight,
                                      const std::vector<double>& origin,
                                      const std::vector<char>& inside) {
  start(problem, origin, inside);
  evaluate(problem, target);
  double best = unbounded;
  int lost = 0;
  for (int step = 0; step < most_newton_steps; ++step) {
    find_direction(problem);
    move(step == 0 ? 1.0 : line_search(problem));
    evaluate(problem, target);
    find_scales(problem, weight);
    lost = at_.misfit > halved * best ? lost + 1 : 0;
    keep_better(best);
    if (best <= exact_misfit) break;
    const bool changed = find_active(problem);
    if (lost >= most_lost && best <= good_misfit) break;
    if (!changed && lost < most_lost) continue;
    if (!changed) {
      if (rho_ * problem.square().front() >= last_penalty) break;
      rho_ *= stiffening;
      lost = 0;
    }
    if (factorisations_ >= most_factorisations) break;
    factorise(problem);
  }
  return {best, factorisations_};
}

void LeastNormMethod::keep_better(double& best) {
  if (!(at_.misfit < best)) return;
  best = at_.misfit;
  best_ = at_.lambda;
}

void LeastNormMethod::move(double length) {
  for (std::size_t i = 0; i < at_.raw.size(); ++i)
    at_.raw[i] += length * step_.Gd[i];
}

/// z = 0, with all rows taken to be inside of their ranges, or those given.
void LeastNormMethod::start(LeastDistance& problem,
                            const std::vector<double>& origin,
                            const std::vector<char>& inside) {
  const int rows = problem.rows();
  at_.raw.assign(rows, 0.0);
  if (!origin.empty()) at_.raw = origin;
  at_.lambda.assign(rows, 0.0);
  at_.rest.resize(problem.blocks());
  best_ = at_.lambda;
  step_.Gd.resize(rows);
  active_weight_.resize(rows);
  active_.assign(rows, 0);
  double least = unbounded;
  double most = 0.0;
  for (int i = 0; i < rows; ++i) {
    const double square = problem.square()[i];
    if (square == 0.0) continue;
    active_[i] = inside.empty() ? 1 : inside[i];
    least = std::min(least, square);
    most = std::max(most, square);
  }
  rho_ = most > 0.0 ? first_penalty / (std::sqrt(least) * std::sqrt(most)) : first_penalty;
  factorisations_ = 0;
  factorise(problem);
}

void LeastNormMethod::factorise(LeastDistance& problem) {
  for (std::size_t i = 0; i < active_.size(); ++i)
    active_weight_[i] = active_[i] != 0 ? rho_ : 0.0;
  problem.factorise(active_weight_.data());
  ++factorisations_;
}

void LeastNormMethod::find_direction(LeastDistance& problem) {
  step_.d = at_.rest;
  problem.solve(step_.d.data());
  problem.apply(step_.d.data(), step_.Gd.data());
  for (double& e : step_.Gd)
    e *= rho_;
}

void LeastNormMethod::evaluate(const LeastDistance& problem, const std::vector<Quad>& target) {
  for (std::size_t i = 0; i < at_.raw.size(); ++i)
    at_.lambda[i] = std::min(std::max(at_.raw[i], problem.force_min()[i]), problem.force_max()[i]);
  problem.apply_transposed(at_.lambda.data(), at_.rest.data());
  for (std::size_t b = 0; b < target.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      at_.rest[b].v[c] = target[b].v[c] - at_.rest[b].v[c];
  }
}

/// The largest force on every block, what is left of its balance, and the scale of every row.
void LeastNormMethod::find_scales(const LeastDistance& problem, const std::vector<double>& weight) {
  const BlockRows& rows = problem.view();
  scale_ = weight;
  for (int i = 0; i < rows.rows; ++i) {
    for (int e = rows.start[i]; e < rows.start[i + 1]; ++e) {
      double& scale = scale_[rows.block[e]];
      scale = std::max(scale, std::abs(at_.lambda[i]) * largest(rows.g[e]));
    }
  }
  row_scale_.assign(rows.rows, unbounded);
  for (int i = 0; i < rows.rows; ++i) {
    for (int e = rows.start[i]; e < rows.start[i + 1]; ++e)
      row_scale_[i] = std::min(row_scale_[i], scale_[rows.block[e]]);
  }
  at_.misfit = 0.0;
  for (std::size_t b = 0; b < scale_.size(); ++b) {
    const double rest = largest(at_.rest[b]);
    if (rest > 0.0) at_.misfit = std::max(at_.misfit, rest / scale_[b]);
  }
}

/// Rows leave at their bounds and come in only beyond the dead zone. True if any did.
bool LeastNormMethod::find_active(const LeastDistance& problem) {
  bool changed = false;
  for (std::size_t i = 0; i < active_.size(); ++i) {
    const double dead = active_[i] != 0 ? 0.0 : dead_share * row_scale_[i];
    const double raw = at_.raw[i];
    const bool inside = problem.square()[i] > 0.0 && raw > problem.force_min()[i] + dead
                        && raw < problem.force_max()[i] - dead;
    changed = changed || inside != (active_[i] != 0);
    active_[i] = inside ? 1 : 0;
  }
  return changed;
}

/// The step in (0, 1] at which the dual is least along the direction: its derivative is piecewise
/// linear, so its root is found by walking the places where a row leaves or enters its range.
double LeastNormMethod::line_search(const LeastDistance& problem) {
  PiecewiseSlope dual{-rho_ * dot(at_.rest, step_.d)};
  breakpoints_.clear();
  for (std::size_t i = 0; i < at_.raw.size(); ++i) {
    const double rate = step_.Gd[i];
    if (rate == 0.0) continue;
    for (const double bound : {problem.force_min()[i], problem.force_max()[i]}) {
      const double at = (bound - at_.raw[i]) / rate;
      if (at > 0.0 && at < 1.0) breakpoints_.emplace_back(at, static_cast<int>(i));
    }
    const bool inside = is_inside_after(at_.raw[i] - problem.force_min()[i],
                                        problem.force_max()[i] - at_.raw[i], rate);
    active_weight_[i] = inside ? 1.0 : 0.0;
    if (inside) dual.curvature += rate * rate;
  }
  std::sort(breakpoints_.begin(), breakpoints_.end());
  for (const auto& [next, i] : breakpoints_) {
    if (!dual.goes_on_to(next)) return dual.zero();
    active_weight_[i] = 1.0 - active_weight_[i];
    const double change = step_.Gd[i] * step_.Gd[i];
    dual.curvature += active_weight_[i] > 0.0 ? change : -change;
  }
  const bool rises = dual.slope + dual.curvature * (1.0 - dual.at) > 0.0;
  return rises && dual.curvature > 0.0 ? dual.zero() : 1.0;
}

}  // namespace wuerfel
