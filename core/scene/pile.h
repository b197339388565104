/// Piles: cubes scattered over a region at random.
#pragma once

#include <vector>

#include "core/geometry/box.h"
#include "core/scene/entries.h"

namespace wuerfel {

/// Poses a cube was tried in before the region counts as full.
inline constexpr int pile_tries = 2'000;

struct PilePose {
  Vec2 position = Vec2::Zero();  ///< m
  double angle = 0.0;            ///< rad, in [0, pi)
};

/// Poses for the cubes of `pile`, each within the region and at least a hundredth of the smaller
/// side away from the others, the obstacles and the planes (random sequential addition: about half
/// the area can be filled). Fewer than pile.count where a cube found no place in pile_tries tries.
std::vector<PilePose> scatter(const PileEntry& pile,
                              const std::vector<Box>& obstacles,
                              const std::vector<ScenePlane>& planes);

/// Gives the cubes of all piles, which are the last cubes of the scene in the order of `piles`,
/// their poses; all other bodies are in their places. Throws SceneError where a pile does not fit.
void scatter_piles(Scene& scene, const std::vector<PileEntry>& piles, const SceneSource& source);

}  // namespace wuerfel
