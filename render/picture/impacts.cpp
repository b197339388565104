#include "render/picture/impacts.h"

#include <algorithm>
#include <cmath>

#include "render/picture/force_scale.h"
#include "render/picture/frame_options.h"

namespace wuerfel {
namespace {

constexpr double least_impact = 0.05;   ///< of a typical impulse, that has a ring
constexpr double least_of_crowd = 1.0;  ///< likewise: more rings than bodies hide them
constexpr double faded = 0.8;           ///< the age from which a ring is hardly there

}  // namespace

RingScale ring_scale(const Snapshot& snapshot) {
  double mass = 0.0;
  double side = 0.0;
  int count = 0;
  for (const SnapshotBox& box : snapshot.boxes) {
    if (box.fixed) continue;
    mass += box.mass;
    side += typical_side_of(box);
    ++count;
  }
  const double gravity = snapshot.gravity.norm();
  const double typical = count == 0 ? 0.0 : mass / count * std::sqrt(2.0 * gravity * side / count);
  return {typical, is_crowd(snapshot) ? least_of_crowd : least_impact};
}

bool shows_impacts(const Snapshot& snapshot) {
  if (snapshot.impacts.empty()) return false;
  const RingScale scale = ring_scale(snapshot);
  return std::ranges::any_of(snapshot.impacts, [&](const SnapshotImpact& impact) {
    return impact.age < faded && scale.has_ring(impact);
  });
}

}  // namespace wuerfel
