#include "core/qp/coulomb/cone_interior_point.h"

#include <algorithm>
#include <cmath>

#include "core/qp/coulomb/dice.h"
#include "core/qp/refinement.h"

namespace wuerfel {
namespace {

constexpr double boundary_share = 0.995;
constexpr double short_step = 0.1;   ///< below it the corrector is given up
constexpr double stuck_step = 0.02;  ///< four of these in a row end it
constexpr int most_stuck_steps = 4;

double square(const std::vector<Quad>& v) {
  double sum = 0.0;
  for (const Quad& q : v)
    sum += q.v[0] * q.v[0] + q.v[1] * q.v[1] + q.v[2] * q.v[2];
  return sum;
}

}  // namespace

/// All products equal, or as their weights ask.
void ConeInteriorPoint::start(const ContactForm& form, const ConeInteriorEffort& effort) {
  Dice dice(effort.seed);
  at_.reset(form);
  pairs_.assign(form.count(), Pairs{});
  double size = 0.0;
  for (const ContactUnit& unit : form.units()) {
    size = std::max(size, std::abs(unit.h.n) / std::sqrt(unit.square.n));
    if (unit.tangent >= 0) size = std::max(size, std::abs(unit.h.t) / std::sqrt(unit.square.t));
  }
  if (size == 0.0) size = 1.0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    Pairs& p = pairs_[i];
    if (unit.equality) continue;
    const double norm = std::sqrt(unit.square.n);
    p.count = unit.tangent >= 0 && unit.slides == 0 ? 3 : 1;
    p.force[0] = size / norm;
    for (int k = 1; k < p.count; ++k)
      p.force[k] = unit.mu * p.force[0];
    for (int k = 0; k < p.count; ++k) {
      if (effort.spread > 0.0) p.weight[k] = std::exp(effort.spread * (2.0 * dice.next() - 1.0));
      p.slack[k] = p.weight[k] * size * size / p.force[k];
    }
    at_.l[i].n = p.force[0];
    if (unit.slides != 0) at_.l[i].t = -unit.slides * unit.mu * p.force[0];
  }
  at_.recompute(form);
}

