/// A quadratic program as Ipopt likes it: unknowns and rows of like size, no dependent equalities,
/// bounded forces by elastic unknowns.
#pragma once

#include <vector>

#include "core/qp/ipopt/independent_rows.h"
#include "core/qp/ipopt/ipopt_module.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

/// The program in the unknowns y = M^(1/2) (x - f) / size, with rows of unit length:
///
///     minimise 1/2 |y|^2  subject to  g y >= h,  g = J M^(-1/2) / norm,  h = (b - J f) / (norm
///     size)
///
/// A multiplier of J is the one of g times size / norm. A row whose force is bounded may be missed
/// at the price of the bound: elastic unknowns p, q >= 0 with g y + p - q >= h.
struct ScaledProgram {
  std::vector<SparseRow> g;
  std::vector<double> h;
  std::vector<double> norm;
  double size = 1.0;
};

ScaledProgram scaled(const QuadraticProgram& p);

/// Owns what an IpoptProgram points to. `scaled` must outlive it.
class ElasticForm {
 public:
  ElasticForm(const QuadraticProgram& program, const ScaledProgram& scaled);
  void solve(IpoptSession& session, IpoptBarrier barrier);
  /// Point, multipliers and iterations of the last solve.
  void read(const QuadraticProgram& program, QpResult& result) const;
  /// Whether Ipopt saw no feasible point, or a row that was left out contradicts those that hold.
  [[nodiscard]] bool infeasible(const QuadraticProgram& program) const;

 private:
  [[nodiscard]] std::vector<bool> rows_to_keep(const QuadraticProgram& program);
  void add_row(int row, double force_min, double force_max);
  void add_elastic(int place, double sign, double cost);
  void add_entry(int place, int column, double value);

  const ScaledProgram& scaled_;
  IpoptPoint point_;
  int unknowns_ = 0;
  std::vector<int> source_, row_, column_;
  std::vector<double> cost_, lower_, upper_, value_, y_, multiplier_;
};

}  // namespace wuerfel
