/// The time stepping of Moreau and Jean: the velocity nearest to that of free flight which closes no
/// contact, and a step with it (theta = 1) [Acary, Brogliato 2008, chapter 10]. It needs no
/// accelerations.
#pragma once

#include "core/time/reference/active_restrictions.h"
#include "core/time/reference/length_correction.h"

namespace wuerfel {

class Moreau {
 public:
  Moreau(const System& system, const MotionSettings& settings);

  /// Makes a state the first grid point.
  void begin(GridPoint& point, Bookkeeping& book) { restrictions_.find(point, book); }
  /// One time step of `dt` s from a grid point to the next.
  void step(GridPoint& point, double dt, Bookkeeping& book);

 private:
  void certify_rest(GridPoint& point, Bookkeeping& book);

  const System* system_;
  ActiveRestrictions restrictions_;
  LengthCorrection correction_;
};

}  // namespace wuerfel
