#include "core/qp/methods/interior_point_method.h"

#include <algorithm>
#include <cmath>

#include "core/qp/block/quad_vector.h"
#include "core/qp/interior_step.h"

namespace wuerfel {
namespace {

constexpr double proximal_equality = 1e-10;  ///< delta / |g|^2 of rows without finite ends
/// Steps after which nearly dependent rows are taken to creep, and what the others' delta / |g|^2
/// is then.
constexpr int slow = 20;
constexpr double slow_progress = 0.3;  ///< of the products in such a step
constexpr double useless_affine = 0.1;
constexpr double slow_proximal = 1e-20;
/// Distances at a cold start, in parts of what a row asks for at most: saves a step or two.
constexpr double first_gap = 0.1;
constexpr double warm_share = 1e-3;  ///< warm starts keep this part of a cold start's distances
constexpr int most_steps = 100;
constexpr double near = 1e-6;  ///< residual from which on progress is expected in every step
constexpr double progress = 0.95;
constexpr int patience = 12;
/// Unbalance, in parts of the residual that the centre has, at which K is taken to be too
/// ill-conditioned.
constexpr double most_unbalance = 0.1;
/// Below this part of the goal nothing is gained by smaller products.
constexpr double needless = 0.1;

bool is_finite(double end) { return end != unbounded && end != -unbounded; }

struct Range {
  double low, high;
};

/// `lambda` moved into its range, `margin` away from the ends if there is room.
double inside(const Range& range, double lambda, double margin) {
  margin = std::min(margin, 0.25 * (range.high - range.low));
  return std::min(std::max(lambda, range.low + margin), range.high - margin);
}

}  // namespace

MethodOutcome InteriorPointMethod::run(LeastDistance& problem,
                                       const ResidualScales& scales,
                                       const Aim& aim,
                                       bool warm,
                                       double proximal) {
  resize(problem);
  start(problem, warm);
  progress_ = {.former_mu = unbounded};
  const double goal = aim.residual;
  MethodOutcome outcome{MethodEnd::stalled, unbounded, 0};
  for (int step = 0; step < most_steps; ++step) {
    const double unbalance = round_off(problem, scales);
    const double worst = std::max(worst_row(problem, scales, at_.rest, near_.lambda), unbalance);
    const double mu = complementarity(problem, 0.0);
    const double force = scales.largest_force(at_.lambda);
    // Rows at the centre have gaps and forces of this size.
    const double centre = force > 0.0 ? std::sqrt(mu / (force * scales.acceleration)) : 0.0;
    const bool gains = keeps_gaining(worst, centre, outcome);
    if (outcome.worst <= goal) outcome.end = MethodEnd::reached;
    if (outcome.worst <= goal || !gains) break;
    if (!aim.solvable && step >= 8 && step % 4 == 0
        && proves_infeasible(problem, scales, aim.tolerance, at_.lambda, pull_, step_.y)) {
      outcome.end = MethodEnd::infeasible;
      break;
    }
    const double tolerable = force * std::max(most_unbalance * centre, needless * goal);
    factorise(problem, choose_proximal(problem, step, mu, tolerable, proximal));
    ++outcome.factorisations;
    find_direction(problem, 0.0, false);
    const double affine = complementarity(problem, std::min(1.0, longest_step(problem))) / mu;
    progress_.affine = affine;
    const double least = needless * goal * needless * goal * force * scales.acceleration;
    find_direction(problem, std::max(affine * affine * affine * mu, std::min(mu, least)), true);
    move(std::min(1.0, to_the_boundary * longest_step(problem)));
  }
  solved_ = outcome.end == MethodEnd::reached;
  return outcome;
}

/// Keeps the rounded iterate if it is the best so far. False once steps gain nothing any more.
bool InteriorPointMethod::keeps_gaining(double worst, double centre, MethodOutcome& outcome) {
  const bool early = outcome.worst > near || centre > outcome.worst;
  progress_.lost = worst < progress * outcome.worst || early ? 0 : progress_.lost + 1;
  if (worst < outcome.worst) {
    outcome.worst = worst;
    best_ = near_.lambda;
    best_y_ = at_.y;
  }
  return progress_.lost < patience;
}

/// delta / |g|^2 of rows with an end: tiny where nearly dependent rows creep, as long as rounding of K
/// allows it.
double InteriorPointMethod::choose_proximal(
    const LeastDistance& problem, int step, double mu, double tolerable, double proximal) {
  progress_.rounded = find_unbalance(problem) > tolerable || progress_.rounded;
  progress_.creeping =
      (step >= slow && mu > slow_progress * progress_.former_mu) || progress_.creeping;
  progress_.former_mu = mu;
  const bool tiny = progress_.creeping && !progress_.rounded && progress_.affine > useless_affine;
  return tiny ? std::min(proximal, slow_proximal) : proximal;
}

void InteriorPointMethod::resize(const LeastDistance& problem) {
  for (auto* v : {&at_.lambda, &at_.p, &at_.q, &at_.rest, &at_.r, &step_.lambda, &step_.p, &step_.q,
                  &step_.Gy, &near_.lambda, &weight_, &rhs_, &pull_, &best_})
    v->resize(problem.rows());
  for (auto* v : {&at_.y, &step_.y, &near_.unbalance, &unbalance_, &best_y_})
    v->resize(problem.blocks());
}

/// Cold: every distance and its multiplier have the same product.
void InteriorPointMethod::start(const LeastDistance& problem, bool warm) {
  const double size = size_of(problem) * (warm ? warm_share : 1.0);
  auto& [lambda, p, q, rest, r, y] = at_;
  count_ = 0;
  for (int i = 0; i < problem.rows(); ++i) {
    const double norm = std::sqrt(problem.square()[i]);
    const Range range{problem.force_min()[i], problem.force_max()[i]};
    const bool free = norm > 0.0 && range.low < range.high;
    const double gap = first_gap * size * norm;
    // What is open at y = 0 by more than that begins with its own gap, and a multiplier that is the
    // smaller for it.
    const double open = warm || is_finite(range.high) ? gap : std::max(gap, -problem.h()[i]);
    const double first = size / norm * (gap / open);
    const auto known = [warm](double value) { return warm ? value : 0.0; };
    const bool below = is_finite(range.low);
    lambda[i] = free ? inside(range, known(lambda[i]), first) : below ? range.low : 0.0;
    p[i] = free && below ? std::max(open, known(p[i])) : 0.0;
    q[i] = free && is_finite(range.high) ? std::max(gap, known(q[i])) : 0.0;
    count_ += static_cast<int>(p[i] > 0.0) + static_cast<int>(q[i] > 0.0);
  }
  find_rest(problem);
}

/// y = G' lambda and what rows miss there.
void InteriorPointMethod::find_rest(const LeastDistance& problem) {
  problem.apply_transposed(at_.lambda.data(), at_.y.data());
  problem.apply(at_.y.data(), at_.rest.data());
  for (int i = 0; i < problem.rows(); ++i) {
    at_.rest[i] = problem.h()[i] - at_.rest[i];
    at_.r[i] = at_.rest[i] + at_.p[i] - at_.q[i];
  }
}

/// The mean product of distances and multipliers after `step` along the direction.
double InteriorPointMethod::complementarity(const LeastDistance& problem, double step) const {
  if (count_ == 0) return 1.0;
  double sum = 0.0;
  for (int i = 0; i < problem.rows(); ++i) {
    const double lambda = step > 0.0 ? at_.lambda[i] + step * step_.lambda[i] : at_.lambda[i];
    const double p = step > 0.0 ? at_.p[i] + step * step_.p[i] : at_.p[i];
    const double q = step > 0.0 ? at_.q[i] + step * step_.q[i] : at_.q[i];
    if (at_.p[i] > 0.0) sum += p * (lambda - problem.force_min()[i]);
    if (at_.q[i] > 0.0) sum += q * (problem.force_max()[i] - lambda);
  }
  return std::max(sum / count_, step > 0.0 ? 0.0 : 1e-300);
}

/// G' lambda - y and its largest force. Nothing but rounding: it grows as K gets so ill-conditioned
/// that the directions in which bodies are free drown in it.
double InteriorPointMethod::find_unbalance(const LeastDistance& problem) {
  problem.apply_transposed(at_.lambda.data(), unbalance_.data());
  add(-1.0, at_.y, unbalance_);
  return problem.force_of(unbalance_);
}

void InteriorPointMethod::factorise(LeastDistance& problem, double proximal) {
  for (int i = 0; i < problem.rows(); ++i) {
    const double square = problem.square()[i];
    if (square == 0.0 || problem.force_min()[i] == problem.force_max()[i]) {
      weight_[i] = 0.0;
      continue;
    }
    const bool ends = at_.p[i] > 0.0 || at_.q[i] > 0.0;
    double inverse = (ends ? proximal : proximal_equality) * square;
    if (at_.p[i] > 0.0) inverse += at_.p[i] / (at_.lambda[i] - problem.force_min()[i]);
    if (at_.q[i] > 0.0) inverse += at_.q[i] / (problem.force_max()[i] - at_.lambda[i]);
    weight_[i] = 1.0 / inverse;
  }
  problem.factorise(weight_.data());
}

/// One solve with the factors at hand: the affine direction, or the one corrected by its second
/// order and centred.
void InteriorPointMethod::find_direction(LeastDistance& problem, double centring, bool corrector) {
  const double second = corrector ? 1.0 : 0.0;
  const auto& [lambda, p, q, rest, r, y] = at_;
  auto& d = step_;
  for (int i = 0; i < problem.rows(); ++i) {
    double rhs = r[i] - p[i] + q[i];
    if (p[i] > 0.0)
      rhs += (centring - second * d.p[i] * d.lambda[i]) / (lambda[i] - problem.force_min()[i]);
    if (q[i] > 0.0)
      rhs -= (centring + second * d.q[i] * d.lambda[i]) / (problem.force_max()[i] - lambda[i]);
    rhs_[i] = rhs;
    pull_[i] = weight_[i] * rhs;
  }
  problem.apply_transposed(pull_.data(), d.y.data());
  add(1.0, unbalance_, d.y);
  problem.solve(d.y.data());
  problem.apply(d.y.data(), d.Gy.data());
  for (int i = 0; i < problem.rows(); ++i) {
    const double old = second * d.lambda[i];
    const double d_lambda = weight_[i] * (rhs_[i] - d.Gy[i]);
    if (p[i] > 0.0) {
      const double distance = lambda[i] - problem.force_min()[i];
      d.p[i] = (centring - d.p[i] * old - p[i] * d_lambda) / distance - p[i];
    }
    if (q[i] > 0.0) {
      const double distance = problem.force_max()[i] - lambda[i];
      d.q[i] = (centring + d.q[i] * old + q[i] * d_lambda) / distance - q[i];
    }
    d.lambda[i] = d_lambda;
  }
}

double InteriorPointMethod::longest_step(const LeastDistance& problem) const {
  double step = 1e300;
  const auto& d = step_;
  for (int i = 0; i < problem.rows(); ++i) {
    if (at_.p[i] > 0.0) {
      if (d.p[i] < 0.0) step = std::min(step, -at_.p[i] / d.p[i]);
      if (d.lambda[i] < 0.0)
        step = std::min(step, (problem.force_min()[i] - at_.lambda[i]) / d.lambda[i]);
    }
    if (at_.q[i] > 0.0) {
      if (d.q[i] < 0.0) step = std::min(step, -at_.q[i] / d.q[i]);
      if (d.lambda[i] > 0.0)
        step = std::min(step, (problem.force_max()[i] - at_.lambda[i]) / d.lambda[i]);
    }
  }
  return step;
}

/// What rows miss is updated by differences: fresh rounding of G y in every step would be taken for
/// missing force, and in walls moves the forces of redundant rows about.
void InteriorPointMethod::move(double step) {
  auto& [lambda, p, q, rest, r, y] = at_;
  const auto& d = step_;
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    rest[i] -= step * d.Gy[i];
    r[i] -= step * (d.Gy[i] - (p[i] > 0.0 ? d.p[i] : 0.0) + (q[i] > 0.0 ? d.q[i] : 0.0));
    lambda[i] += step * d.lambda[i];
    if (p[i] > 0.0) p[i] = std::max(p[i] + step * d.p[i], 1e-300);
    if (q[i] > 0.0) q[i] = std::max(q[i] + step * d.q[i], 1e-300);
  }
  add(step, d.y, y);
}

/// Puts multipliers that are smaller than their distances at their bounds. Returns how far y is from
/// their G' lambda, relative to the largest force.
double InteriorPointMethod::round_off(const LeastDistance& problem, const ResidualScales& scales) {
  const double force = scales.largest_force(at_.lambda);
  for (int i = 0; i < problem.rows(); ++i) {
    const double unit = scales.row_norm[i] * scales.row_norm[i] * scales.acceleration;
    double lambda = at_.lambda[i];
    if (at_.p[i] > 0.0 && (lambda - problem.force_min()[i]) * unit < at_.p[i] * force)
      lambda = problem.force_min()[i];
    if (at_.q[i] > 0.0 && (problem.force_max()[i] - at_.lambda[i]) * unit < at_.q[i] * force)
      lambda = problem.force_max()[i];
    near_.lambda[i] = lambda;
  }
  problem.apply_transposed(near_.lambda.data(), near_.unbalance.data());
  add(-1.0, at_.y, near_.unbalance);
  return force > 0.0 ? problem.force_of(near_.unbalance) / force : 0.0;
}

}  // namespace wuerfel
