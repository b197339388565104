/// Time stepping with steps as long as their error, their energy and their overlap allow.
#pragma once

#include "core/time/policy.h"
#include "core/time/stepping/rattle_stepper.h"

namespace wuerfel {

class ControlledStepping {
 public:
  ControlledStepping(const System& system,
                     const MotionSettings& settings,
                     const MotionPolicy& policy);

  /// Goes on from `state` with a first step of `first` s; none is longer than `longest`.
  void begin(const State& state, double first, double longest);
  /// One step from time t, at most to `end`; returns where it ends.
  double advance(double t, double end, Bookkeeping& book);
  [[nodiscard]] const State& state() const { return state_; }
  /// What happened in the last step.
  [[nodiscard]] const std::shared_ptr<const StepRecord>& record() const { return record_; }
  /// Contacts that carried load in it.
  [[nodiscard]] std::vector<Contact> loaded() const { return stepper_.loaded(); }
  /// The state with the gaps closed of contacts that carried load in the last step.
  [[nodiscard]] State with_closed_gaps();

 private:
  [[nodiscard]] double bearable_rise() const;
  [[nodiscard]] double bearable_sway() const;
  [[nodiscard]] bool is_exact(const Step& step) const;
  [[nodiscard]] bool is_hopeless(const Step& step) const;
  Step take_step(double t, double shortest, double& h);

  const System* system_;
  RattleStepper stepper_;
  Scales scales_;
  double allowed_error_ = 0.0;  ///< of a step, as a share of the smallest side
  double sway_ = 0.0;           ///< MotionPolicy::sway
  State state_;
  std::shared_ptr<const StepRecord> record_;
  double step_ = 0.0;     ///< s, proposed for the next step
  double longest_ = 0.0;  ///< s, of a step
};

}  // namespace wuerfel
