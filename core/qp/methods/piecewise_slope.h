/// The derivative of a dual along a step: piecewise linear, for rows leave and enter their ranges.
#pragma once

namespace wuerfel {

struct PiecewiseSlope {
  double slope = 0.0;      ///< at `at`
  double curvature = 0.0;  ///< from there to the next breakpoint
  double at = 0.0;         ///< share of the step

  /// Goes on to a breakpoint; false, and no further, where the slope comes to zero before it.
  bool goes_on_to(double next) {
    const double rise = curvature * (next - at);
    if (slope + rise >= 0.0) return false;
    slope += rise;
    at = next;
    return true;
  }
  [[nodiscard]] double zero() const { return at - slope / curvature; }
};

}  // namespace wuerfel
