#include "core/time/events/solves.h"

#include <algorithm>

namespace wuerfel {

void Solves::add(const IslandSolution& solution) {
  ++(solution.skipped ? skipped : solved);
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
  residual = std::max(residual, solution.residual);
  if (solution.status != QpStatus::optimal) ++missed;
}

void keep_book(const Solves& solves, Bookkeeping& book) {
  book.cost.qp_solves += solves.solved;
  book.cost.skipped_certificate += solves.skipped;
  book.audit.missed_solves += solves.missed;
  book.audit.wedged += solves.infeasible;
  book.audit.friction_inexact += solves.friction_inexact;
  book.audit.friction_residual = std::max(book.audit.friction_residual, solves.friction_residual);
  book.audit.restitution_reduced += solves.restitution_reduced;
  book.audit.max_kkt_residual = std::max(book.audit.max_kkt_residual, solves.residual);
}

}  // namespace wuerfel
