/// Where a motion begins.
#pragma once

#include "core/model/system.h"
#include "core/scene/scene.h"

namespace wuerfel {

/// Throws SceneError where rods contradict each other at a state whose velocities satisfy them.
void require_consistent_rods(const System& system, const State& state);

/// The state of the scene at t = 0. Throws SceneError where bodies overlap by more than counts as
/// touching.
State start_state(const Scene& scene);

}  // namespace wuerfel
