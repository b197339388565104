/// State and forces -> Snapshot: what the renderer may know.
#pragma once

#include <span>

#include "core/dynamics/forces_at.h"
#include "core/snapshot.h"
#include "core/statics/ranges.h"

namespace wuerfel {

/// How much of an instant a snapshot needs.
Detail detail_of(const SnapshotRequest& request);

/// `found` is what was found about `state`, to that detail; `ranges` of each of its islands, or none.
Snapshot take_snapshot(const Scene& scene,
                       const System& system,
                       const State& state,
                       const InstantForces& found,
                       std::span<const ForceRanges> ranges,
                       const SnapshotRequest& request);

}  // namespace wuerfel