/// Of force times slack over weight, after a step along the direction.
double ConeInteriorPoint::mean_product(double step) const {
  double sum = 0.0;
  int count = 0;
  for (const Pairs& p : pairs_) {
    for (int k = 0; k < p.count; ++k) {
      sum += (p.force[k] + step * p.d_force[k]) * (p.slack[k] + step * p.d_slack[k]) / p.weight[k];
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

/// C^-1 of every unit.
void ConeInteriorPoint::set_weights(const ContactForm& form, double delta) {
  weight_.resize(pairs_.size());
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    const Pairs& p = pairs_[i];
    ContactForm::Weight w;
    w.nn = 1.0 / (delta * unit.compliance.n + p.slack[0] / p.force[0]);
    if (p.count == 3) {
      const double A = p.slack[1] / p.force[1];
      const double B = p.slack[2] / p.force[2];
      w.tt = 1.0 / (delta * unit.compliance.t + A + B);
      w.tn = -unit.mu * (B - A) * w.nn * w.tt;
    } else if (unit.slides != 0) {
      w.tn = -unit.slides * unit.mu * w.nn;
    }
    weight_[i] = w;
  }
}

/// dl of dy_, and u_ = G' (l + dl) - (y + dy).
void ConeInteriorPoint::find_forces(const ContactForm& form) {
  form.apply(dy_.data(), Gdy_.data());
  for (int i = 0; i < form.count(); ++i) {
    const ContactForm::Weight& w = weight_[i];
    const double n = right_[i].n - Gdy_[i].n;
    dl_[i] = {w.nn * n, w.tn * n + w.tt * (right_[i].t - Gdy_[i].t)};
  }
  for (int i = 0; i < form.count(); ++i) {
    dl_[i].n += at_.l[i].n;
    dl_[i].t += at_.l[i].t;
  }
  form.apply_transposed(dl_.data(), u_.data());
  for (int i = 0; i < form.count(); ++i) {
    dl_[i].n -= at_.l[i].n;
    dl_[i].t -= at_.l[i].t;
  }
  for (std::size_t b = 0; b < u_.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      u_[b].v[c] -= at_.y[b].v[c] + dy_[b].v[c];
  }
}

/// Newton's direction to products weight * tau less the corrector's terms.
void ConeInteriorPoint::find_direction(const ContactForm& form, double tau) {
  right_.resize(pairs_.size());
  dl_.resize(pairs_.size());
  Gdy_.resize(pairs_.size());
  for (int i = 0; i < form.count(); ++i) {
    const Pairs& p = pairs_[i];
    double to[3] = {0.0, 0.0, 0.0};  // what the slacks become where the forces stay
    for (int k = 0; k < p.count; ++k)
      to[k] = (p.weight[k] * tau - p.extra[k]) / p.force[k];
    right_[i] = {at_.rest[i].n + to[0], at_.rest[i].t + to[2] - to[1]};
  }
  dy_.assign(at_.y.size(), Quad{});
  u_.resize(dy_.size());
  find_forces(form);
  double former = unbounded;
  for (int round = 0; round <= most_refinements; ++round) {
    form.solve(u_.data());
    for (std::size_t b = 0; b < dy_.size(); ++b) {
      for (int c = 0; c < 3; ++c)
        dy_[b].v[c] += u_[b].v[c];
    }
    find_forces(form);
    const double missed = square(u_);
    if (missed <= 1e-28 * square(dy_) || !(missed < 0.25 * former)) break;
    former = missed;
  }
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    Pairs& p = pairs_[i];
    p.d_force[0] = dl_[i].n;
    p.d_force[1] = unit.mu * dl_[i].n - dl_[i].t;
    p.d_force[2] = unit.mu * dl_[i].n + dl_[i].t;
    for (int k = 0; k < p.count; ++k) {
      p.d_slack[k] =
          (p.weight[k] * tau - p.extra[k] - p.slack[k] * p.d_force[k]) / p.force[k] - p.slack[k];
    }
  }
}

double ConeInteriorPoint::longest_step() const {
  double step = 1.0 / boundary_share;
  for (const Pairs& p : pairs_) {
    for (int k = 0; k < p.count; ++k) {
      if (p.d_force[k] < 0.0) step = std::min(step, -p.force[k] / p.d_force[k]);
      if (p.d_slack[k] < 0.0) step = std::min(step, -p.slack[k] / p.d_slack[k]);
    }
  }
  return step;
}

void ConeInteriorPoint::move(const ContactForm& form, double step) {
  for (int i = 0; i < form.count(); ++i) {
    Pairs& p = pairs_[i];
    for (int k = 0; k < p.count; ++k) {
      p.force[k] += step * p.d_force[k];
      p.slack[k] += step * p.d_slack[k];
    }
    at_.l[i].n += step * dl_[i].n;
    at_.l[i].t += step * dl_[i].t;
    at_.rest[i].n -= step * Gdy_[i].n;
    at_.rest[i].t -= step * Gdy_[i].t;
  }
  for (std::size_t b = 0; b < dy_.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      at_.y[b].v[c] += step * dy_[b].v[c];
  }
}

ConeInteriorPoint::Product ConeInteriorPoint::product_of(const ContactUnit& unit,
                                                         const Pairs& p,
                                                         int k,
                                                         double per_force) {
  const double norm = k == 0 ? unit.norm.n : unit.norm.t;
  const double per_velocity = k == 0 ? unit.per_velocity.n : unit.per_velocity.t;
  return {p.force[k] * norm * per_force, p.slack[k] * per_velocity};
}

/// The smaller of every pair and what rows miss, forces to the largest force.
double ConeInteriorPoint::worst_pair(const ContactForm& form, double weight) const {
  double force = weight;
  for (int i = 0; i < form.count(); ++i)
    force = std::max(force, std::abs(at_.l[i].n) * form.units()[i].norm.n);
  const double per_force = force > 0.0 ? 1.0 / force : 1.0;
  double worst = 0.0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    const Pairs& p = pairs_[i];
    for (int k = 0; k < p.count; ++k) {
      const Product product = product_of(unit, p, k, per_force);
      worst = std::max(worst, std::min(product.force, product.slack));
    }
    const double n = at_.rest[i].n + p.slack[0];
    worst = std::max(worst, std::abs(n) * unit.per_velocity.n);
    if (p.count == 3) {
      const double t = at_.rest[i].t + p.slack[2] - p.slack[1];
      worst = std::max(worst, std::abs(t) * unit.per_velocity.t);
    }
  }
  if (!std::isfinite(worst)) return unbounded;
  return worst;
}

