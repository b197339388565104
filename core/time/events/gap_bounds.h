/// Bounds of derivatives of gaps: how fast what is watched can bend within a part of a step.
#pragma once

#include "core/time/events/watch.h"

namespace wuerfel {

/// Range of a cube's accelerations within a step.
struct TwistRange {
  Twist low;
  Twist high;
};

/// A body within a part of a step.
struct Travel {
  const MovingBox* begin = nullptr;
  const MovingBox* end = nullptr;
  TwistRange range;  ///< within the whole step
  bool still = false;
};

/// Bounds of the absolute values of the second and the third derivative (m/s^2, m/s^3).
struct GapBounds {
  double bend = 0.0;
  double jerk = 0.0;
};

/// Bounds for the corners of `on` across and along the sides of `from` within `part` s of a step of
/// `step` s.
GapBounds bounds_of_gap(const Travel& on, const Travel& from, double part, double step);

/// Whether a function that is positive at both ends of an interval of length `width` has no zero
/// between them, by its values, rates and bends there and the bounds within. All are in the
/// interval's own unit.
bool no_zero_between(const Reading& a, const Reading& b, double width, const GapBounds& bounds);

}  // namespace wuerfel
