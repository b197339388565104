#include "core/time/events/solves.h"

#include <algorithm>

namespace wuerfel {

void Solves::add(const IslandSolution& solution) {
  ++(solution.skipped ? skipped : solved);
  if (solution.status == QpStatus::infeasible) {
    ++infeasible;
    return;
  }
  residual = std::max(residual, solution.residual);
  if (solution.status != QpStatus::optimal) ++missed;
}

void keep_book(const Solves& solves, Bookkeeping& book) {
  book.cost.qp_solves += solves.solved;
  book.cost.skipped_certificate += solves.skipped;
  book.audit.missed_solves += solves.missed;
  book.audit.wedged += solves.infeasible;
  book.audit.max_kkt_residual = std::max(book.audit.max_kkt_residual, solves.residual);
}

}  // namespace wuerfel
