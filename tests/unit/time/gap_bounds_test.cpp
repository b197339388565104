// What the search for events relies on: derivatives of what it watches, and bounds that hold.
#include "core/time/events/gap_bounds.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/time/events/dop853.h"
#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

/// Numbers between bounds.
class Draw {
 public:
  double operator()(double low, double high) {
    return low + 0.5 * (random_.next() + 1.0) * (high - low);
  }
  Vec2 vector(double size) { return size * random_.next_vec2(); }

 private:
  RandomNumbers random_{5};
};

/// A box with constant acceleration.
struct Path {
  Vec2 size, position, velocity;
  double angle = 0.0, spin = 0.0;
  Twist acceleration;

  [[nodiscard]] MovingBox at(double t) const {
    const Vec2 x = position + t * velocity + 0.5 * t * t * acceleration.linear;
    const double turned = angle + t * spin + 0.5 * t * t * acceleration.angular;
    return {make_box(x, turned, size), velocity + t * acceleration.linear,
            spin + t * acceleration.angular, acceleration};
  }
};

Path draw_path(Draw& draw) {
  return {{draw(0.2, 2.0), draw(0.2, 2.0)},
          draw.vector(2.0),
          draw.vector(3.0),
          draw(-3.0, 3.0),
          draw(-4.0, 4.0),
          {draw.vector(10.0), draw(-20.0, 20.0)}};
}

TEST(WatchedFunctions, HaveTheDerivativesThatTheySay) {
  Draw draw;
  constexpr double dt = 1e-5;
  for (int k = 0; k < 200; ++k) {
    const Path on = draw_path(draw);
    const Path from = draw_path(draw);
    for (const auto kind : {Watch::Kind::gap, Watch::Kind::to_start, Watch::Kind::to_end}) {
      const auto read = [&](double t) { return read_corner(on.at(t), k % 4, from.at(t), 1, kind); };
      const Reading before = read(-dt);
      const Reading now = read(0.0);
      const Reading after = read(dt);
      EXPECT_NEAR(now.rate, (after.value - before.value) / (2.0 * dt), 1e-5);
      EXPECT_NEAR(now.bend, (after.rate - before.rate) / (2.0 * dt), 1e-4);
    }
  }
}

TEST(GapBounds, HoldWithinTheStep) {
  Draw draw;
  for (int k = 0; k < 200; ++k) {
    const Path on = draw_path(draw);
    const Path from = draw_path(draw);
    const double step = draw(0.01, 0.3);
    const MovingBox on_0 = on.at(0.0), on_1 = on.at(step);
    const MovingBox from_0 = from.at(0.0), from_1 = from.at(step);
    const GapBounds bounds = bounds_of_gap(
        {&on_0, &on_1, {on.acceleration, on.acceleration}, false},
        {&from_0, &from_1, {from.acceleration, from.acceleration}, false}, step, step);
    const auto bend = [&](double t) {
      return read_corner(on.at(t), k % 4, from.at(t), 2, Watch::Kind::gap).bend;
    };
    constexpr int parts = 50;
    for (int i = 0; i < parts; ++i) {
      const double a = bend(step * i / parts);
      const double b = bend(step * (i + 1) / parts);
      EXPECT_LE(std::abs(a), bounds.bend);
      EXPECT_LE(std::abs(b - a) * parts / step, bounds.jerk);
    }
  }
}

TEST(NoZeroBetween, IsNeverSaidOfAFunctionThatHasOne) {
  Draw draw;
  int cleared = 0;
  for (int k = 0; k < 20000; ++k) {
    // A cubic: its bend is linear, so that its bounds are exact.
    const double c[4] = {draw(0.0, 1.0), draw(-2.0, 2.0), draw(-4.0, 4.0), draw(-4.0, 4.0)};
    const auto at = [&](double t) {
      return Reading{c[0] + t * (c[1] + t * (c[2] + t * c[3])),
                     c[1] + t * (2.0 * c[2] + 3.0 * t * c[3]), 2.0 * c[2] + 6.0 * t * c[3]};
    };
    const Reading a = at(0.0);
    const Reading b = at(1.0);
    const GapBounds bounds{std::max(std::abs(a.bend), std::abs(b.bend)), 6.0 * std::abs(c[3])};
    if (!no_zero_between(a, b, 1.0, bounds)) continue;
    ++cleared;
    for (int i = 0; i <= 100; ++i)
      ASSERT_GT(at(i / 100.0).value, 0.0);
  }
  EXPECT_GT(cleared, 2000);
}

TEST(NoZeroBetween, IsSaidAtOnceOfAGapThatOpensFromZero) {
  // t^3, a release, with a bound of the bend that is much too large.
  const Reading a{1e-3, 0.0, 0.0};
  const Reading b{1.0, 3.0, 6.0};
  EXPECT_TRUE(no_zero_between(a, b, 1.0, {100.0, 6.0}));
  EXPECT_FALSE(no_zero_between(a, b, 1.0, {100.0, 100.0}));
}

TEST(DenseStep, HasTheSlopeOfItsValue) {
  Draw draw;
  DenseStep step;
  for (int k = 0; k < DenseStep::terms; ++k)
    step.coefficients.push_back(draw(-1.0, 1.0));
  constexpr double ds = 1e-5;
  for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const double difference = (step.component(s + ds, 0) - step.component(s - ds, 0)) / (2.0 * ds);
    EXPECT_NEAR(step.slope(s, 0), difference, 1e-8);
  }
}

}  // namespace
}  // namespace wuerfel::test
