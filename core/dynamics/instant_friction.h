/// Eq. (9) with Coulomb's law over one island at an instant.
///
/// Where everything is at rest the convex program decides whether an equilibrium exists
/// (qp/coulomb/rest_program.h); if one does, the island rests in it, although a fall may satisfy the
/// law as well. Else accelerations are those of the exact law, with the known directions of slip; of several solutions one
/// in which the cubes that stand still stay so, if all of them can.
#pragma once

#include <span>
#include <vector>

#include "core/dynamics/gauss.h"

namespace wuerfel {

/// What is known of an island that rubs, beside accelerations and forces.
struct IslandFriction {
  std::vector<int> slides;   ///< per contact: the sign of u_t where it is known, else 0
  bool equilibrium = false;  ///< everything is at rest, and admissible forces balance the weights
  /// Where everything is at rest and there is no equilibrium: a virtual motion along which no
  /// admissible force can hold the weights (m/s^2, rad/s^2, per cube), and its size as a share of g.
  std::vector<Twist> certificate;
  double unrest = 0.0;
  bool jams = false;  ///< no acceleration satisfies the law [Painlevé 1895]
};

/// Per contact the direction of slip, the sign of u_t, where |u_t| is above the share `dead_zone` of
/// max(sqrt(g side), |v|) and the contact rubs; else 0.
std::vector<int> known_slips(const System& system,
                             const State& state,
                             const Island& island,
                             double dead_zone);

struct RubbingAccelerations {
  IslandSolution solution;
  IslandFriction friction;
};

/// Accelerations and forces; of an equilibrium exactly zero. `use` and `slides` have one entry per
/// contact; `still`: nothing moves or slips.
RubbingAccelerations accelerations_with_friction(const System& system,
                                                 Formulation formulation,
                                                 const State& state,
                                                 const Island& island,
                                                 std::span<const SideUse> use,
                                                 const std::vector<int>& slides,
                                                 bool still);

/// Whether an island at rest, with an equilibrium, may fall all the same: whether the exact law was
/// found to have a solution that is not zero. Looked for from the modes of the `frictionless`
/// solution and from all contacts open. Never where the island stands without friction: friction
/// takes power, so that |a|^2 <= <f, a> <= 0 (in the metric of the masses).
bool fall_satisfies_law(const System& system,
                        const State& state,
                        const Island& island,
                        const IslandSolution& frictionless);

}  // namespace wuerfel
