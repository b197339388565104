#include "core/time/bookkeeping.h"

#include <algorithm>

#include "core/dynamics/gauss.h"

namespace wuerfel {

std::string_view to_string(EventKind kind) {
  switch (kind) {
    case EventKind::impact:
      return "impact";
    case EventKind::touch:
      return "touch";
    case EventKind::release:
      return "release";
    case EventKind::slide_off:
      return "slide_off";
    case EventKind::stick:
      return "stick";
    case EventKind::slip:
      return "slip";
    case EventKind::rest:
      return "rest";
  }
  return "?";
}

void note_overlap(double depth, double side, Audit& audit) {
  audit.max_penetration = std::max(audit.max_penetration, depth);
  audit.max_overlap = std::max(audit.max_overlap, depth / side);
}

void keep_book(const IslandSolution& solution, Bookkeeping& book) {
  ++(solution.skipped ? book.cost.skipped_certificate : book.cost.qp_solves);
  book.cost.qp_iterations += solution.iterations;
  // That there is no solution is an answer.
  if (solution.status == QpStatus::infeasible) {
    ++book.audit.wedged;
    return;
  }
  const bool answered =
      solution.status == QpStatus::optimal || solution.status == QpStatus::inaccurate;
  const double residual = answered ? solution.residual : unbounded;
  book.audit.max_kkt_residual = std::max(book.audit.max_kkt_residual, residual);
  if (solution.status != QpStatus::optimal) ++book.audit.missed_solves;
}

}  // namespace wuerfel
