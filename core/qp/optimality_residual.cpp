#include "core/qp/optimality_residual.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/qp/qp_solver.h"

namespace wuerfel {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// v / scale, where a scale of 0 allows nothing but 0.
double relative(double v, double scale) {
  if (v == 0.0) return 0.0;
  return scale > 0.0 ? v / scale : unbounded;
}

/// What turns a coordinate of a block into the units of the block's first: sqrt(M / M_first).
double unit_of(const QuadraticProgram& p, int coordinate) {
  const int first = coordinate - coordinate % p.block_size;
  return std::sqrt(p.mass[at(coordinate)] / p.mass[at(first)]);
}

double row_norm(const QuadraticProgram& p, int row) {
  double square = 0.0;
  for (int e = p.row_start[at(row)]; e < p.row_start[at(row) + 1]; ++e)
    for (int c = 0; c < p.block_size; ++c) {
      const double J = p.entry(e)[at(c)] / unit_of(p, p.entry_block[at(e)] * p.block_size + c);
      square += J * J;
    }
  return std::sqrt(square);
}

double row_value(const QuadraticProgram& p, int row, const std::vector<double>& x) {
  double value = 0.0;
  for (int e = p.row_start[at(row)]; e < p.row_start[at(row) + 1]; ++e)
    for (int c = 0; c < p.block_size; ++c)
      value += p.entry(e)[at(c)] * x[at(p.entry_block[at(e)] * p.block_size + c)];
  return value;
}

/// max_j |M (x - f) - J' lambda|, a force.
double unbalanced_force(const QuadraticProgram& p,
                        const std::vector<double>& x,
                        const std::vector<double>& multiplier) {
  std::vector<double> rest(x.size());
  for (std::size_t j = 0; j < x.size(); ++j)
    rest[j] = p.mass[j] * (x[j] - p.target[j]);
  for (int row = 0; row < p.rows(); ++row)
    for (int e = p.row_start[at(row)]; e < p.row_start[at(row) + 1]; ++e)
      for (int c = 0; c < p.block_size; ++c)
        rest[at(p.entry_block[at(e)] * p.block_size + c)] -=
            p.entry(e)[at(c)] * multiplier[at(row)];
  double worst = 0.0;
  for (int j = 0; j < p.unknowns(); ++j)
    worst = std::max(worst, std::abs(rest[at(j)]) / unit_of(p, j));
  return worst;
}

/// One row's part of the residual, `force` being the scale of forces.
void add_row(const QuadraticProgram& p,
             int row,
             double slack,
             double lambda,
             double norm,
             double force,
             double acceleration,
             QpResidual& residual) {
  const double force_min = p.force_min[at(row)];
  const double force_max = p.force_max[at(row)];
  const double outside = std::max({force_min - lambda, lambda - force_max, 0.0});
  residual.dual = std::max(residual.dual, relative(outside * norm, force));

  // Where J x > b the multiplier has to be at its smallest, where J x < b at its largest; if there
  // is none the row is violated.
  const double distance = slack > 0.0 ? lambda - force_min : force_max - lambda;
  const double gap = relative(std::abs(slack) / norm, acceleration);
  if (distance == unbounded)
    residual.primal = std::max(residual.primal, gap);
  else
    residual.complementarity = std::max(residual.complementarity,
                                        std::min(gap, relative(std::abs(distance) * norm, force)));
}

}  // namespace

double QpResidual::worst() const { return std::max({stationarity, primal, dual, complementarity}); }

void measure_scales(const QuadraticProgram& program, ResidualScales& scales) {
  scales.acceleration = 0.0;
  scales.weight = 0.0;
  for (int j = 0; j < program.unknowns(); ++j) {
    const double f = std::abs(program.target[at(j)]);
    scales.acceleration = std::max(scales.acceleration, f * unit_of(program, j));
    scales.weight = std::max(scales.weight, program.mass[at(j)] * f / unit_of(program, j));
  }
  double largest = 0.0;
  scales.row_norm.resize(program.bound.size());
  for (int row = 0; row < program.rows(); ++row) {
    scales.row_norm[at(row)] = row_norm(program, row);
    largest = std::max(largest, scales.row_norm[at(row)]);
  }
  for (int row = 0; row < program.rows(); ++row) {
    double& norm = scales.row_norm[at(row)];
    if (norm == 0.0) norm = largest > 0.0 ? largest : 1.0;
    if (program.force_min[at(row)] < 0.0 || program.bound[at(row)] > 0.0)
      scales.acceleration = std::max(scales.acceleration, std::abs(program.bound[at(row)]) / norm);
  }
}

QpResidual optimality_residual(const QuadraticProgram& program,
                               const std::vector<double>& x,
                               const std::vector<double>& multiplier) {
  QpResidual residual;
  const auto is_number = [](double v) { return std::isfinite(v); };
  if (!std::ranges::all_of(x, is_number) || !std::ranges::all_of(multiplier, is_number))
    return {unbounded, unbounded, unbounded, unbounded};

  ResidualScales scales;
  measure_scales(program, scales);
  double force = scales.weight;
  for (std::size_t i = 0; i < multiplier.size(); ++i)
    force = std::max(force, std::abs(multiplier[i]) * scales.row_norm[i]);

  residual.stationarity = relative(unbalanced_force(program, x, multiplier), force);
  for (int row = 0; row < program.rows(); ++row) {
    const double slack = row_value(program, row, x) - program.bound[at(row)];
    add_row(program, row, slack, multiplier[at(row)], scales.row_norm[at(row)], force,
            scales.acceleration, residual);
  }
  return residual;
}

}  // namespace wuerfel
