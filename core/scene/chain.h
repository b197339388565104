/// Chains: point masses or cubes, joined by rods or pins between two places.
#pragma once

#include <string>
#include <vector>

#include "core/scene/groups.h"
#include "core/scene/joints.h"

namespace wuerfel {

/// A scene whose chains are laid.
struct ChainGround {
  Scene& scene;
  const Groups& groups;
  const BodyNames& names;
  const SceneSource& source;
};

/// Name of the chain `i` of a scene, its own or chain1, chain2, ...
std::string chain_name(const std::vector<ChainEntry>& chains, int i);

/// The links of a chain of point masses, which get their places later.
std::vector<ScenePoint> chain_points(const ChainEntry& chain,
                                     const std::string& name,
                                     const Material& material);

/// Gives the links of all chains their places, in the order of the text, and adds what joins them. What stands has its
/// place. A chain that is longer than the distance of its ends sags along an arc, where gravity pulls. Throws SceneError
/// where a chain is too short or cannot move.
void lay_chains(const ChainGround& ground,
                const std::vector<ChainEntry>& chains,
                JointEntries& joints);

/// Corners of a line of straight segments of these lengths (m) from (0, 0) to (`distance`, 0), all on one arc over the
/// x axis; empty where no arc below a full circle, with its centre on the side of the longest segment, holds them.
std::vector<Vec2> corners_on_arc(const std::vector<double>& segments, double distance);

}  // namespace wuerfel
