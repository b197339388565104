/// The forces to show: of all that Coulomb's law allows at the given motion those of least sum of
/// squares of normal and tangential forces together, the limit of equal, vanishing compliance both
/// ways; and which of them are the only ones possible.
///
///     minimise 1/2 |l|^2   subject to   G' l = s,   l_i in K_i
///
/// where K_i is the cone of friction of a contact that sticks, its edge against the slip of one that
/// slips, and zero of one that opens. (Not the least norm of the multipliers of two rows J_n +- mu
/// J_t, which weighs tangential forces by 1 / mu.) Proximal iteration s_k+1 = s_k + s - G' l, with
/// l = P_K(G z) at the minimum of 1/2 |z|^2 / rho + 1/2 |P_K(G z)|^2 - s_k' z by semismooth Newton
/// steps. [Rockafellar 1976b], as in NewtonMethod.
#pragma once

#include <vector>

#include "core/qp/coulomb/friction_program.h"

namespace wuerfel {

struct CanonicalForces {
  std::vector<double> multiplier;  ///< m
  /// One per contact, then one per row of no contact: no other normal force is possible there, and no other tangential one
  /// together with contacts whose tangential forces act alike (of flush sides).
  std::vector<bool> unique;
  double misfit = 0.0;  ///< |s - G' l| / |s|; above 1e-8 the given multipliers are returned
};

/// From a solution (x, multipliers) of residual about 1e-10. Rows count with their own length:
/// write them with unit normals. `with_unique` false leaves the flags false.
CanonicalForces canonical_friction(const FrictionProgram& friction,
                                   const std::vector<double>& x,
                                   const std::vector<double>& multiplier,
                                   bool with_unique);

}  // namespace wuerfel
