/// Causes and mechanisms -> Snapshot.
#pragma once

#include <span>
#include <vector>

#include "core/constraints/contact.h"
#include "core/snapshot.h"
#include "core/statics/causes.h"

namespace wuerfel {

/// The bodies of an instant held still where they are. `loaded` as with ForceFinder.
StillScene held_still(const System& system,
                      const MotionSettings& settings,
                      const State& state,
                      std::span<const Contact> loaded);

SnapshotCause shown_cause(const StillScene& still, const Cause& cause);

/// Of each island that falls the first of its causes. What touches nothing is seen to fly.
std::vector<SnapshotCause> shown_causes(const StillScene& still, const Causes& causes);

/// Both as far as the request asks for them.
void add_causes(const StillScene& still, const SnapshotRequest& request, Snapshot& snapshot);

/// The certificate's motion of the cubes that touch something and have a part in it.
std::vector<SnapshotMotion> shown_motion(const StillScene& still, const Certificate& certificate);

}  // namespace wuerfel
