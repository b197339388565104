/// Impacts with restitution and friction, all contacts at once.
///
///     0 <= l_n  perp  u_n+ - e max(-u_n-, 0) >= 0,   Coulomb on the total impulses
///
/// Newton's law per contact: u_n+ >= -e u_n- where the contact closes (u_n- < 0), u_n+ >= 0 where it
/// does not. With several contacts, or friction, this can raise the energy, or have no solution at
/// all; then all e are scaled back together. [Glocker 2013] With all e = 0 the energy
/// never rises: it falls by at least half the square of the jump.
#pragma once

#include <span>

#include "core/qp/coulomb/coulomb_solver.h"

namespace wuerfel {

struct ImpactResult {
  CoulombResult solution;  ///< velocities after the impact, impulses
  /// What all e were multiplied by: 1 unless the energy would have risen (to 2^-20) or there was no solution (to 2^-6).
  double factor = 1.0;
};

/// `friction`: x the velocities, f those before, bounds of normal rows as without restitution.
/// `restitution` in [0, 1] and `normal_velocity` (u_n before) one per contact.
void impact_with_restitution(CoulombSolver& solver,
                             const FrictionProgram& friction,
                             std::span<const double> restitution,
                             std::span<const double> normal_velocity,
                             ImpactResult& result,
                             std::span<const std::uint64_t> keys = {});

}  // namespace wuerfel
