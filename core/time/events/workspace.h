/// What a group of cubes computes with at its events: memory and solvers, handed to whoever needs
/// them, and a count of what they did. Changes no answer beyond its residual.
#pragma once

#include "core/dynamics/friction.h"
#include "core/time/events/solves.h"

namespace wuerfel {

struct Workspace {
  Workspace(const System& of, const MotionSettings& settings)
      : system(&of), skips(settings.skips), dynamics(of, settings), friction(of, settings) {}

  const System* system;
  Skips skips;
  IslandDynamics dynamics;
  FrictionDynamics friction;
  ContactFinder finder;
  Solves solves;  ///< since whoever keeps book took them
};

}  // namespace wuerfel
