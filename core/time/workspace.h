/// What a group of cubes computes with: memory and solvers, handed to whoever needs them, and a count
/// of what they did. Changes no answer beyond its residual.
#pragma once

#include "core/dynamics/friction.h"
#include "core/dynamics/solves.h"

namespace wuerfel {

struct Workspace {
  Workspace(const System& of,
            const MotionSettings& settings,
            const ProgramTolerances& tolerances = {})
      : system(&of),
        formulation(settings.formulation),
        skips(settings.skips),
        dynamics(of, settings, tolerances),
        friction(of, settings) {}

  const System* system;
  Formulation formulation;
  Skips skips;
  IslandDynamics dynamics;
  FrictionDynamics friction;
  ContactFinder finder;
  Solves solves;  ///< since whoever keeps book took them
};

}  // namespace wuerfel
