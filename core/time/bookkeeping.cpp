#include "core/time/bookkeeping.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/momentum_balance.h"
#include "core/dynamics/solves.h"

namespace wuerfel {
namespace {

void add_audit(const Audit& more, Audit& audit) {
  audit.max_penetration = std::max(audit.max_penetration, more.max_penetration);
  audit.max_overlap = std::max(audit.max_overlap, more.max_overlap);
  audit.max_rod_error = std::max(audit.max_rod_error, more.max_rod_error);
  audit.max_kkt_residual = std::max(audit.max_kkt_residual, more.max_kkt_residual);
  audit.missed_solves += more.missed_solves;
  audit.unresolved += more.unresolved;
  audit.searches_given_up += more.searches_given_up;
  audit.wedged += more.wedged;
  audit.rods_contradicting += more.rods_contradicting;
  audit.friction_inexact += more.friction_inexact;
  audit.friction_residual = std::max(audit.friction_residual, more.friction_residual);
  audit.restitution_reduced += more.restitution_reduced;
}

}  // namespace

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
    case EventKind::jam:
      return "jam";
    case EventKind::rest:
      return "rest";
  }
  return "?";
}

std::string_view to_string(Promise promise) {
  switch (promise) {
    case Promise::programs:
      return "programs";
    case Promise::events:
      return "events";
    case Promise::friction:
      return "friction";
    case Promise::overlap:
      return "overlap";
    case Promise::energy:
      return "energy";
    case Promise::momentum:
      return "momentum";
    case Promise::rods:
      return "rods";
  }
  return "?";
}

void note_overlap(double depth, double side, Audit& audit) {
  audit.max_penetration = std::max(audit.max_penetration, depth);
  audit.max_overlap = std::max(audit.max_overlap, depth / side);
}

Cost sum_of(const Cost& a, const Cost& b) {
  return {a.steps + b.steps,
          a.qp_solves + b.qp_solves,
          a.qp_iterations + b.qp_iterations,
          a.hand_overs + b.hand_overs,
          a.skipped_free + b.skipped_free,
          a.skipped_rest + b.skipped_rest,
          a.skipped_certificate + b.skipped_certificate};
}

void add(const Bookkeeping& more, Bookkeeping& book) {
  book.events.insert(book.events.end(), more.events.begin(), more.events.end());
  book.losses.insert(book.losses.end(), more.losses.begin(), more.losses.end());
  add_audit(more.audit, book.audit);
  book.cost = sum_of(book.cost, more.cost);
  book.breaches.insert(book.breaches.end(), more.breaches.begin(), more.breaches.end());
  book.settled += more.settled;
  book.unexplained += more.unexplained;
}

void sort_by_time(std::size_t events, std::size_t losses, Bookkeeping& book) {
  const auto sort_from = [](auto& list, std::size_t known) {
    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(known);
    std::ranges::stable_sort(begin, list.end(), {}, [](const auto& entry) { return entry.t; });
  };
  sort_from(book.events, events);
  sort_from(book.losses, losses);
}

void note_unexplained(const MomentumScale& scale, Bookkeeping& book) {
  const Push& sum = book.unexplained;
  Audit& audit = book.audit;
  audit.momentum_linear = std::max(audit.momentum_linear, sum.linear.norm() / scale.linear);
  audit.momentum_settled =
      std::max(audit.momentum_settled, book.settled.linear.norm() / scale.linear);
  // A point mass alone has no momentum about itself.
  if (scale.angular > 0.0) {
    audit.momentum_angular =
        std::max(audit.momentum_angular, std::abs(sum.angular) / scale.angular);
  }
}

void keep_cost(const Solves& solves, Bookkeeping& book) {
  book.cost.qp_solves += solves.solved;
  book.cost.qp_iterations += solves.iterations;
  book.cost.skipped_certificate += solves.skipped;
}

void keep_book(const Solves& solves, Bookkeeping& book) {
  keep_cost(solves, book);
  book.audit.missed_solves += solves.missed;
  book.audit.wedged += solves.infeasible;
  book.audit.friction_inexact += solves.friction_inexact;
  book.audit.friction_residual = std::max(book.audit.friction_residual, solves.friction_residual);
  book.audit.restitution_reduced += solves.restitution_reduced;
  book.audit.max_kkt_residual = std::max(book.audit.max_kkt_residual, solves.residual);
}

void keep_book(const IslandSolution& solution, Bookkeeping& book) {
  Solves solves;
  solves.add(solution);
  keep_book(solves, book);
}

}  // namespace wuerfel
