/// Whether what is at rest can stay there: the convex program from rest.
///
///     minimise 1/2 (a - f)' M (a - f)   subject to   J_n a >= mu |J_t a|  at every contact
///
/// has the minimiser a = 0 if and only if -M f = J' lambda for some |lambda_t| <= mu lambda_n, that
/// is, if an equilibrium exists: the cone of friction is the dual cone of the two rows. If a is not
/// zero it is the certificate of Farkas: any admissible forces have power (J a)' lambda >= 0 along
/// it, and the weight has f' M a = a' M a > 0, so that they cannot balance. [Farkas 1902]
#pragma once

#include <vector>

#include "core/qp/coulomb/convex_relaxation.h"

namespace wuerfel {

struct RestResult {
  QpStatus status = QpStatus::invalid;  ///< of the convex program
  /// The minimiser, n; of size zero up to rounding where an equilibrium exists, else the motion that
  /// proves that there is none. It is not the motion that follows.
  std::vector<double> acceleration;
  std::vector<double> multiplier;  ///< m; the forces of the equilibrium
  double size =
      0.0;  ///< the largest acceleration, as a share of the largest |f|; 0: forces balance
  [[nodiscard]] bool equilibrium() const { return status == QpStatus::optimal && size <= 1e-10; }
};

class RestProgram {
 public:
  /// `friction` at acceleration level, everything at rest: bounds are not looked at. What is known to slip is held by the edge
  /// against its slip. Rods and rows without friction take part.
  RestResult solve(const FrictionProgram& friction);

 private:
  RestResult solve_convex(const FrictionProgram& friction);

  ConvexRelaxation convex_{1e-12};
  QuadraticProgram program_;
};

}  // namespace wuerfel
