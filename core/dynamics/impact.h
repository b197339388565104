/// Impact: velocities jump where a contact closes with a gap's rate below zero. The paper has no law
/// for it; ours is Moreau's projection, perfectly inelastic, all contacts of an island at once
/// [Moreau 1988].
#pragma once

#include "core/dynamics/friction.h"

namespace wuerfel {

struct [[nodiscard]] Impact {
  IslandSolution after;  ///< velocities (m/s, rad/s) of the cubes, impulses (N s) at the contacts
  double loss = 0.0;     ///< J, what the impact takes of the kinetic energy
};

/// Kinetic energy of an island's cubes, J.
double kinetic_energy(const System& system, const State& state, const Island& island);

/// Whether some contact closes, or velocities change the length of a rod, so that an impact is due.
bool closes(const System& system, const State& state, const Island& island);

/// The impact of an island. Changes nothing: the caller takes the velocities over and books.
Impact impact(const System& system,
              const State& state,
              const Island& island,
              IslandDynamics& dynamics);
/// The same with friction and restitution where the island rubs or bounces. What closes more slowly
/// than `slow` (m/s) does not bounce.
Impact impact(const System& system,
              const State& state,
              const Island& island,
              double slow,
              IslandDynamics& dynamics,
              FrictionDynamics& friction);

/// Impact without collision of an island for which no accelerations exist.
Impact jam(const System& system,
           const State& state,
           const Island& island,
           FrictionDynamics& dynamics);

}  // namespace wuerfel
