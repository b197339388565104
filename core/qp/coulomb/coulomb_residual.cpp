#include "core/qp/coulomb/coulomb_residual.h"

#include <algorithm>
#include <cmath>

#include "core/qp/residual_meter.h"

namespace wuerfel {
namespace {

/// v / scale, where a scale of 0 allows nothing but 0.
double relative(double v, double scale) {
  if (v == 0.0) return 0.0;
  return scale > 0.0 ? v / scale : std::copysign(unbounded, v);
}

}  // namespace

/// |min(lambda, u)| for lambda >= 0, u >= 0.
double CoulombJudge::complementarity(const Relative& r) {
  return std::abs(std::min(r.force, r.velocity));
}

double CoulombResidual::worst() const { return std::max({stationarity, rows, normal, cone, slip}); }

void CoulombJudge::find_units(const QuadraticProgram& p) {
  if (mass_ == p.mass) return;
  mass_ = p.mass;
  unit_.resize(mass_.size());
  for (int j = 0; j < p.unknowns(); ++j)
    unit_[j] = std::sqrt(mass_[j - j % p.block_size] / mass_[j]);
  square_.resize(mass_.size());
  std::ranges::transform(unit_, square_.begin(), [](double unit) { return unit * unit; });
}

const CoulombScales& CoulombJudge::measure_scales(const QuadraticProgram& p) {
  find_units(p);
  scales_.velocity = scales_.weight = 0.0;
  for (int j = 0; j < p.unknowns(); ++j) {
    scales_.velocity = std::max(scales_.velocity, std::abs(p.target[j]) / unit_[j]);
    scales_.weight = std::max(scales_.weight, std::abs(p.target[j] * p.mass[j]) * unit_[j]);
  }
  scales_.row_norm.resize(p.bound.size());
  for (int i = 0; i < p.rows(); ++i)
    scales_.row_norm[i] = std::sqrt(square_of(p, i, square_));
  replace_zero_norms(scales_.row_norm);
  for (int i = 0; i < p.rows(); ++i)
    scales_.velocity = std::max(scales_.velocity, std::abs(p.bound[i]) / scales_.row_norm[i]);
  return scales_;
}

/// Slacks and forces out of balance; returns the largest force at hand.
double CoulombJudge::apply_rows(const QuadraticProgram& p,
                                const std::vector<double>& x,
                                const std::vector<double>& multiplier) {
  force_.resize(x.size());
  slack_.resize(p.bound.size());
  for (int j = 0; j < p.unknowns(); ++j)
    force_[j] = p.mass[j] * (x[j] - p.target[j]);
  double largest = scales_.weight;
  for (int i = 0; i < p.rows(); ++i) {
    largest = std::max(largest, std::abs(multiplier[i]) * scales_.row_norm[i]);
    slack_[i] = p.slack(i, x);
    p.add_row_force(i, -multiplier[i], force_);
  }
  return largest;
}

/// A row's multiplier and slack.
CoulombJudge::Relative CoulombJudge::relative_row(int row, double multiplier) const {
  const double norm = scales_.row_norm[row];
  return {relative(multiplier * norm, largest_force_),
          relative(slack_[row] / norm, scales_.velocity)};
}

void CoulombJudge::add_contact(const FrictionContact& c,
                               const std::vector<double>& multiplier,
                               CoulombResidual& residual) const {
  const double ln = multiplier[c.normal];
  residual.normal = std::max(residual.normal, complementarity(relative_row(c.normal, ln)));
  if (c.tangent < 0) return;
  const double lt = multiplier[c.tangent];
  const double outside = std::max(std::abs(lt) - c.mu * std::max(ln, 0.0), 0.0);
  residual.cone = std::max(residual.cone, relative_row(c.tangent, outside).force);
  if (c.mu == 0.0) return;
  const double direction = c.slides != 0 ? c.slides : std::copysign(1.0, slack_[c.tangent]);
  const Relative r = relative_row(c.tangent, c.mu * ln + direction * lt);
  const double excess = std::abs(r.force);
  residual.slip =
      std::max(residual.slip, c.slides != 0 ? excess : std::min(std::abs(r.velocity), excess));
}

CoulombResidual CoulombJudge::measure(const FrictionProgram& friction,
                                      const std::vector<double>& x,
                                      const std::vector<double>& multiplier) {
  const QuadraticProgram& p = friction.program;
  CoulombResidual residual;
  if (!all_finite(x) || !all_finite(multiplier)) {
    residual.stationarity = unbounded;
    return residual;
  }
  largest_force_ = apply_rows(p, x, multiplier);
  for (int j = 0; j < p.unknowns(); ++j) {
    residual.stationarity =
        std::max(residual.stationarity, std::abs(relative(force_[j] * unit_[j], largest_force_)));
  }
  of_contact_.assign(p.bound.size(), 0);
  for (const FrictionContact& c : friction.contacts) {
    of_contact_[c.normal] = 1;
    if (c.tangent >= 0) of_contact_[c.tangent] = 1;
    add_contact(c, multiplier, residual);
  }
  for (int i = 0; i < p.rows(); ++i) {
    if (of_contact_[i] != 0) continue;
    const Relative r = relative_row(i, multiplier[i]);
    residual.rows =
        std::max(residual.rows, p.is_equality(i) ? std::abs(r.velocity) : complementarity(r));
  }
  return residual;
}

CoulombResidual coulomb_residual(const FrictionProgram& friction,
                                 const std::vector<double>& x,
                                 const std::vector<double>& multiplier) {
  CoulombJudge judge;
  judge.measure_scales(friction.program);
  return judge.measure(friction, x, multiplier);
}

}  // namespace wuerfel
