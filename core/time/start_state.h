/// Where a motion begins.
#pragma once

#include "core/model/state.h"
#include "core/scene/scene.h"

namespace wuerfel {

/// The state of the scene at t = 0. Throws SceneError where bodies overlap by more than counts as
/// touching.
State start_state(const Scene& scene);

}  // namespace wuerfel
