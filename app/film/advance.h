/// Simulating for a person who waits.
#pragma once

#include "app/cli/progress.h"
#include "app/cli/stop_signal.h"
#include "core/time/simulation.h"

namespace wuerfel {

/// Moves on to `t` s some steps of length `step` s at a time, so that Ctrl-C and the progress bar
/// need not wait for the next frame; looking does not change the motion. Throws Interrupted.
void advance(
    Simulation& simulation, double t, double step, const StopSignal& stop, Progress& progress);

}  // namespace wuerfel
