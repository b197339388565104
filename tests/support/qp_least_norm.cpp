#include "tests/support/qp_least_norm.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

#include "core/qp/residual_meter.h"
#include "tests/support/qp_non_negative_least_squares.h"

namespace wuerfel::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The tight rows as columns of A, so that A l = r balances, with lower <= l <= upper.
struct ForceBalance {
  std::vector<int> row;  ///< of the program, per column
  MatrixXd A;
  VectorXd r;
  VectorXd lower, upper, weight;
};

/// Multipliers of rows that are not tight are put into `fixed`; the others are unknown.
ForceBalance force_balance(const QuadraticProgram& p,
                           const std::vector<double>& x,
                           std::span<const double> weight,
                           double tight,
                           std::vector<double>& fixed) {
  ResidualMeter meter;
  const ResidualScales& scales = meter.measure_scales(p);
  ForceBalance balance;
  balance.r.resize(p.unknowns());
  for (Index j = 0; j < balance.r.size(); ++j)
    balance.r[j] = p.mass[j] * (x[j] - p.target[j]);
  for (int row = 0; row < p.rows(); ++row) {
    const double slack = p.slack(row, x);
    if (p.is_equality(row)
        || std::abs(slack) <= tight * scales.row_norm[row] * scales.acceleration) {
      balance.row.push_back(row);
      continue;
    }
    const double force = slack > 0.0 ? p.force_min[row] : p.force_max[row];
    fixed[row] = std::isfinite(force) ? force : 0.0;
    p.add_row_force(row, -fixed[row], balance.r);
  }
  const auto columns = static_cast<Index>(balance.row.size());
  balance.A = MatrixXd::Zero(p.unknowns(), columns);
  balance.lower.resize(columns);
  balance.upper.resize(columns);
  balance.weight = VectorXd::Ones(columns);
  for (Index k = 0; k < columns; ++k) {
    const int row = balance.row[k];
    p.add_row_force(row, 1.0, balance.A.col(k));
    balance.lower[k] = p.force_min[row];
    balance.upper[k] = p.force_max[row];
    if (!weight.empty()) balance.weight[k] = weight[row];
  }
  // Coordinates of a block are made alike by the roots of their masses, as in QpResidual. The
  // masses of different blocks do not matter for the balance and would spoil its rank; nor may rows
  // be brought to unit length, which would weigh a moment equation whose lever is rounding as much
  // as the balance of forces.
  for (Index j = 0; j < balance.r.size(); ++j) {
    const double unit = std::sqrt(p.mass[j - j % p.block_size] / p.mass[j]);
    balance.r[j] *= unit;
    if (balance.A.cols() > 0) balance.A.row(j) *= unit;
  }
  return balance;
}

/// Solutions of A l = r: one that is orthogonal to all directions in which l may change, and those
/// directions.
struct SolutionSet {
  VectorXd particular;
  MatrixXd directions;  ///< orthonormal columns; one of zeros where there are none
};

SolutionSet solution_set(const MatrixXd& A, const VectorXd& r, double rank_tolerance) {
  if (A.cols() == 0) return {VectorXd(0), MatrixXd(0, 0)};
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeFullV);
  const VectorXd& sigma = svd.singularValues();
  Index rank = 0;
  while (rank < sigma.size() && sigma[rank] > rank_tolerance * sigma[0])
    ++rank;
  const VectorXd part =
      (svd.matrixU().leftCols(rank).transpose() * r).cwiseQuotient(sigma.head(rank));
  SolutionSet set{svd.matrixV().leftCols(rank) * part, svd.matrixV().rightCols(A.cols() - rank)};
  // A matrix without columns has no memory of which Eigen could take rows.
  if (rank == A.cols()) set.directions = MatrixXd::Zero(A.cols(), 1);
  // One step of refinement.
  const VectorXd rest = r - A * set.particular;
  set.particular +=
      svd.matrixV().leftCols(rank)
      * (svd.matrixU().leftCols(rank).transpose() * rest).cwiseQuotient(sigma.head(rank));
  return set;
}

/// One inequality a' w >= c on the coordinates w of the directions, and the column it comes from.
struct HalfSpaces {
  MatrixXd a;  ///< one per row
  VectorXd c;
  std::vector<Index> column;
};

