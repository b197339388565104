/// Rods that contradict each other: no accelerations keep all their lengths, as with a point that moves across two rods
/// in one line.
#pragma once

#include <string>
#include <vector>

#include "core/model/system.h"

namespace wuerfel {

/// Names of rods and pins that contradict each other at a state, of which none can be left out; empty where there are
/// none. Velocities must satisfy the rods.
std::vector<std::string> contradicting_rods(const System& system, const State& state);

}  // namespace wuerfel
