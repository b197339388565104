#include "core/qp/interior_point_method.h"

#include <algorithm>
#include <cmath>

#include "core/qp/quad_vector.h"

namespace wuerfel {
namespace {

constexpr double proximal_equality = 1e-10;  ///< delta / |g|^2 of rows without finite ends
/// Steps after which nearly dependent rows are taken to creep, and what the others' delta / |g|^2
/// is then.
constexpr int slow = 20;
constexpr double slow_progress = 0.3;  ///< of the products in such a step
constexpr double useless_affine = 0.1;
constexpr double slow_proximal = 1e-20;
constexpr double to_the_boundary = 0.995;
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

/// Largest distance of a row that pushes from y = 0.
double size_of(const LeastDistance& problem) {
  double size = 0.0;
  for (std::size_t i = 0; i < problem.h().size(); ++i) {
    if (problem.square()[i] > 0.0 && (problem.h()[i] > 0.0 || problem.force_min()[i] < 0.0))
      size = std::max(size, std::abs(problem.h()[i]) / std::sqrt(problem.square()[i]));
  }
  return size;
}

}  // namespace

MethodOutcome InteriorPointMethod::run(
    LeastDistance& problem, const ResidualScales& scales, double goal, bool warm, double proximal) {
  resize(problem);
  start(problem, warm);
  creeping_ = rounded_ = false;
  former_mu_ = unbounded;
  MethodOutcome outcome{MethodEnd::stalled, unbounded, 0};
  double affine = 0.0;
  int lost = 0;
  for (int step = 0; step < most_steps; ++step) {
    const double unbalance = round_off(problem, scales);
    const double worst = std::max(worst_row(problem, scales, rest_, scratch_), unbalance);
    const double mu = complementarity(problem);
    const double force = largest_force(scales);
    // Rows at the centre have gaps and forces of this size.
    const double centre = force > 0.0 ? std::sqrt(mu / (force * scales.acceleration)) : 0.0;
    const bool early = outcome.worst > near || centre > outcome.worst;
    lost = worst < progress * outcome.worst || early ? 0 : lost + 1;
    keep_best(worst, outcome);
    if (outcome.worst <= goal) {
      outcome.end = MethodEnd::reached;
      break;
    }
    if (lost >= patience) break;
    if (step >= 8 && step % 4 == 0 && proves_infeasible(problem, lambda_, scratch_, d_)) {
      outcome.end = MethodEnd::infeasible;
      break;
    }
    const double tolerable = force * std::max(most_unbalance * centre, needless * goal);
    rounded_ = find_unbalance(problem) > tolerable || rounded_;
    creeping_ = (step >= slow && mu > slow_progress * former_mu_) || creeping_;
    former_mu_ = mu;
    const bool tiny = creeping_ && !rounded_ && affine > useless_affine;
    proximal_ = tiny ? std::min(proximal, slow_proximal) : proximal;
    set_weights(problem);
    problem.factorise(weight_.data());
    ++outcome.factorisations;
    find_direction(problem, 0.0, false);
    affine = affine_complementarity(problem, longest_step(problem)) / mu;
    const double least = needless * goal * needless * goal * force * scales.acceleration;
    find_direction(problem, std::max(affine * affine * affine * mu, std::min(mu, least)), true);
    move(std::min(1.0, to_the_boundary * longest_step(problem)));
  }
  solved_ = outcome.end == MethodEnd::reached;
  return outcome;
}

void InteriorPointMethod::keep_best(double worst, MethodOutcome& outcome) {
  if (worst >= outcome.worst) return;
  outcome.worst = worst;
  best_ = scratch_;
  best_y_ = y_;
}

void InteriorPointMethod::resize(const LeastDistance& problem) {
  const auto rows = static_cast<std::size_t>(problem.rows());
  for (auto* v : {&lambda_, &p_, &q_, &d_lambda_, &d_p_, &d_q_, &weight_, &r_, &rhs_, &rest_, &Gd_,
                  &best_, &scratch_})
    v->resize(rows);
  for (auto* v : {&y_, &d_, &unbalance_, &best_y_})
    v->resize(static_cast<std::size_t>(problem.blocks()));
}

/// Cold: every distance and its multiplier have the same product.
void InteriorPointMethod::start(const LeastDistance& problem, bool warm) {
  const double size = size_of(problem) * (warm ? warm_share : 1.0);
  count_ = 0;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    const double norm = std::sqrt(problem.square()[i]);
    const Range range{problem.force_min()[i], problem.force_max()[i]};
    const bool free = norm > 0.0 && range.low < range.high;
    const double gap = first_gap * size * norm;
    // What is open at y = 0 by more than that begins with its own gap, and a multiplier that is the
    // smaller for it.
    const double open = warm || is_finite(range.high) ? gap : std::max(gap, -problem.h()[i]);
    const double first = size / norm * (gap / open);
    lambda_[i] = free                   ? inside(range, warm ? lambda_[i] : 0.0, first)
                 : is_finite(range.low) ? range.low
                                        : 0.0;
    p_[i] = free && is_finite(range.low) ? std::max(open, warm ? p_[i] : 0.0) : 0.0;
    q_[i] = free && is_finite(range.high) ? std::max(gap, warm ? q_[i] : 0.0) : 0.0;
    count_ += (p_[i] > 0.0 ? 1 : 0) + (q_[i] > 0.0 ? 1 : 0);
  }
  find_rest(problem);
}

