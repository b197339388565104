/// How fast a simulation gets on: one that would not end in a lifetime ends with a reason.
#pragma once

#include <cstddef>
#include <stdexcept>

#include "app/cli/progress.h"
#include "app/cli/stop_signal.h"
#include "core/scene/scene.h"
#include "core/settings.h"
#include "core/time/simulation.h"

namespace wuerfel {

/// A simulation would take more steps than anybody waits for. Exit code 3.
class EndlessMotion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Counts the steps of a simulation. Counts decide, never a clock, so that runs repeat.
class Pace {
 public:
  /// `end`: the time to which it is wanted, s; `bodies`: how many may move by themselves. Steps of one length are not
  /// judged: how many there are was known beforehand.
  Pace(double end, std::size_t bodies, Integrator integrator);
  /// A step of one group was taken, the motion is known up to `reached`, s. Throws EndlessMotion where the rest would take
  /// more than a billion steps at the pace of the last ones.
  void beat(double reached);

 private:
  double end_;
  bool judged_;
  long steps_per_look_;
  long steps_ = 0;
  double last_ = 0.0;  // s, at the last look
};

/// After every step of a simulation on its way to `end` s signals, memory and pace are looked at, and it is told how far it
/// is. All but the settings outlives the simulation's next advance.
void watch_steps(Simulation& simulation,
                 const Scene& scene,
                 Integrator integrator,
                 double end,
                 const StopSignal& stop,
                 Progress* progress = nullptr);

}  // namespace wuerfel
