#include "core/qp/residual_meter.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// v / scale, where a scale of 0 allows nothing but 0.
double relative(double v, double scale) {
  if (v == 0.0) return 0.0;
  return scale > 0.0 ? v / scale : unbounded;
}

/// 1 / scale, so that nothing but 0 passes a scale of 0.
double inverse(double scale) { return scale > 0.0 ? 1.0 / scale : unbounded; }

/// What of a row its part of the residual depends on, but for the scales.
struct Row {
  double force_min, force_max, slack, lambda, norm;
};

/// One row's part of the residual, under the inverse scales of forces and accelerations.
void add_row(const Row& row, double per_force, double per_acceleration, QpResidual& residual) {
  const auto& [force_min, force_max, slack, lambda, norm] = row;
  const double outside = std::max({force_min - lambda, lambda - force_max, 0.0});
  if (outside > 0.0) residual.dual = std::max(residual.dual, outside * norm * per_force);
  if (slack == 0.0) return;

  // Where J x > b the multiplier has to be at its smallest, where J x < b at its largest; if there
  // is none the row is violated.
  const double distance = slack > 0.0 ? lambda - force_min : force_max - lambda;
  if (distance == 0.0) return;
  const double gap = std::abs(slack) / norm * per_acceleration;
  if (distance == unbounded) {
    residual.primal = std::max(residual.primal, gap);
  } else {
    residual.complementarity =
        std::max(residual.complementarity, std::min(gap, std::abs(distance) * norm * per_force));
  }
}

}  // namespace

double square_of(const QuadraticProgram& p, int row, const std::vector<double>& weight) {
  double sum = 0.0;
  p.for_each_entry(row, [&](const double* J, int first, int size) {
    for (int c = 0; c < size; ++c)
      sum += J[c] * J[c] * weight[first + c];
  });
  return sum;
}

void replace_zero_norms(std::vector<double>& norms) {
  double least = 1.0;
  for (const double norm : norms)
    if (norm > 0.0) least = std::min(least, norm);
  std::ranges::replace(norms, 0.0, least);
}

double ResidualScales::largest_force(const std::vector<double>& multiplier) const {
  double force = weight;
  for (std::size_t i = 0; i < multiplier.size(); ++i)
    force = std::max(force, std::abs(multiplier[i]) * row_norm[i]);
  return force;
}

double QpResidual::worst() const { return std::max({stationarity, primal, dual, complementarity}); }

void ResidualMeter::find_units(const QuadraticProgram& p) {
  mass_ = p.mass;
  block_size_ = p.block_size;
  for (auto* v : {&unit_, &root_, &weight_})
    v->resize(mass_.size());
  const int size = p.block_size;
  for (std::size_t j = 0; j < mass_.size(); ++j) {
    const double ratio = mass_[j] / mass_[j - j % size];
    root_[j] = std::sqrt(ratio);
    unit_[j] = 1.0 / root_[j];
    weight_[j] = 1.0 / ratio;
  }
}

const ResidualScales& ResidualMeter::measure_scales(const QuadraticProgram& p) {
  scales_.acceleration = 0.0;
  scales_.weight = 0.0;
  if (mass_ != p.mass || block_size_ != p.block_size) find_units(p);
  for (std::size_t j = 0; j < p.mass.size(); ++j) {
    const double f = std::abs(p.target[j]);
    scales_.acceleration = std::max(scales_.acceleration, f * root_[j]);
    scales_.weight = std::max(scales_.weight, p.mass[j] * f * unit_[j]);
  }
  scales_.row_norm.resize(p.bound.size());
  for (int row = 0; row < p.rows(); ++row)
    scales_.row_norm[row] = std::sqrt(square_of(p, row, weight_));
  replace_zero_norms(scales_.row_norm);
  for (int row = 0; row < p.rows(); ++row) {
    const double norm = scales_.row_norm[row];
    if (p.bound[row] > 0.0 || (p.bound[row] < 0.0 && p.force_min[row] < 0.0))
      scales_.acceleration = std::max(scales_.acceleration, std::abs(p.bound[row]) / norm);
  }
  return scales_;
}