/// The bounds of l = particular + directions w.
HalfSpaces half_spaces(const SolutionSet& set, const VectorXd& lower, const VectorXd& upper) {
  HalfSpaces h;
  const Index n = set.particular.size();
  const Index k = set.directions.cols();
  h.a.resize(2 * n, k);
  h.c.resize(2 * n);
  Index count = 0;
  for (Index i = 0; i < n; ++i) {
    if (std::isfinite(lower[i])) {
      h.a.row(count) = set.directions.row(i);
      h.c[count++] = lower[i] - set.particular[i];
      h.column.push_back(i);
    }
    if (std::isfinite(upper[i])) {
      h.a.row(count) = -set.directions.row(i);
      h.c[count++] = set.particular[i] - upper[i];
      h.column.push_back(i);
    }
  }
  h.a.conservativeResize(count, k);
  h.c.conservativeResize(count);
  return h;
}

/// min |w| subject to a w >= c: least distance programming, Lawson and Hanson (1974), chapter 23,
/// section 4.
VectorXd least_distance(const HalfSpaces& h, double scale) {
  const Index k = h.a.cols();
  if (h.a.rows() == 0 || k == 0 || h.c.maxCoeff() <= 0.0) return VectorXd::Zero(k);
  MatrixXd E(k + 1, h.a.rows());
  E.topRows(k) = h.a.transpose();
  E.row(k) = h.c.transpose() / scale;
  VectorXd f = VectorXd::Zero(k + 1);
  f[k] = 1.0;
  const VectorXd u = non_negative_least_squares(E, f);
  // The rows with u > 0 hold with equality: solve for them directly, which is more exact than the
  // formula with the residual.
  std::vector<Index> active;
  for (Index i = 0; i < u.size(); ++i)
    if (u[i] > 0.0) active.push_back(i);
  const MatrixXd a = h.a(active, Eigen::all);
  const VectorXd c = h.c(active);
  const VectorXd w = a.completeOrthogonalDecomposition().solve(c);
  // Where x is not optimal the half spaces may have nothing in common; then the bounds are missed
  // by least squares elsewhere.
  const bool found = w.allFinite() && (h.a * w - h.c).minCoeff() >= -1e-6 * scale;
  return found ? w : VectorXd::Zero(k);
}

constexpr double small = 1e-8;

std::vector<Index> at_bound(const HalfSpaces& h, const VectorXd& w, double near) {
  std::vector<Index> found;
  for (Index i = 0; i < h.a.rows(); ++i)
    if (h.a.row(i) * w - h.c[i] <= near && h.a.row(i).norm() > small) found.push_back(i);
  return found;
}

/// Those of the directions of a set along which none of the half spaces that are held is left.
MatrixXd free_directions(const SolutionSet& set,
                         const HalfSpaces& h,
                         const std::vector<Index>& held) {
  if (held.empty() || set.directions.cols() == 0) return set.directions;
  const MatrixXd a = h.a(held, Eigen::all);
  const Eigen::JacobiSVD<MatrixXd> svd(a, Eigen::ComputeFullV);
  const Index rank = (svd.singularValues().array() > small * svd.singularValues()[0]).count();
  return set.directions * svd.matrixV().rightCols(set.directions.cols() - rank);
}

/// Whether l_i is the same over all solutions. From a solution, rows at a bound are either held
/// there by the others (a non-negative combination of them vanishes) or some direction lets them
/// leave; NNLS finds one or the other. What remains free spans all possible changes.
std::vector<bool> find_unique(const ForceBalance& balance,
                              const VectorXd& l,
                              double rank_tolerance) {
  const SolutionSet set = solution_set(balance.A, balance.r, rank_tolerance);
  const HalfSpaces h = half_spaces(set, balance.lower, balance.upper);
  const VectorXd w = set.directions.transpose() * (l - set.particular);
  const double scale = l.size() > 0 ? l.cwiseAbs().maxCoeff() : 0.0;
  std::vector<Index> open = at_bound(h, w, small * scale);  // not yet decided
  std::vector<Index> held;
  while (!open.empty()) {
    const MatrixXd all = h.a(open, Eigen::all).transpose();
    const Index last = all.cols() - 1;
    const VectorXd u = non_negative_least_squares(all.leftCols(last), -all.col(last));
    const VectorXd way = all.leftCols(last) * u + all.col(last);
    std::vector<Index> rest;
    const bool blocked = way.norm() <= small * all.col(last).norm();
    for (Index k = 0; k <= last; ++k) {
      const bool decided =
          k == last || (blocked ? u[k] > small : all.col(k).dot(way) > small * way.norm());
      if (!decided) rest.push_back(open[k]);
      if (decided && blocked) held.push_back(open[k]);
    }
    open = rest;
  }
  const MatrixXd free = free_directions(set, h, held);
  std::vector<bool> unique(set.particular.size());
  for (Index i = 0; i < set.particular.size(); ++i)
    unique[i] = free.cols() == 0 || free.row(i).norm() <= small;
  return unique;
}

