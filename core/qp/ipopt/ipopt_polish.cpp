#include "core/qp/ipopt/ipopt_polish.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/qp/residual_meter.h"

namespace wuerfel {
namespace {

/// The rows that `result` leaves less slack than `tight` (in units of h), as rows of G y = h.
struct TightRows {
  std::vector<int> row;  ///< of the program
  Eigen::MatrixXd G;
  Eigen::VectorXd h;
};

TightRows tight_rows(const QuadraticProgram& program,
                     const ScaledProgram& form,
                     const QpResult& result,
                     double tight) {
  Eigen::VectorXd y(program.unknowns());
  for (int j = 0; j < program.unknowns(); ++j)
    y[j] = (result.x[j] - program.target[j]) * std::sqrt(program.mass[j]) / form.size;
  TightRows rows{{}, Eigen::MatrixXd::Zero(program.rows(), program.unknowns()), {}};
  rows.h.resize(program.rows());
  Eigen::Index count = 0;
  for (int row = 0; row < program.rows(); ++row) {
    const SparseRow& sparse = form.g[row];
    rows.G.row(count).setZero();
    for (std::size_t e = 0; e < sparse.columns.size(); ++e)
      rows.G(count, sparse.columns[e]) = sparse.values[e];
    rows.h[count] = form.h[row];
    if (sparse.columns.empty() || std::abs(rows.G.row(count).dot(y) - rows.h[count]) > tight)
      continue;
    rows.row.push_back(row);
    ++count;
  }
  rows.G.conservativeResize(count, Eigen::NoChange);
  rows.h.conservativeResize(count);
  return rows;
}

/// The program's point of least |y| on the rows that look tight, and the multipliers nearest to those
/// of `result` that lead there. An interior point stays sqrt(mu) away from rows that carry no force;
/// this removes the rest.
QpResult onto_tight_rows(const QuadraticProgram& program,
                         const ScaledProgram& form,
                         const QpResult& result,
                         double tight) {
  constexpr double dependent = 1e-10;
  const TightRows rows = tight_rows(program, form, result, tight);
  QpResult moved;
  moved.x = program.target;
  moved.multiplier.assign(program.bound.size(), 0.0);
  moved.residual = optimality_residual(program, moved.x, moved.multiplier);
  if (rows.row.empty()) return moved;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(dependent);
  const Eigen::VectorXd y = decomposition.compute(rows.G).solve(rows.h);
  Eigen::VectorXd lambda(rows.h.size());
  for (Eigen::Index k = 0; k < lambda.size(); ++k)
    lambda[k] = result.multiplier[rows.row[k]] * form.norm[rows.row[k]] / form.size;
  decomposition.compute(rows.G.transpose());
  for (int round = 0; round < 2; ++round)  // the second one refines
    lambda += decomposition.solve(y - rows.G.transpose() * lambda);

  for (int j = 0; j < program.unknowns(); ++j)
    moved.x[j] += y[j] * form.size / std::sqrt(program.mass[j]);
  for (Eigen::Index k = 0; k < lambda.size(); ++k) {
    const int row = rows.row[k];
    moved.multiplier[row] = std::clamp(lambda[k] * form.size / form.norm[row],
                                       program.force_min[row], program.force_max[row]);
  }
  moved.residual = optimality_residual(program, moved.x, moved.multiplier);
  return moved;
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
    const SparseRow& g = form.g[row];
    const double lambda = result.multiplier[row];
    double slack = -p.bound[row];
    double push = 0.0;
    double size = 0.0;
    for (std::size_t e = 0; e < g.columns.size(); ++e) {
      const std::size_t j = g.columns[e];
      const double J = g.values[e] * form.norm[row] * std::sqrt(p.mass[j]);
      slack += J * result.x[j];
      push += J * J / p.mass[j];
      size = std::max(size, std::abs(J));
      unbalance[j] -= J * lambda / p.mass[j];
    }
    const double distance = slack > 0.0 ? lambda - p.force_min[row] : p.force_max[row] - lambda;
    if (size > 0.0 && distance != 0.0)
      error = std::max(error, std::min(std::abs(slack), distance * push) / size);
  }
  for (const double u : unbalance)
    error = std::max(error, std::abs(u));
  return error;
}

/// Cubic in the number of unknowns, so for small programs only.
constexpr int largest_to_polish = 400;
constexpr double good_residual = QpSettings{}.tolerance;

}  // namespace

void polish(const QuadraticProgram& program, const ScaledProgram& form, QpResult& result) {
  if (program.unknowns() > largest_to_polish || program.rows() > 2 * largest_to_polish) return;
  double error = local_error(program, form, result);
  if (error <= exact_residual * form.size) return;
  for (const double tight : {1e-6, 1e-8}) {
    const QpResult candidate = onto_tight_rows(program, form, result, tight);
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
