/// States between the ends of a step.
#pragma once

#include "core/time/stepping/overlap_removal.h"
#include "core/time/stepping/step_record.h"

namespace wuerfel {

class StepLook {
 public:
  StepLook(const System& system, const MotionSettings& settings);

  /// Where the cubes are at `share` of a step of `h` s from one state to the next: without overlap, with the momentum
  /// that the impulses have left by then, and with the energy of the start less what was lost by then.
  [[nodiscard]] State at(
      const State& from, const State& to, double h, double share, const StepRecord& record);

 private:
  [[nodiscard]] State between(
      const State& from, const State& to, double h, double share, const StepRecord& record) const;
  void set_velocities(const State& from,
                      const State& to,
                      double h,
                      double share,
                      const StepRecord& record,
                      State& state) const;
  void turn_on(const StepComponent& part, const State& from, double t, State& state) const;
  double set_energy(const StepComponent& part,
                    const State& from,
                    const State& to,
                    double share,
                    State& state) const;

  [[nodiscard]] std::vector<int> flying(const StepRecord& record,
                                        const State& flown,
                                        const State& state) const;

  const System* system_;
  Workspace work_;
  OverlapRemoval removal_;
};

}  // namespace wuerfel