/// y = G' lambda and what rows miss there.
void InteriorPointMethod::find_rest(const LeastDistance& problem) {
  problem.apply_transposed(lambda_.data(), y_.data());
  problem.apply(y_.data(), rest_.data());
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    rest_[i] = problem.h()[i] - rest_[i];
    r_[i] = rest_[i] + p_[i] - q_[i];
  }
}

double InteriorPointMethod::complementarity(const LeastDistance& problem) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    if (p_[i] > 0.0) sum += p_[i] * (lambda_[i] - problem.force_min()[i]);
    if (q_[i] > 0.0) sum += q_[i] * (problem.force_max()[i] - lambda_[i]);
  }
  return count_ > 0 ? std::max(sum / count_, 1e-300) : 1.0;
}

double InteriorPointMethod::affine_complementarity(const LeastDistance& problem,
                                                   double step) const {
  step = std::min(1.0, step);
  double sum = 0.0;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    const double lambda = lambda_[i] + step * d_lambda_[i];
    if (p_[i] > 0.0) sum += (p_[i] + step * d_p_[i]) * (lambda - problem.force_min()[i]);
    if (q_[i] > 0.0) sum += (q_[i] + step * d_q_[i]) * (problem.force_max()[i] - lambda);
  }
  return count_ > 0 ? std::max(sum / count_, 0.0) : 0.0;
}

void InteriorPointMethod::set_weights(const LeastDistance& problem) {
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    const double square = problem.square()[i];
    if (square == 0.0 || problem.force_min()[i] == problem.force_max()[i]) {
      weight_[i] = 0.0;
      continue;
    }
    double inverse = (p_[i] > 0.0 || q_[i] > 0.0 ? proximal_ : proximal_equality) * square;
    if (p_[i] > 0.0) inverse += p_[i] / (lambda_[i] - problem.force_min()[i]);
    if (q_[i] > 0.0) inverse += q_[i] / (problem.force_max()[i] - lambda_[i]);
    weight_[i] = 1.0 / inverse;
  }
}

double InteriorPointMethod::largest_force(const ResidualScales& scales) const {
  double force = scales.weight;
  for (std::size_t i = 0; i < lambda_.size(); ++i)
    force = std::max(force, std::abs(lambda_[i]) * scales.row_norm[i]);
  return force;
}

/// G' lambda - y and its largest force. Nothing but rounding: it grows as K gets so ill-conditioned
/// that the directions in which bodies are free drown in it.
double InteriorPointMethod::find_unbalance(const LeastDistance& problem) {
  problem.apply_transposed(lambda_.data(), unbalance_.data());
  add(-1.0, y_, unbalance_);
  return problem.force_of(unbalance_);
}

