/// When does a contact let go? The search for the first force of a step that vanishes.
#pragma once

#include <optional>

#include "core/time/events/holds.h"
#include "core/time/events/motion_piece.h"
#include "core/time/events/opening_test.h"

namespace wuerfel {

class ReleaseSearch {
 public:
  ReleaseSearch(const System& system, const MotionSettings& settings)
      : opening_(system, settings) {}

  /// The smallest of the forces that hold `closed` at a state.
  double hold_at(const State& state, const Holds& holds, ClosedContacts& closed);
  /// Share of the step, at most `until`, at which the first force vanishes. `next` is the state at
  /// the end of the step.
  std::optional<double> first_release(const DenseStep& motion,
                                      double until,
                                      const State& next,
                                      const Holds& holds,
                                      ClosedContacts& closed);
  /// Share of the step from which on redundant contacts open: a gap accelerates by more than a
  /// share of `gravity`. Negative forces alone are no reason: other forces may do the same. The
  /// program with inequalities decides.
  std::optional<double> first_opening(const DenseStep& motion,
                                      double until,
                                      const State& next,
                                      double gravity,
                                      ClosedContacts& closed,
                                      Bookkeeping& book);

 private:
  OpeningTest opening_;
  std::vector<Twist> accelerations_;
};

}  // namespace wuerfel
