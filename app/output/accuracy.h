/// Whether what was computed is as exact as was asked for.
#pragma once

#include "app/cli/exit_code.h"
#include "app/cli/streams.h"
#include "core/time/simulation.h"

namespace wuerfel {

/// Fine where every program was solved within the tolerance, every event was found, nothing
/// overlaps and energy drifted by no more than the tolerance promises; else undecided, with a
/// warning. `force_residual` is that of the forces that were asked for.
ExitCode verdict_on_accuracy(const Audit& audit, double force_residual, Notes& notes);

}  // namespace wuerfel
