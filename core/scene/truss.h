/// Trusses: point masses and rods of a plane girder.
#pragma once

#include <string>
#include <vector>

#include "core/scene/joints.h"

namespace wuerfel {

/// Name of the truss `i` of a scene, its own or truss1, truss2, ...
std::string truss_name(const std::vector<TrussEntry>& trusses, int i);

/// Its joints: those of the lower chord, then those of the upper, each from `from` to `to`. Throws SceneError where it
/// has no length.
std::vector<ScenePoint> truss_points(const TrussEntry& truss,
                                     const std::string& name,
                                     const Material& material,
                                     const SceneSource& source);

/// Adds its rods and supports.
void join_truss(const TrussEntry& truss, const std::string& name, JointEntries& joints);

}  // namespace wuerfel
