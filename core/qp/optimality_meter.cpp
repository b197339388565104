#include "core/qp/optimality_meter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace wuerfel {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// v / scale, where a scale of 0 allows nothing but 0.
double relative(double v, double scale) {
  if (v == 0.0) return 0.0;
  return scale > 0.0 ? v / scale : unbounded;
}

/// Calls visit(coefficient, coordinate) for every coefficient of a row of blocks of `size`.
template <typename Size, typename Visit>
void for_blocks(const QuadraticProgram& p, std::size_t row, Size size, Visit&& visit) {
  const int last = p.row_start[row + 1];
  for (int e = p.row_start[row]; e < last; ++e) {
    const double* J = p.coefficients.data() + at(e) * size;
    const std::size_t first = at(p.entry_block[at(e)]) * size;
    for (std::size_t c = 0; c < size; ++c)
      visit(J[c], first + c);
  }
}

/// The same; the usual size is known to the compiler.
template <typename Visit>
void for_row(const QuadraticProgram& p, std::size_t row, Visit&& visit) {
  if (p.block_size == 3) {
    for_blocks(p, row, std::integral_constant<std::size_t, 3>{}, visit);
  } else {
    for_blocks(p, row, at(p.block_size), visit);
  }
}

/// Zero if all values are numbers, else not a number.
double nothing(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values)
    sum += v * 0.0;
  return sum;
}

/// One row's part of the residual, `force` being the scale of forces.
void add_row(double force_min,
             double force_max,
             double slack,
             double lambda,
             double norm,
             double force,
             double acceleration,
             QpResidual& residual) {
  const double outside = std::max({force_min - lambda, lambda - force_max, 0.0});
  if (outside > 0.0) residual.dual = std::max(residual.dual, relative(outside * norm, force));
  if (slack == 0.0) return;

  // Where J x > b the multiplier has to be at its smallest, where J x < b at its largest; if there
  // is none the row is violated.
  const double distance = slack > 0.0 ? lambda - force_min : force_max - lambda;
  if (distance == 0.0) return;
  const double gap = relative(std::abs(slack) / norm, acceleration);
  if (distance == unbounded) {
    residual.primal = std::max(residual.primal, gap);
  } else {
    residual.complementarity = std::max(residual.complementarity,
                                        std::min(gap, relative(std::abs(distance) * norm, force)));
  }
}

}  // namespace

double QpResidual::worst() const { return std::max({stationarity, primal, dual, complementarity}); }

const ResidualScales& OptimalityMeter::measure_scales(const QuadraticProgram& p) {
  scales_.acceleration = 0.0;
  scales_.weight = 0.0;
  unit_.resize(p.mass.size());
  for (int first = 0; first < p.unknowns(); first += p.block_size) {
    for (int j = first; j < first + p.block_size; ++j) {
      const double f = std::abs(p.target[at(j)]);
      const double M = p.mass[at(j)];
      const double unit = j == first ? 1.0 : std::sqrt(M / p.mass[at(first)]);
      unit_[at(j)] = 1.0 / unit;
      scales_.acceleration = std::max(scales_.acceleration, f * unit);
      scales_.weight = std::max(scales_.weight, M * f / unit);
    }
  }
  double largest = 0.0;
  scales_.row_norm.resize(p.bound.size());
  for (int row = 0; row < p.rows(); ++row) {
    double square = 0.0;
    for_row(p, at(row),
            [&](double J, std::size_t j) { square += (J * unit_[j]) * (J * unit_[j]); });
    scales_.row_norm[at(row)] = std::sqrt(square);
    largest = std::max(largest, scales_.row_norm[at(row)]);
  }
  for (int row = 0; row < p.rows(); ++row) {
    double& norm = scales_.row_norm[at(row)];
    if (norm == 0.0) norm = largest > 0.0 ? largest : 1.0;
    if (p.bound[at(row)] > 0.0 || (p.bound[at(row)] < 0.0 && p.force_min[at(row)] < 0.0))
      scales_.acceleration = std::max(scales_.acceleration, std::abs(p.bound[at(row)]) / norm);
  }
  return scales_;
}

/// max_j |M (x - f) - J' lambda|; fills the slacks J x - b on the way.
double OptimalityMeter::unbalanced_force(const QuadraticProgram& p,
                                         const std::vector<double>& x,
                                         const std::vector<double>& multiplier) {
  force_.resize(x.size());
  slack_.resize(multiplier.size());
  for (std::size_t j = 0; j < x.size(); ++j)
    force_[j] = p.mass[j] * (x[j] - p.target[j]);
  for (int row = 0; row < p.rows(); ++row) {
    double value = 0.0;
    const double lambda = multiplier[at(row)];
    for_row(p, at(row), [&](double J, std::size_t j) {
      value += J * x[j];
      force_[j] -= J * lambda;
    });
    slack_[at(row)] = value - p.bound[at(row)];
  }
  double worst = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j)
    worst = std::max(worst, std::abs(force_[j]) * unit_[j]);
  return worst;
}

QpResidual OptimalityMeter::measure(const QuadraticProgram& program,
                                    const std::vector<double>& x,
                                    const std::vector<double>& multiplier) {
  const bool fits = x.size() == program.mass.size() && multiplier.size() == program.bound.size();
  if (!fits || nothing(x) != 0.0 || nothing(multiplier) != 0.0)
    return {unbounded, unbounded, unbounded, unbounded};

  double force = scales_.weight;
  for (std::size_t i = 0; i < multiplier.size(); ++i)
    force = std::max(force, std::abs(multiplier[i]) * scales_.row_norm[i]);

  QpResidual residual;
  residual.stationarity = relative(unbalanced_force(program, x, multiplier), force);
  for (std::size_t i = 0; i < multiplier.size(); ++i) {
    add_row(program.force_min[i], program.force_max[i], slack_[i], multiplier[i],
            scales_.row_norm[i], force, scales_.acceleration, residual);
  }
  return residual;
}

QpResidual optimality_residual(const QuadraticProgram& program,
                               const std::vector<double>& x,
                               const std::vector<double>& multiplier) {
  OptimalityMeter meter;
  meter.measure_scales(program);
  return meter.measure(program, x, multiplier);
}

}  // namespace wuerfel
