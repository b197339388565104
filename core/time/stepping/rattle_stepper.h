/// Second-order time stepping for crowded scenes: unilateral RATTLE as quadratic programs.
///
///   1. position program: the place nearest to free flight, q + h v + h^2 g / 2, with contact forces
///      along the directions of the step's start (that is what makes the order two),
///   2. clean-up: the nearest place without overlap, with directions of the end; no velocity knows of it,
///   3. velocity program: the velocity nearest to that after the first half that closes no gap.
///
/// Velocities are those at the start changed by gravity and by the impulses of 1 and 3, which act and react: no
/// momentum changes but by fixed bodies, however exactly the programs are solved. What they cost: step_books.h.
///
/// RATTLE [Andersen 1983] with Moreau's sweeping process for the inequalities [Moreau 1988].
#pragma once

#include <memory>
#include <vector>

#include "core/dynamics/rod_jam.h"
#include "core/time/stepping/landing.h"
#include "core/time/stepping/placement.h"
#include "core/time/stepping/step_energy.h"

namespace wuerfel {

/// A step that was tried.
struct Step {
  State state;       ///< at its end
  Bookkeeping book;  ///< events, losses, overlap and cost
  std::shared_ptr<const StepRecord> record;
  /// Local error as a share of the smallest side: the root mean square, over cubes that struck nothing, of what
  /// their way differs from the trapezoidal rule over their velocities, which is of third order as the error is.
  double error = 0.0;
  Rise rise;                  ///< energy that had to be taken back
  double overlap = 0.0;       ///< left, as a share of the smaller side of the pair
  std::vector<int> jammed{};  ///< rods that contradicted each other at its end
};

class RattleStepper {
 public:
  /// Energy of second order steps sways about its true value: `sway` is the share of what is in motion that it may
  /// be away from it. Where there is none, what a step changes of it is put right at once, which costs accuracy: what is
  /// taken and given back would have come back by itself.
  RattleStepper(const System& system, const MotionSettings& settings, double sway);

  /// The motion goes on from a state without overlap.
  void begin(const State& state);
  /// A step was accepted.
  void accept(const Step& step);
  /// One step of `h` s from a state without overlap at time t.
  [[nodiscard]] Step step(const State& state, double t, double h);
  /// The last step again, with cubes that overlap at its end stopped short on their way: for those that no step is
  /// short enough for.
  [[nodiscard]] Step stop_short(Step tried, double t);
  /// The last step again, in which everything stops where it was at its start: for those that would make energy which no motion
  /// can pay for, or tear rods, which contradict each other then.
  [[nodiscard]] Step halt(Step tried, double t) const;

  /// The longest step, s, in which no cube moves by more than half of the thinnest body: nothing tunnels.
  [[nodiscard]] double longest_step(const State& state) const;

  /// Contacts that carried load in the last step and are still near.
  [[nodiscard]] std::vector<Contact> loaded() const;
  /// Closes gaps of contacts that carried load in the last step, so that what leans on each other touches. Leaves
  /// the state as it is where that is not possible.
  void close_gaps(State& state);

 private:
  void fly_second_half(State& state) const;
  void arrive(Step& step, double t);
  [[nodiscard]] Push pushed() const;
  static void note_settled(const Push& change, const StepRecord& record, Bookkeeping& book);
  void jam(Step& step, StepRecord& record, double t);
  [[nodiscard]] std::vector<int> stopping_rods(const Island& island, const State& end) const;
  void take_jam(const Island& island, const RodJam& jam, Step& step, StepRecord& record);
  [[nodiscard]] bool strays(const StepRecord& record, const State& end) const;
  [[nodiscard]] double error_of(const State& state) const;

  const System* system_;
  Workspace work_;
  OverlapRemoval removal_;
  RestingIslands resting_;
  Placement placement_;
  Landing landing_;
  ClosedContacts closed_;
  double sway_ = 0.0;
  double true_energy_ = 0.0;   ///< J, of the beginning less what has been lost
  double start_motion_ = 0.0;  ///< J, what was in motion at the beginning
  std::vector<int> jammed_;    ///< Step::jammed of the step before
  Stride stride_;
  State flown_;                   ///< the end before the clean-up
  std::vector<Contact> cleaned_;  ///< contacts of the clean-up
};

}  // namespace wuerfel
