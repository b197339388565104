/// Piles: cubes scattered over a region at random.
#pragma once

#include <vector>

#include "core/scene/entries.h"

namespace wuerfel {

/// Gives the cubes of all piles, which are the last cubes of the scene in the order of `piles`,
/// their poses; all other bodies are in their places. Throws SceneError where a pile does not fit.
void scatter_piles(Scene& scene, const std::vector<PileEntry>& piles, const SceneSource& source);

}  // namespace wuerfel
