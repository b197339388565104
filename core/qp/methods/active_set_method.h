/// The short way to a solution where the tight rows are nearly known: solve with them as
/// equalities, let go of rows that pull, take hold of rows that are violated, and accept only what
/// passes the optimality test. A primal-dual active set method
/// [Hintermüller, Ito, Kunisch 2002] that gives up early: what it cannot do in a few rounds is left
/// to a solver.
#pragma once

#include <vector>

#include "core/qp/methods/equality_solver.h"
#include "core/qp/qp_solver.h"
#include "core/qp/residual_meter.h"

namespace wuerfel {

class ActiveSetMethod {
 public:
  /// `tight` (size m) is the guess, and afterwards the set that was reached. True where `result` is
  /// optimal to `tolerance` (QpResidual::worst()); otherwise `result` is worthless. Programs with
  /// bounded rows are not tried.
  bool solve(const QuadraticProgram& program,
             double tolerance,
             std::vector<char>& tight,
             QpResult& result);

  /// Moves a solution onto the rows that carry force, measured by those on the bodies they join, so
  /// that light bodies beside heavy ones are as exact as their own forces. Keeps the better of the two:
  /// judged by QpResidual and body by body (ResidualMeter::imbalance).
  void refine(const QuadraticProgram& program, QpResult& result);

 private:
  [[nodiscard]] static bool revise(const QuadraticProgram& program,
                                   std::vector<char>& tight,
                                   QpResult& result);

  EqualitySolver solver_;
  ResidualMeter meter_;
  QpResult refined_;
  std::vector<char> loaded_;
};

}  // namespace wuerfel
