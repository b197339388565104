/// Corner forces -> one resultant for each pair of bodies that touch.
#pragma once

#include <vector>

#include "core/dynamics/forces_at.h"
#include "core/snapshot.h"
#include "core/statics/ranges.h"

namespace wuerfel {

/// Whether the force that is shown of a contact acts on the body of the corner: shown is the force
/// that carries, on the upper body of the two, and on a cube where one is fixed.
bool is_carried(const System& system, const Contact& contact);

/// Number of a body in Snapshot::boxes, planes after them; -1 of a point.
int box_of(const System& system, int body);

/// Adds the joints of an island that press; `ranges` may be empty.
void add_joints(const System& system,
                const IslandForces& of,
                const ForceRanges& ranges,
                std::vector<SnapshotJoint>& joints);

}  // namespace wuerfel
