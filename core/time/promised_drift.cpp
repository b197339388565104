#include "core/time/promised_drift.h"

#include <algorithm>

#include "core/dynamics/rod_rows.h"
#include "core/geometry/bounds.h"

namespace wuerfel {
namespace {

/// What the tolerance promises of energy, per L / V: times that of all that moves or hangs.
constexpr double drift_share = 10.0;
/// What steps may leave unexplained of the energy that moved, or was lost.
constexpr double stepped_drift_share = 1e-4;

/// How far bodies fall before something stops them, as a scale, m: L, or, where rods hold them, how far these reach.
double free_fall(const System& system, const State& start, const Scales& scales) {
  if (system.rods.empty()) return scales.length;
  BoundingBox bounds{start.front().position, start.front().position};
  const auto include = [&](const Vec2& p) { bounds.include({p, p}); };
  for (const BodyState& s : start)
    include(s.position);
  for (const Rod& rod : system.rods) {
    include(held_place(rod.i, start).p);
    include(held_place(rod.j, start).p);
  }
  return std::max(scales.length, (bounds.high - bounds.low).norm());
}

}  // namespace

PromisedDrift::PromisedDrift(const System& system,
                             const State& start,
                             const Scales& scales,
                             double tolerance)
    : in_motion_(kinetic_energy(system, start) + scales.weight * free_fall(system, start, scales)),
      per_time_(drift_share * tolerance * in_motion_),
      time_(scales.time) {}

double PromisedDrift::of_events(double t) const { return per_time_ * (1.0 + t / time_); }

double PromisedDrift::of_steps(double lost) const {
  return stepped_drift_share * (in_motion_ + lost);
}

}  // namespace wuerfel
