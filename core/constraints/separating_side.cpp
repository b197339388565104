// Which side keeps two boxes apart over a way that they go.
#include <algorithm>
#include <limits>

#include "core/constraints/manifold.h"

namespace wuerfel {
namespace {

void take_larger(const FacingSide& side, FacingSide& largest) {
  if (side.separation > largest.separation) largest = side;
}

/// The share of a way at which a gap closes; -1 where it does not.
double closing_time(double before, double after) {
  const double open = std::max(before, 0.0);
  return after < 0.0 ? open / (open - after) : -1.0;
}

}  // namespace

FacingSide separating_side(const System& system, const Way& way, double slow, int i, int j) {
  // What has closed by rounding at the start has not closed yet.
  const double zero =
      touching_tolerance * std::min(way.start[i].smaller_side(), way.start[j].smaller_side());
  constexpr double none = -std::numeric_limits<double>::infinity();
  FacingSide best{i, j, 0, none};
  FacingSide deepest = best;
  FacingSide carried = best;
  FacingSide meeting;
  double latest = -1.0;
  const bool covers = system.body(i).cover || system.body(j).cover;
  const SideSeparations start = side_separations(way.start[i], way.start[j]);
  const SideSeparations end = side_separations(way.end[i], way.end[j]);
  const SideSeparations drift = side_separations(way.drift[i], way.drift[j]);
  const auto look_at = [&](int from, int on, int side) {
    if (covers && is_covered(system, deepest_corner_at(way.end, from, on, side))) return;
    const int k = from == i ? side : side + Box::corners;
    const double before = start[k];
    const double after = end[k];
    take_larger({from, on, side, std::min(before, after)}, best);
    take_larger({from, on, side, before}, deepest);
    if (before < -zero) return;
    take_larger({from, on, side, std::min(before, drift[k])}, carried);
    const double when = closing_time(before, after);
    if (when <= latest) return;
    latest = when;
    meeting = {from, on, side, after};
  };
  for (const auto& [from, on] : {IndexPair{i, j}, IndexPair{j, i}}) {
    for (int side = 0; side < Box::corners; ++side)
      look_at(from, on, side);
  }
  if (best.separation >= 0.0) return best;
  if (carried.separation >= -slow) {
    carried.separation = end[carried.from == i ? carried.side : carried.side + Box::corners];
    return carried;
  }
  if (latest >= 0.0) return meeting;
  return {deepest.from, deepest.on, deepest.side, best.separation};
}

}  // namespace wuerfel
