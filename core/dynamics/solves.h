/// Programs that were solved on the way to an answer, for whoever keeps book.
#pragma once

#include "core/dynamics/gauss.h"

namespace wuerfel {

struct Solves {
  long solved = 0;
  long skipped = 0;                ///< former answers that still passed
  long iterations = 0;             ///< of the solvers
  long missed = 0;                 ///< whose residual missed the tolerance
  long infeasible = 0;             ///< that have no solution, which is an answer
  double residual = 0.0;           ///< the worst
  long friction_inexact = 0;       ///< programs in which Coulomb's law was missed
  double friction_residual = 0.0;  ///< the worst of these
  long restitution_reduced = 0;    ///< impacts whose coefficients had to be scaled back

  /// A program whose answer is used as it is.
  void add(const IslandSolution& solution);
  /// One whose answer is not used, or is judged by what it leads to: what it cost.
  void count(const IslandSolution& solution);
  /// What others cost.
  void count(const Solves& others);
};

}  // namespace wuerfel
