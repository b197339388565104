/// State and forces -> Snapshot: what the renderer may know.
#pragma once

#include "core/snapshot.h"
#include "core/time/moment.h"
#include "core/time/simulation.h"

namespace wuerfel {

/// `moment` must have its accelerations where forces are asked for.
Snapshot take_snapshot(const Scene& scene,
                       const System& system,
                       const Moment& moment,
                       const SnapshotRequest& request);

}  // namespace wuerfel
