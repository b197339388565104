/// Which blows have a ring, and how large.
#pragma once

#include "core/snapshot.h"

namespace wuerfel {

/// Of the blows of one picture.
struct RingScale {
  double typical =
      0.0;             ///< N s, of a cube that falls from the height of one side; 0 without gravity
  double least = 0.0;  ///< of it, that has a ring

  [[nodiscard]] double share(const SnapshotImpact& impact) const {
    return typical > 0.0 ? impact.impulse / typical : 1.0;
  }
  [[nodiscard]] bool has_ring(const SnapshotImpact& impact) const { return share(impact) >= least; }
};
RingScale ring_scale(const Snapshot& snapshot);

/// Whether a picture has a ring that has not faded so far that one would look for it in vain.
bool shows_impacts(const Snapshot& snapshot);

}  // namespace wuerfel
