// Event functions: their derivatives are those that they say, and bounds hold.
#include "core/time/events/event_function.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/constraints/manifold.h"
#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

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

TEST(EventFunction, HaveTheDerivativesThatTheySay) {
  Draw draw;
  constexpr double dt = 1e-5;
  for (int k = 0; k < 200; ++k) {
    const Path on = draw_path(draw);
    const Path from = draw_path(draw);
    for (const auto kind :
         {EventFunction::Kind::gap, EventFunction::Kind::to_start, EventFunction::Kind::to_end}) {
      const auto read = [&](double t) {
        return corner_at_side(on.at(t), k % 4, from.at(t), 1, kind);
      };
      const Jet before = read(-dt);
      const Jet now = read(0.0);
      const Jet after = read(dt);
      EXPECT_NEAR(now.first, (after.value - before.value) / (2.0 * dt), 1e-5);
      EXPECT_NEAR(now.second, (after.first - before.first) / (2.0 * dt), 1e-4);
    }
  }
}

TEST(EventFunction, BoundsHoldWithinTheStep) {
  Draw draw;
  for (int k = 0; k < 200; ++k) {
    const Path on = draw_path(draw);
    const Path from = draw_path(draw);
    const double step = draw(0.01, 0.3);
    const MovingBox on_0 = on.at(0.0), on_1 = on.at(step);
    const MovingBox from_0 = from.at(0.0), from_1 = from.at(step);
    const DerivativeBounds bounds = bounds_of_corners(
        {&on_0, &on_1, {on.acceleration, on.acceleration}, false},
        {&from_0, &from_1, {from.acceleration, from.acceleration}, false}, step, step);
    const auto bend = [&](double t) {
      return corner_at_side(on.at(t), k % 4, from.at(t), 2, EventFunction::Kind::gap).second;
    };
    constexpr int parts = 50;
    for (int i = 0; i < parts; ++i) {
      const double a = bend(step * i / parts);
      const double b = bend(step * (i + 1) / parts);
      EXPECT_LE(std::abs(a), bounds.second);
      EXPECT_LE(std::abs(b - a) * parts / step, bounds.third);
    }
  }
}

/// A box at a place, at rest.
MovingBox still(const Vec2& position, double angle = 0.0, const Vec2& size = Vec2::Ones()) {
  return {make_box(position, angle, size), Vec2::Zero(), 0.0, {}};
}

TEST(EventFunction, SaysWhatTheRowsOfTheContactSay) {
  Draw draw;
  for (int k = 0; k < 200; ++k) {
    MovingBox on = draw_path(draw).at(0.0);
    const MovingBox from = draw_path(draw).at(0.0);
    // The corner is put on the side's line, with no rate.
    const int corner = k % 4;
    const Vec2 n = from.box.normal(1);
    const auto gap = [&] { return corner_at_side(on, corner, from, 1, EventFunction::Kind::gap); };
    on.box.center -= gap().value * n;
    on.velocity -= gap().first * n;
    const Contact c = corner_on_side(0, on.box, corner, 1, from.box, 1);
    const auto velocity = [](const MovingBox& b, const Vec2& r) {
      return Vec2(b.velocity + b.spin * perp(r));
    };
    const auto acceleration = [](const MovingBox& b, const Vec2& r) {
      return Vec2(b.acceleration.linear + b.acceleration.angular * perp(r) - b.spin * b.spin * r);
    };
    const Vec2 v_i = velocity(from, c.arm_i), v_j = velocity(from, c.arm_j);
    const Vec2 v_k = velocity(on, c.arm_k);
    const SideRow row = side_acceleration_row(c.arm_i, c.arm_j, c.alpha, v_i, v_j, v_k);
    const double second = row.g_i.dot(acceleration(from, c.arm_i))
                          + row.g_j.dot(acceleration(from, c.arm_j))
                          + row.g_k.dot(acceleration(on, c.arm_k)) + row.c;
    EXPECT_NEAR(c.gap, 0.0, 1e-14);
    EXPECT_NEAR(side_gap_rate(c.normal, c.alpha, v_i, v_j, v_k), 0.0, 1e-13);
    EXPECT_NEAR(gap().second, second / c.length, 1e-10 * (1.0 + std::abs(second)));
  }
}

TEST(EventFunction, DistancesOfACornerAlongASideAddUpToItsLength) {
  //      k
  //  +---+-----+   upper side of `from`, p_i at its left end (sides are stored clockwise)
  const MovingBox from = still({0.0, 0.0}, 0.0, {2.0, 1.0});
  const MovingBox on = still({-0.2, 1.0});
  const int upper = 2;
  const double to_start = corner_at_side(on, 0, from, upper, EventFunction::Kind::to_start).value;
  const double to_end = corner_at_side(on, 0, from, upper, EventFunction::Kind::to_end).value;
  EXPECT_NEAR(to_start, 0.3, 1e-15);
  EXPECT_NEAR(to_end, 1.7, 1e-15);
}

TEST(EventFunction, GapOfAFixedPlaneIsTheHeightAboveIt) {
  Body plane;
  plane.kind = BodyKind::plane;
  plane.point = {5.0, 1.0};
  plane.normal = Vec2(-0.6, 0.8);
  const MovingBox on = still({1.0, 3.0});
  const double gap =
      corner_at_side(on, 1, fixed_body(plane), plane_side, EventFunction::Kind::gap).value;
  EXPECT_NEAR(gap, plane.normal.dot(Vec2(1.5, 2.5) - plane.point), 1e-15);
}

TEST(EventFunction, SeparationIsThatOfTheBestSide) {
  Draw draw;
  for (int k = 0; k < 500; ++k) {
    const MovingPair pair{draw_path(draw).at(0.0), draw_path(draw).at(0.0)};
    const double least = separation_by(pair, separating_side(pair)).value;
    EXPECT_NEAR(least, separation(pair.on.box, pair.from.box), 1e-14);
  }
}

}  // namespace
}  // namespace wuerfel::test
