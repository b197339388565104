/// The forces that contacts can exert, as generators of a cone: (E)  G f + w = 0,  f >= 0.
///
/// One generator for each row of a program, whose multiplier is the force: the normal n where nothing
/// rubs, the edges n + mu t and n - mu t of the cone of friction, or n, +t and -t where nothing slides
/// (the limit of large mu, [Heyman 1966]). Rods are generators of both signs.
#pragma once

#include <vector>

#include "core/constraints/islands.h"
#include "core/model/system.h"
#include "core/qp/quadratic_program.h"

namespace wuerfel {

enum class Sliding {
  given,  ///< as the scene's friction has it
  none,   ///< friction holds whatever it has to
};

/// What a unit of a generator presses and pulls at its contact.
struct ForceShare {
  int contact = -1;  ///< of the island; -1: none, a rod
  double normal = 0.0;
  double tangential = 0.0;
};

/// Over one island. Unknowns are x, y, theta per cube; bounds and targets are zero.
struct Generators {
  QuadraticProgram program;
  std::vector<ForceShare> share;  ///< per row
};

Generators find_generators(const System& system,
                           const State& state,
                           const Island& island,
                           Sliding sliding);

}  // namespace wuerfel
