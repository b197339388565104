/// Algorithm 1 of the paper: explicit Euler as it is printed, and with the new velocity.
#pragma once

#include "core/time/reference/active_restrictions.h"
#include "core/time/reference/length_correction.h"

namespace wuerfel {

class Algorithm1 {
 public:
  Algorithm1(const System& system, const MotionSettings& settings);

  /// Makes a state the first grid point.
  void begin(GridPoint& point, Bookkeeping& book) { restrictions_.find(point, book); }
  /// One time step of `dt` s from a grid point to the next.
  void step(GridPoint& point, double dt, Bookkeeping& book);

 private:
  void integrate(GridPoint& point, double dt) const;

  const System* system_;
  Formulation formulation_;
  bool as_printed_;  ///< places move by the old velocities
  ActiveRestrictions restrictions_;
  LengthCorrection correction_;
};

}  // namespace wuerfel
