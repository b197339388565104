/// Free-body diagrams: bodies apart from one another, and at each face both forces of the pair.
#pragma once

#include "core/snapshot.h"

namespace wuerfel {

/// All places spread about the foot of the scene by the factor 1 + `share`; bodies keep their sizes.
/// Instead of joints there are forces, each on the body that it points into, at the face by which it
/// acts: SnapshotForce without a joint.
Snapshot exploded(const Snapshot& snapshot, double share);

}  // namespace wuerfel
