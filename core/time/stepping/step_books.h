/// The books of a step: the work of contacts, what of it is lost, and the energy that the cubes have
/// afterwards. That of contacts that close is lost; what is left over is the sway of the method and is
/// given back.
#pragma once

#include "core/time/bookkeeping.h"
#include "core/time/stepping/step_record.h"
#include "core/time/stepping/stride.h"

namespace wuerfel {

/// Impulses, who pushed whom, and what that cost: contacts that close lose what their impulses take,
/// on balance; in a component where something is struck all contacts do, at the last blow. `end` is
/// the state that the step leads to.
StepRecord record_of(const System& system, const Stride& stride, const State& end);

/// The impacts of a step that begins at time t, in the order of time.
std::vector<Event> impacts_of(const System& system, const Stride& stride, double t);

/// What losses add up to, J.
double sum_of(const std::vector<StepLoss>& losses);

/// Brings the energy of every component to that of the start less its losses, as far as its velocities
/// allow; where it `sways`, energy stays what it is. What velocities do not, for the clean-up may lift
/// what stops on landing, is less of a loss. Returns by how much energy had risen, J.
double settle_energy(
    const System& system, const Stride& stride, bool sways, StepRecord& record, State& end);

}  // namespace wuerfel
