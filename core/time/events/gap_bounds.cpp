#include "core/time/events/gap_bounds.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// Accelerations are known at the stages of a step: their bounds have this much in reserve, and
/// their rates this many times what the range of the accelerations says.
constexpr double reserve = 1.5;
constexpr double jerk_reserve = 8.0;
/// Bends are derivatives of a polynomial: this share of their bound is left to its error.
constexpr double bend_error = 1e-6;

double larger(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

/// Bounds of angular acceleration, of its rate, and of the angular velocity in a part of a step.
struct Turning {
  double spin = 0.0;
  double turn = 0.0;
  double jerk = 0.0;
};

Turning turning_of(const Travel& body, double part, double step) {
  if (body.still) return {};
  const TwistRange& range = body.range;
  Turning t;
  t.turn = larger(range.low.angular, range.high.angular);
  t.spin = larger(body.begin->spin, body.end->spin) + 0.5 * part * t.turn;
  t.jerk = jerk_reserve * (range.high.angular - range.low.angular) / step;
  return t;
}

/// How much the function may bend downwards at most.
double downwards(const Reading& a, const Reading& b, double width, const GapBounds& bounds) {
  const double least =
      std::min(0.5 * (a.bend + b.bend - bounds.jerk * width), std::min(a.bend, b.bend));
  return std::clamp(-least, 0.0, bounds.bend) + bend_error * bounds.bend;
}

/// Time up to which a function that bends downwards by at most `bend` stays positive.
double positive_for(double value, double rate, double bend) {
  const double root = std::sqrt(rate * rate + 2.0 * bend * value);
  return rate < 0.0 ? 2.0 * value / (root - rate) : (rate + root) / bend;
}

}  // namespace

// With a corner at d from the centre of `from` and a vector n that turns with it, the function is
// <n, d> and a constant; below are bounds of the derivatives of d and n.
GapBounds bounds_of_gap(const Travel& on, const Travel& from, double part, double step) {
  const Turning corner = turning_of(on, part, step);
  const Turning side = turning_of(from, part, step);
  const double radius = on.begin->box.half.norm();
  const Twist low{on.range.low.linear - from.range.high.linear, 0.0};
  const Twist high{on.range.high.linear - from.range.low.linear, 0.0};
  const double a = low.linear.cwiseAbs().cwiseMax(high.linear.cwiseAbs()).norm();
  const double jerk = jerk_reserve * (high.linear - low.linear).norm() / step;
  const double speed = std::max((on.begin->velocity - from.begin->velocity).norm(),
                                (on.end->velocity - from.end->velocity).norm())
                       + 0.5 * part * a;
  const double d_2 = a + (corner.turn + corner.spin * corner.spin) * radius;
  const double d_3 =
      jerk
      + (corner.jerk + 3.0 * corner.spin * corner.turn + corner.spin * corner.spin * corner.spin)
            * radius;
  if (from.still) return {reserve * d_2, reserve * d_3};
  const double d_1 = speed + corner.spin * radius;
  const double d_0 = std::max((on.begin->box.center - from.begin->box.center).norm(),
                              (on.end->box.center - from.end->box.center).norm())
                     + 0.5 * part * speed + radius;
  const double n_1 = side.spin;
  const double n_2 = side.turn + side.spin * side.spin;
  const double n_3 = side.jerk + 3.0 * side.spin * side.turn + side.spin * side.spin * side.spin;
  return {reserve * (d_2 + 2.0 * n_1 * d_1 + n_2 * d_0),
          reserve * (d_3 + 3.0 * n_1 * d_2 + 3.0 * n_2 * d_1 + n_3 * d_0)};
}

// The first zero that is possible after the one end must lie beyond the last that is possible
// before the other.
bool no_zero_between(const Reading& a, const Reading& b, double width, const GapBounds& bounds) {
  if (a.value <= 0.0 || b.value <= 0.0) return false;
  // Below its chord a function stays by no more than this.
  if (std::min(a.value, b.value) > 0.125 * bounds.bend * width * width) return true;
  const double bend = std::max(downwards(a, b, width, bounds), 1e-300);
  return positive_for(a.value, a.rate, bend) + positive_for(b.value, -b.rate, bend) >= width;
}

}  // namespace wuerfel
