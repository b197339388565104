#include "core/time/events/event_function.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// The rates of accelerations are at most this many times what their range within a step says.
constexpr double jerk_reserve = 8.0;

double larger(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

/// The corner of `b` nearest to side e of `a`.
int nearest_to_side(const Box& a, int e, const Box& b) {
  const Vec2 n = a.normal(e);
  const auto height = [&](int k) { return n.dot(b.arm[k]); };
  int best = 0;
  for (int k = 1; k < Box::corners; ++k) {
    if (height(k) < height(best)) best = k;
  }
  return best;
}

RelativeMotion motion_of_corner(const MovingBox& b, int corner, const MovingBox& a) {
  const Vec2 r = b.box.arm[corner];
  const Twist velocity{b.velocity - a.velocity, b.spin};
  const Twist acceleration{b.acceleration.linear - a.acceleration.linear, b.acceleration.angular};
  return {(b.box.center - a.box.center) + r, point_velocity(velocity, r),
          point_acceleration(acceleration, b.spin, r)};
}

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

}  // namespace

MovingBox fixed_body(const Body& body) {
  MovingBox fixed;
  fixed.box = body.box;
  if (body.kind == BodyKind::plane) {
    fixed.box.center = body.point;
    fixed.box.axis = -perp(body.normal);
  }
  return fixed;
}

Jet corner_at_side(
    const MovingBox& on, int corner, const MovingBox& from, int side, EventFunction::Kind kind) {
  const RelativeMotion k = motion_of_corner(on, corner, from);
  const Vec2 n = from.box.normal(side);
  const double alpha = from.acceleration.angular;
  if (kind == EventFunction::Kind::gap || kind == EventFunction::Kind::separation)
    return side_gap_jet(n, from.box.reach(side), from.spin, alpha, k);
  // From p_i to p_j: the normal is perp(p_j - p_i). The ends are half a length from the middle.
  const Vec2 inwards = kind == EventFunction::Kind::to_start ? Vec2(-perp(n)) : perp(n);
  return side_gap_jet(inwards, -0.5 * from.box.length(side), from.spin, alpha, k);
}

PairSide separating_side(const MovingPair& pair) {
  const SideSeparations all = side_separations(pair.from.box, pair.on.box);
  const auto best = static_cast<int>(std::ranges::max_element(all) - all.begin());
  return {best >= Box::corners, best % Box::corners};
}

Jet gap_of_corner(const MovingPair& pair, const PairSide& s, int k) {
  const MovingBox& on = s.of_on ? pair.from : pair.on;
  const MovingBox& from = s.of_on ? pair.on : pair.from;
  return corner_at_side(on, k, from, s.side, EventFunction::Kind::gap);
}

Jet separation_by(const MovingPair& pair, const PairSide& s) {
  const Box& on = s.of_on ? pair.from.box : pair.on.box;
  const Box& from = s.of_on ? pair.on.box : pair.from.box;
  return gap_of_corner(pair, s, nearest_to_side(from, s.side, on));
}

// With a corner at d from the centre of `from` and a vector n that turns with it, the function is
// <n, d> and a constant; below are bounds of the derivatives of d and n.
DerivativeBounds bounds_of_corners(const Travel& on, const Travel& from, double part, double step) {
  const Turning corner = turning_of(on, part, step);
  const Turning side = turning_of(from, part, step);
  const double radius = on.begin->box.radius();
  const Vec2 low = on.range.low.linear - from.range.high.linear;
  const Vec2 high = on.range.high.linear - from.range.low.linear;
  const double a = low.cwiseAbs().cwiseMax(high.cwiseAbs()).norm();
  const double jerk = jerk_reserve * (high - low).norm() / step;
  const double speed = std::max((on.begin->velocity - from.begin->velocity).norm(),
                                (on.end->velocity - from.end->velocity).norm())
                       + 0.5 * part * a;
  const double d_2 = a + (corner.turn + corner.spin * corner.spin) * radius;
  const double d_3 =
      jerk
      + (corner.jerk + 3.0 * corner.spin * corner.turn + corner.spin * corner.spin * corner.spin)
            * radius;
  if (from.still) return {acceleration_reserve * d_2, acceleration_reserve * d_3};
  const double d_1 = speed + corner.spin * radius;
  const double d_0 = std::max((on.begin->box.center - from.begin->box.center).norm(),
                              (on.end->box.center - from.end->box.center).norm())
                     + 0.5 * part * speed + radius;
  const double n_1 = side.spin;
  const double n_2 = side.turn + side.spin * side.spin;
  const double n_3 = side.jerk + 3.0 * side.spin * side.turn + side.spin * side.spin * side.spin;
  return {acceleration_reserve * (d_2 + 2.0 * n_1 * d_1 + n_2 * d_0),
          acceleration_reserve * (d_3 + 3.0 * n_1 * d_2 + 3.0 * n_2 * d_1 + n_3 * d_0)};
}

}  // namespace wuerfel
