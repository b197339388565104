/// Load patterns: generalised forces (N, N m) on the cubes of an island, as vectors of unknowns.
#pragma once

#include <vector>

#include "core/statics/still_scene.h"

namespace wuerfel {

using Load = std::vector<double>;

/// All weights.
Load weights(const StillScene& still, const Island& island);

/// A force at a point of one cube (m, in the world).
Load force_at(
    const StillScene& still, const Island& island, int cube, const Vec2& point, const Vec2& force);

/// A torque on one cube.
Load torque_on(const Island& island, int cube, double torque);

/// On every cube `share` times its weight, in one direction.
Load share_of_weights(const StillScene& still, const Island& island, const Vec2& direction);

}  // namespace wuerfel
