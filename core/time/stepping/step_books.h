/// The books of a step: the work of contacts, and what of it is lost. That of contacts that close is lost; what is left
/// over is the sway of the method.
#pragma once

#include "core/time/bookkeeping.h"
#include "core/time/stepping/step_record.h"
#include "core/time/stepping/stride.h"

namespace wuerfel {

/// J, along the normal, and along the side.
struct Work {
  double normal = 0.0;
  double side = 0.0;
  [[nodiscard]] double sum() const { return normal + side; }
};

/// What the impulse of a contact does in the first half against the mean velocity that it changes, gravity aside. Sums over all
/// contacts and both halves are the exact changes of energy.
Work first_work(const System& system, const Stride& stride, const Blow& blow);

/// Impulses, who pushed whom, and what that cost: contacts that close lose what their impulses take,
/// on balance; in a component where something is struck all contacts do, at the last blow. `end` is
/// the state that the step leads to.
StepRecord record_of(const System& system, const Stride& stride, const State& end);

/// The impacts of a step that begins at time t, in the order of time.
std::vector<Event> impacts_of(const System& system, const Stride& stride, double t);

/// What losses add up to, J.
double sum_of(const std::vector<StepLoss>& losses);

}  // namespace wuerfel
