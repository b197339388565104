/// Where a motion begins.
#pragma once

#include <functional>
#include <vector>

#include "core/model/system.h"
#include "core/scene/scene.h"

namespace wuerfel {

/// Throws SceneError where rods contradict each other at a state whose velocities satisfy them, or a moment after what
/// is at rest there begins to move. `accelerations` (one per cube) are asked for only where rods depend on one another.
void require_consistent_rods(const System& system,
                             const State& state,
                             const std::function<std::vector<Twist>()>& accelerations);

/// The state of the scene at t = 0. Throws SceneError where bodies overlap by more than counts as
/// touching.
State start_state(const Scene& scene);

}  // namespace wuerfel
