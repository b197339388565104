/// The deepest overlap of a state, by separating axes over all pairs in double precision; written
/// for the benchmark alone, so that no engine is measured by its own ruler.
#pragma once

#include "core/model/state.h"
#include "core/scene/scene.h"

namespace wuerfel::bench {

/// m; 0 where nothing overlaps. Planes are half-planes, fixed bodies count too.
double deepest_overlap(const Scene& scene, const State& state);

}  // namespace wuerfel::bench