/// Every pair's smaller partner to zero.
void ConeInteriorPoint::round_off(const ContactForm& form,
                                  double weight,
                                  ContactPoint& point) const {
  point = at_;
  double force = weight;
  for (int i = 0; i < form.count(); ++i)
    force = std::max(force, std::abs(at_.l[i].n) * form.units()[i].norm.n);
  const double per_force = force > 0.0 ? 1.0 / force : 1.0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    const Pairs& p = pairs_[i];
    if (p.count == 0) continue;
    const auto is_force = [&](int k) {
      const Product product = product_of(unit, p, k, per_force);
      return product.force >= product.slack;
    };
    Pair& l = point.l[i];
    if (!is_force(0)) l = {};
    if (p.count == 3 && l.n > 0.0 && !is_force(1)) l.t = unit.mu * l.n;
    if (p.count == 3 && l.n > 0.0 && !is_force(2)) l.t = -unit.mu * l.n;
    clamp_to_cone(unit, l);
  }
}

/// Predictor and corrector; beyond a fold, where det K < 0, tau has to grow.
void ConeInteriorPoint::choose_direction(const ContactForm& form) {
  const double tau = mean_product(0.0);
  const auto forget_corrector = [&] {
    for (Pairs& p : pairs_)
      std::fill(p.extra, p.extra + 3, 0.0);
  };
  forget_corrector();
  if (form.sign() < 0) {
    find_direction(form, 2.0 * tau);
    return;
  }
  find_direction(form, 0.0);
  const double affine = std::min(1.0, boundary_share * longest_step());
  const double ratio = tau > 0.0 ? mean_product(affine) / tau : 0.0;
  for (Pairs& p : pairs_) {
    for (int k = 0; k < p.count; ++k)
      p.extra[k] = p.d_force[k] * p.d_slack[k];
  }
  find_direction(form, std::clamp(ratio * ratio * ratio, 0.0, 1.0) * tau);
  if (boundary_share * longest_step() >= short_step) return;
  forget_corrector();
  find_direction(form, 0.9 * tau);
}

ConeInteriorOutcome ConeInteriorPoint::run(ContactForm& form,
                                           double weight,
                                           const ConeInteriorEffort& effort,
                                           ContactPoint& point) {
  ConeInteriorOutcome outcome;
  start(form, effort);
  int stuck = 0;
  while (outcome.factorisations < effort.most_factorisations && stuck < most_stuck_steps) {
    set_weights(form, effort.delta);
    ++outcome.factorisations;
    if (!form.factorise(weight_)) break;
    choose_direction(form);
    const double step = std::min(1.0, boundary_share * longest_step());
    move(form, step);
    const double worst = worst_pair(form, weight);
    if (worst < outcome.worst) {
      outcome.worst = worst;
      round_off(form, weight, point);
    }
    if (worst <= effort.goal || worst == unbounded) break;
    stuck = step < stuck_step ? stuck + 1 : 0;
  }
  return outcome;
}

}  // namespace wuerfel
