/// The convex relaxation of Coulomb's law: rows J_n +- mu J_t >= b_n +- mu b_t in the place of each
/// contact's two. It lifts what slides by mu |u_t| and is exact where nothing loaded slides.
#pragma once

#include <memory>
#include <vector>

#include "core/qp/coulomb/friction_program.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

class ConvexRelaxation {
 public:
  explicit ConvexRelaxation(double tolerance);
  /// Of contacts whose direction of slip is known only the edge against it is there. The status is that of the convex program.
  QpStatus solve(const FrictionProgram& friction);
  void forget() { solver_->forget(); }

  [[nodiscard]] const std::vector<double>& x() const { return result_.x; }
  /// Of the rows of the friction program.
  [[nodiscard]] const std::vector<double>& multiplier() const { return multiplier_; }
  [[nodiscard]] int iterations() const { return result_.iterations; }

 private:
  void build(const FrictionProgram& friction);
  void add_row(const QuadraticProgram& p, int row, double factor);
  void add_edges(const QuadraticProgram& p, const FrictionContact& contact);
  void read(const FrictionProgram& friction);

  std::unique_ptr<QpSolver> solver_;
  QuadraticProgram convex_;
  QpResult result_;
  std::vector<double> multiplier_;
  std::vector<int> single_;  ///< rows of the friction program that stay as they are, then the edges
  std::vector<double> coefficients_;
  std::vector<int> block_;
};

}  // namespace wuerfel
