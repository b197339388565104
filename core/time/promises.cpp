#include "core/time/promises.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {

std::vector<Promise> broken_promises(const Audit& audit) {
  std::vector<Promise> broken;
  const auto check = [&](bool kept, Promise promise) {
    if (!kept) broken.push_back(promise);
  };
  check(audit.missed_solves == 0, Promise::programs);
  check(audit.rods_contradicting == 0 && audit.max_rod_error <= promised_rod_error, Promise::rods);
  check(audit.unresolved == 0, Promise::events);
  check(audit.friction_residual <= promised_friction, Promise::friction);
  check(audit.max_overlap <= promised_overlap, Promise::overlap);
  check(audit.drift_budget <= 0.0 || std::abs(audit.drift()) <= audit.drift_budget,
        Promise::energy);
  const double unexplained = std::max(audit.momentum_linear, audit.momentum_angular);
  check(audit.momentum_budget <= 0.0
            || (unexplained <= audit.momentum_budget
                && audit.momentum_settled <= audit.settled_budget),
        Promise::momentum);
  return broken;
}

void note_breaches(const Audit& before,
                   double t,
                   std::span<const std::string> bodies,
                   Bookkeeping& book) {
  const std::vector<Promise> known = broken_promises(before);
  for (const Promise promise : broken_promises(book.audit)) {
    if (std::ranges::find(known, promise) == known.end())
      book.breaches.push_back({promise, t, {bodies.begin(), bodies.end()}});
  }
}

const Breach* first_breach(const std::vector<Breach>& breaches, Promise promise) {
  const Breach* first = nullptr;
  for (const Breach& breach : breaches) {
    if (breach.promise == promise && (first == nullptr || breach.t < first->t)) first = &breach;
  }
  return first;
}

}  // namespace wuerfel
