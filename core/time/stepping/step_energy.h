/// The energy that the cubes have after a step: the sway of the method is given back, what was made is paid for.
#pragma once

#include "core/time/stepping/step_record.h"
#include "core/time/stepping/stride.h"

namespace wuerfel {

/// Energy that a step had made, J.
struct Rise {
  double whole = 0.0;   ///< all of it
  double unpaid = 0.0;  ///< what no motion could pay for
  double sway = 0.0;    ///< by how much the step missed its energy, either way
};

/// Brings the energy of every component to that of the start less its losses, as far as its velocities
/// allow; where it `sways`, energy stays what it is. What velocities do not, for the clean-up may lift
/// what stops on landing, is less of a loss.
Rise restore_energy(
    const System& system, const Stride& stride, bool sways, StepRecord& record, State& end);

/// Takes energy (J) that cubes have too much from what is in motion in these components; returns what none could pay for.
double pay(const System& system,
           const std::vector<StepComponent>& components,
           double unpaid,
           State& state);

}  // namespace wuerfel
