#include "core/qp/ipopt_polish.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/qp/least_norm_multipliers.h"

namespace wuerfel {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The program's point of least |y| on the rows that `result` leaves less slack than `tight` (in
/// units of h). An interior point stays sqrt(mu) away from rows that carry no force; this removes
/// the rest.
std::vector<double> onto_tight_rows(const QuadraticProgram& program,
                                    const ScaledProgram& form,
                                    const QpResult& result,
                                    double tight) {
  Eigen::MatrixXd g(program.rows(), program.unknowns());
  Eigen::VectorXd h(program.rows());
  Eigen::VectorXd y(program.unknowns());
  for (int j = 0; j < program.unknowns(); ++j)
    y[j] = (result.x[at(j)] - program.target[at(j)]) * std::sqrt(program.mass[at(j)]) / form.size;
  Eigen::Index count = 0;
  for (int row = 0; row < program.rows(); ++row) {
    const SparseRow& sparse = form.g[at(row)];
    g.row(count).setZero();
    for (std::size_t e = 0; e < sparse.columns.size(); ++e)
      g(count, sparse.columns[e]) = sparse.values[e];
    h[count] = form.h[at(row)];
    if (!sparse.columns.empty() && std::abs(g.row(count).dot(y) - h[count]) <= tight) ++count;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> projection;
  projection.setThreshold(1e-10);
  projection.compute(g.topRows(count));
  y = projection.solve(h.head(count));
  std::vector<double> x = program.target;
  for (std::size_t j = 0; j < x.size(); ++j)
    x[j] += y[static_cast<Eigen::Index>(j)] * form.size / std::sqrt(program.mass[j]);
  return x;
}

/// How wrong the accelerations of single bodies may be, the light ones among them, for which the
/// residual has no eye: the unbalance as an acceleration, and per row the violation or the smaller
/// of its slack and what its own force would move.
double local_error(const QuadraticProgram& p, const ScaledProgram& form, const QpResult& result) {
  std::vector<double> unbalance(result.x.size());
  for (std::size_t j = 0; j < result.x.size(); ++j)
    unbalance[j] = result.x[j] - p.target[j];
  double error = 0.0;
  for (int row = 0; row < p.rows(); ++row) {
    const SparseRow& g = form.g[at(row)];
    const double lambda = result.multiplier[at(row)];
    double slack = -p.bound[at(row)];
    double push = 0.0;
    double size = 0.0;
    for (std::size_t e = 0; e < g.columns.size(); ++e) {
      const std::size_t j = at(g.columns[e]);
      const double J = g.values[e] * form.norm[at(row)] * std::sqrt(p.mass[j]);
      slack += J * result.x[j];
      push += J * J / p.mass[j];
      size = std::max(size, std::abs(J));
      unbalance[j] -= J * lambda / p.mass[j];
    }
    const double distance =
        slack > 0.0 ? lambda - p.force_min[at(row)] : p.force_max[at(row)] - lambda;
    if (size > 0.0 && distance != 0.0)
      error = std::max(error, std::min(std::abs(slack), distance * push) / size);
  }
  for (const double u : unbalance)
    error = std::max(error, std::abs(u));
  return error;
}

/// Cubic in the number of unknowns, so for small programs only.
constexpr int largest_to_polish = 400;
/// An error of accelerations, relative to the size of the scaled program, that needs no polishing.
constexpr double exact_enough = 1e-13;

constexpr double good_residual = 1e-10;

}  // namespace

void polish(const QuadraticProgram& program, const ScaledProgram& form, QpResult& result) {
  if (program.unknowns() > largest_to_polish || program.rows() > 2 * largest_to_polish) return;
  double error = local_error(program, form, result);
  if (error <= exact_enough * form.size) return;
  QpResult candidate;
  for (const double tight : {1e-6, 1e-8}) {
    candidate.x = onto_tight_rows(program, form, result, tight);
    candidate.multiplier =
        least_norm_multipliers(program, candidate.x, {}, {.tight = tight}).multiplier;
    candidate.residual = optimality_residual(program, candidate.x, candidate.multiplier);
    const double candidate_error = local_error(program, form, candidate);
    // While the residual is poor it decides; once it is good, the light bodies do.
    const double worst = candidate.residual.worst();
    const bool better = result.residual.worst() > good_residual
                            ? worst < result.residual.worst()
                            : worst <= good_residual && candidate_error < error;
    if (!better) continue;
    error = candidate_error;
    result.x = candidate.x;
    result.multiplier = candidate.multiplier;
    result.residual = candidate.residual;
  }
}

}  // namespace wuerfel