/// A weighted problem in l_i = weight_i lambda_i; columns of weight 0 (equalities) are projected
/// out of the balance.
struct Weighted {
  std::vector<Index> counted, idle;
  MatrixXd A;  ///< counted columns
  VectorXd r, lower, upper;
};

Weighted weighted(const ForceBalance& balance) {
  Weighted w;
  for (Index k = 0; k < balance.A.cols(); ++k)
    (balance.weight[k] > 0.0 ? w.counted : w.idle).push_back(k);
  const VectorXd inverse = balance.weight(w.counted).cwiseInverse();
  w.A = MatrixXd(balance.A(Eigen::all, w.counted)) * inverse.asDiagonal();
  w.r = balance.r;
  w.lower = VectorXd(balance.lower(w.counted)).cwiseQuotient(inverse);
  w.upper = VectorXd(balance.upper(w.counted)).cwiseQuotient(inverse);
  if (w.idle.empty()) return w;
  const Eigen::JacobiSVD<MatrixXd> svd(MatrixXd(balance.A(Eigen::all, w.idle)),
                                       Eigen::ComputeFullU);
  const Index rank = (svd.singularValues().array() > 1e-10 * svd.singularValues()[0]).count();
  const MatrixXd rest = svd.matrixU().rightCols(svd.matrixU().cols() - rank).transpose();
  w.A = MatrixXd(rest * w.A);
  w.r = VectorXd(rest * w.r);
  return w;
}

}  // namespace

LeastNormMultipliers least_norm_multipliers(const QuadraticProgram& program,
                                            const std::vector<double>& x,
                                            std::span<const double> weight,
                                            const LeastNormSettings& settings) {
  LeastNormMultipliers result;
  result.multiplier.assign(program.bound.size(), 0.0);
  result.unique.assign(program.bound.size(), true);
  const ForceBalance balance = force_balance(program, x, weight, settings.tight, result.multiplier);
  const Weighted counted = weighted(balance);

  const SolutionSet set = solution_set(counted.A, counted.r, settings.rank);
  const HalfSpaces half = half_spaces(set, counted.lower, counted.upper);
  const double scale =
      set.particular.size() > 0 ? std::max(set.particular.cwiseAbs().maxCoeff(), 1e-300) : 1.0;
  const VectorXd w = least_distance(half, scale);

  VectorXd lambda = VectorXd::Zero(balance.A.cols());
  for (std::size_t k = 0; k < counted.counted.size(); ++k) {
    const Index column = counted.counted[k];
    const double l =
        set.particular[static_cast<Index>(k)] + set.directions.row(static_cast<Index>(k)).dot(w);
    lambda[column] =
        std::clamp(l / balance.weight[column], balance.lower[column], balance.upper[column]);
  }
  if (!counted.idle.empty()) {
    const MatrixXd A_idle = balance.A(Eigen::all, counted.idle);
    const SolutionSet idle = solution_set(A_idle, balance.r - balance.A * lambda, settings.rank);
    for (std::size_t k = 0; k < counted.idle.size(); ++k)
      lambda[counted.idle[k]] = idle.particular[static_cast<Index>(k)];
  }
  const std::vector<bool> unique = find_unique(balance, lambda, settings.rank);
  for (std::size_t k = 0; k < balance.row.size(); ++k)
    result.unique[balance.row[k]] = unique[k];
  for (std::size_t k = 0; k < balance.row.size(); ++k)
    result.multiplier[balance.row[k]] = lambda[static_cast<Index>(k)];
  const double force = balance.r.size() > 0 ? balance.r.cwiseAbs().maxCoeff() : 0.0;
  if (force > 0.0) result.misfit = (balance.r - balance.A * lambda).cwiseAbs().maxCoeff() / force;
  return result;
}

}  // namespace wuerfel::test