/// max_j |M (x - f) - J' lambda|; fills the slacks J x - b on the way.
double ResidualMeter::unbalanced_force(const QuadraticProgram& p,
                                       const std::vector<double>& x,
                                       const std::vector<double>& multiplier) {
  force_.resize(x.size());
  slack_.resize(multiplier.size());
  for (std::size_t j = 0; j < x.size(); ++j)
    force_[j] = p.mass[j] * (x[j] - p.target[j]);
  for (int row = 0; row < p.rows(); ++row) {
    // Both at once: this is the time that a certificate takes.
    double slack = -p.bound[row];
    const double lambda = multiplier[row];
    p.for_each_entry(row, [&](const double* J, int first, int size) {
      for (int c = 0; c < size; ++c) {
        slack += J[c] * x[first + c];
        force_[first + c] -= J[c] * lambda;
      }
    });
    slack_[row] = slack;
  }
  double worst = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j)
    worst = std::max(worst, std::abs(force_[j]) * unit_[j]);
  return worst;
}

QpResidual ResidualMeter::measure(const QuadraticProgram& program,
                                  const std::vector<double>& x,
                                  const std::vector<double>& multiplier) {
  const bool fits = x.size() == program.mass.size() && multiplier.size() == program.bound.size();
  if (!fits || !all_finite(x) || !all_finite(multiplier))
    return {unbounded, unbounded, unbounded, unbounded};

  const double force = scales_.largest_force(multiplier);
  QpResidual residual;
  residual.stationarity = relative(unbalanced_force(program, x, multiplier), force);
  const double per_force = inverse(force);
  const double per_acceleration = inverse(scales_.acceleration);
  for (std::size_t i = 0; i < multiplier.size(); ++i) {
    add_row(
        {program.force_min[i], program.force_max[i], slack_[i], multiplier[i], scales_.row_norm[i]},
        per_force, per_acceleration, residual);
  }
  return residual;
}

double ResidualMeter::imbalance(const QuadraticProgram& p,
                                const std::vector<double>& x,
                                const std::vector<double>& multiplier) {
  constexpr double least_share = 1e-6;
  static_cast<void>(unbalanced_force(p, x, multiplier));
  double all = 0.0;
  scale_.assign(p.blocks(), 0.0);
  for (int j = 0; j < p.unknowns(); ++j) {
    const double weight = p.mass[j] * std::abs(p.target[j]) * unit_[j];
    double& scale = scale_[j / p.block_size];
    scale = std::max(scale, weight);
    all += weight;
  }
  for (int row = 0; row < p.rows(); ++row) {
    p.for_each_entry(row, [&](const double* J, int first, int size) {
      double& scale = scale_[first / size];
      for (int c = 0; c < size; ++c)
        scale = std::max(scale, std::abs(J[c] * multiplier[row]) * unit_[first + c]);
    });
  }
  double worst = 0.0;
  for (int j = 0; j < p.unknowns(); ++j) {
    const double scale = std::max(scale_[j / p.block_size], least_share * all);
    worst = std::max(worst, relative(std::abs(force_[j]) * unit_[j], scale));
  }
  return worst;
}

double ResidualMeter::row_scale(const QuadraticProgram& program, int row) const {
  double scale = unbounded;
  program.for_each_entry(row, [&](const double* /*J*/, int first, int size) {
    scale = std::min(scale, scale_[first / size]);
  });
  return scale;
}

QpResidual optimality_residual(const QuadraticProgram& program,
                               const std::vector<double>& x,
                               const std::vector<double>& multiplier) {
  ResidualMeter meter;
  meter.measure_scales(program);
  return meter.measure(program, x, multiplier);
}

}  // namespace wuerfel
