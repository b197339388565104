#include "core/dynamics/solves.h"

#include <algorithm>

namespace wuerfel {

void Solves::count(const IslandSolution& solution) {
  ++(solution.skipped ? skipped : solved);
  iterations += solution.iterations;
}

void Solves::count(const Solves& others) {
  solved += others.solved;
  skipped += others.skipped;
  iterations += others.iterations;
}

void Solves::add(const IslandSolution& solution) {
  count(solution);
  if (solution.status == QpStatus::infeasible) {
    ++infeasible;
    return;
  }
  if (solution.friction_inexact) {
    ++friction_inexact;
    friction_residual = std::max(friction_residual, solution.residual);
    return;
  }
  if (solution.restitution_factor < 1.0) ++restitution_reduced;
  const bool answered =
      solution.status == QpStatus::optimal || solution.status == QpStatus::inaccurate;
  residual = std::max(residual, answered ? solution.residual : unbounded);
  if (solution.status != QpStatus::optimal) ++missed;
}

}  // namespace wuerfel