/// One solve with the factors at hand: the affine direction, or the one corrected by its second
/// order and centred.
void InteriorPointMethod::find_direction(LeastDistance& problem, double centring, bool corrector) {
  const double second = corrector ? 1.0 : 0.0;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    double rhs = r_[i] - p_[i] + q_[i];
    if (p_[i] > 0.0)
      rhs += (centring - second * d_p_[i] * d_lambda_[i]) / (lambda_[i] - problem.force_min()[i]);
    if (q_[i] > 0.0)
      rhs -= (centring + second * d_q_[i] * d_lambda_[i]) / (problem.force_max()[i] - lambda_[i]);
    rhs_[i] = rhs;
    scratch_[i] = weight_[i] * rhs;
  }
  problem.apply_transposed(scratch_.data(), d_.data());
  add(1.0, unbalance_, d_);
  problem.solve(d_.data());
  problem.apply(d_.data(), Gd_.data());
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    const double old = second * d_lambda_[i];
    const double d_lambda = weight_[i] * (rhs_[i] - Gd_[i]);
    if (p_[i] > 0.0) {
      const double distance = lambda_[i] - problem.force_min()[i];
      d_p_[i] = (centring - d_p_[i] * old - p_[i] * d_lambda) / distance - p_[i];
    }
    if (q_[i] > 0.0) {
      const double distance = problem.force_max()[i] - lambda_[i];
      d_q_[i] = (centring + d_q_[i] * old + q_[i] * d_lambda) / distance - q_[i];
    }
    d_lambda_[i] = d_lambda;
  }
}

double InteriorPointMethod::longest_step(const LeastDistance& problem) const {
  double step = 1e300;
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    if (p_[i] > 0.0) {
      if (d_p_[i] < 0.0) step = std::min(step, -p_[i] / d_p_[i]);
      if (d_lambda_[i] < 0.0)
        step = std::min(step, (problem.force_min()[i] - lambda_[i]) / d_lambda_[i]);
    }
    if (q_[i] > 0.0) {
      if (d_q_[i] < 0.0) step = std::min(step, -q_[i] / d_q_[i]);
      if (d_lambda_[i] > 0.0)
        step = std::min(step, (problem.force_max()[i] - lambda_[i]) / d_lambda_[i]);
    }
  }
  return step;
}

/// What rows miss is updated by differences: fresh rounding of G y in every step would be taken for
/// missing force, and in walls moves the forces of redundant rows about.
void InteriorPointMethod::move(double step) {
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    rest_[i] -= step * Gd_[i];
    r_[i] -= step * (Gd_[i] - (p_[i] > 0.0 ? d_p_[i] : 0.0) + (q_[i] > 0.0 ? d_q_[i] : 0.0));
    lambda_[i] += step * d_lambda_[i];
    if (p_[i] > 0.0) p_[i] = std::max(p_[i] + step * d_p_[i], 1e-300);
    if (q_[i] > 0.0) q_[i] = std::max(q_[i] + step * d_q_[i], 1e-300);
  }
  add(step, d_, y_);
}

/// The iterate with multipliers that are smaller than their distances put at their bounds, in
/// `scratch_`. Returns how far y is from their G' lambda, relative to the largest force.
double InteriorPointMethod::round_off(const LeastDistance& problem, const ResidualScales& scales) {
  const double force = largest_force(scales);
  for (std::size_t i = 0; i < lambda_.size(); ++i) {
    const double unit = scales.row_norm[i] * scales.row_norm[i] * scales.acceleration;
    double lambda = lambda_[i];
    if (p_[i] > 0.0 && (lambda - problem.force_min()[i]) * unit < p_[i] * force)
      lambda = problem.force_min()[i];
    if (q_[i] > 0.0 && (problem.force_max()[i] - lambda_[i]) * unit < q_[i] * force)
      lambda = problem.force_max()[i];
    scratch_[i] = lambda;
  }
  problem.apply_transposed(scratch_.data(), d_.data());
  add(-1.0, y_, d_);
  return force > 0.0 ? problem.force_of(d_) / force : 0.0;
}

}  // namespace wuerfel
