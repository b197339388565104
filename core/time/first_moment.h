/// Where a motion begins.
#pragma once

#include "core/scene/scene.h"
#include "core/time/moment.h"

namespace wuerfel {

/// The state of the scene at t = 0. Throws SceneError where bodies overlap by more than counts as
/// touching.
Moment first_moment(const Scene& scene);

}  // namespace wuerfel
