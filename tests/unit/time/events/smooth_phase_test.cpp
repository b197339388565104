// Motion while the same contacts stay closed, against closed forms, and the events that end it.
#include "core/time/events/smooth_phase.h"

#include <cmath>
#include <numeric>
#include <optional>

#include <gtest/gtest.h>

#include "core/time/events/force_events.h"
#include "core/time/events/geometric_events.h"
#include "core/time/events/instant.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

constexpr double g = 9.81;

/// A phase that begins with what a mechanism's first instant leaves closed.
struct Begun {
  explicit Begun(const Scene& scene)
      : m(scene),
        work(m.system, {}),
        now(happen(m.state, 0.0, {}, {}, work)),
        phase(m.system, true) {
    phase.begin(now.state, now.modes.closed, now.modes.resting, 1e-12);
  }
  Mechanism m;
  Workspace work;
  Instant now;
  SmoothPhase phase;
};

Scene thrown() {
  Scene scene = on_floor({cube("a", {0.0, 3.5})});
  scene.cubes[0].velocity = {1.0, 2.0};
  return scene;
}

TEST(SmoothPhase, FreeFallIsOneStepOfAnyLength) {
  Begun b(thrown());
  EXPECT_TRUE(b.phase.free());
  const SmoothStep& step = b.phase.step(0.5);
  EXPECT_EQ(step.length, 0.5);
  EXPECT_NEAR(step.end[0].position.y(), 3.5 + 1.0 - 0.5 * g * 0.25, 1e-14);
  b.phase.cut(0.2);
  EXPECT_EQ(b.phase.last().elapsed, 0.2);
  EXPECT_NEAR(b.phase.last().end[0].velocity.y(), 2.0 - 0.2 * g, 1e-14);
  b.phase.go_on();
  EXPECT_NEAR(b.phase.state()[0].position.x(), 0.2, 1e-15);
}

/// A block that slides down a plane of 3 in 4.
Scene slide() {
  Scene scene;
  const Vec2 normal(0.6, 0.8);
  scene.planes.push_back({"slope", Vec2::Zero(), normal, {}});
  scene.cubes = {sized_cube("a", 0.5 * normal, Vec2::Ones(), std::atan2(-0.6, 0.8))};
  return scene;
}

TEST(SmoothPhase, SlidingIsUniformlyAcceleratedAndBearsTheWeightAcross) {
  Begun b(slide());
  EXPECT_FALSE(b.phase.free());
  const std::vector<double> loads = b.phase.loads();
  EXPECT_NEAR(std::accumulate(loads.begin(), loads.end(), 0.0), 0.8 * g, 1e-13);
  double t = 0.0;
  while (t < 0.4) {
    t += b.phase.step(0.4 - t).length;
    b.phase.go_on();
  }
  const BodyState& s = b.phase.state()[0];
  EXPECT_NEAR(s.velocity.dot(Vec2(0.8, -0.6)), 0.6 * g * 0.4, 1e-13);
  EXPECT_NEAR(s.position.dot(Vec2(0.6, 0.8)), 0.5, 1e-15);
  EXPECT_NEAR(s.velocity.dot(Vec2(0.6, 0.8)), 0.0, 1e-15);
}

TEST(SmoothPhase, AnEndIsShiftedByItsAccelerations) {
  Begun b(thrown());
  b.phase.step(0.1);
  b.phase.shift_end(1e-6);
  EXPECT_NEAR(b.phase.last().elapsed, 0.1 + 1e-6, 1e-16);
  EXPECT_NEAR(b.phase.last().end[0].velocity.y(), 2.0 - g * (0.1 + 1e-6), 1e-14);
}

TEST(GeometricEvents, ABlockMeetsTheGroundWhenItsParabolaDoes) {
  Begun b(thrown());
  GeometricEvents geometry(b.m.system);
  geometry.begin(b.phase.state(), b.now.modes.closed, b.now.modes.resting);
  const SmoothStep& step = b.phase.step(1.5);
  const auto [first, given_up] = geometry.first(step.motion, step.length, step.range);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(given_up, 0);
  // 3 + 2 t - g t^2 / 2 = 0
  const double t = (2.0 + std::sqrt(4.0 + 6.0 * g)) / g;
  EXPECT_NEAR(first->share * step.length, t, 1e-8);
}

TEST(GeometricEvents, NothingHappensToWhatStaysAway) {
  Begun b(thrown());
  GeometricEvents geometry(b.m.system);
  geometry.begin(b.phase.state(), b.now.modes.closed, b.now.modes.resting);
  const SmoothStep& step = b.phase.step(0.9);
  EXPECT_FALSE(geometry.first(step.motion, step.length, step.range).first.has_value());
}

TEST(ForceEvents, WhatIsPressedAllTheTimeDoesNotLetGo) {
  Begun b(slide());
  ForceEvents forces;
  forces.begin(b.phase, 1e-11);
  b.phase.step(0.3);
  EXPECT_FALSE(forces.first(b.phase, 1.0, g, b.work).has_value());
}

TEST(ForceEvents, ABlockOverAnEdgeLetsGoOfTheCornerThatItTipsAwayFrom) {
  //    +-----+-->      the centre passes the end of the post: the load of the rear end of the overlap
  //    |  a  |         m g (x_end - x) / overlap vanishes where it is above the end
  //  ######
  Scene scene;
  scene.fixed = {post("shelf", {-2.0, -0.5}, {4.0, 1.0})};
  scene.cubes = {cube("a", {-0.3, 0.5})};
  scene.cubes[0].velocity = {1.0, 0.0};
  Begun b(scene);
  ASSERT_EQ(b.phase.loads().size(), 2U);
  ForceEvents forces;
  forces.begin(b.phase, 1e-11);
  double t = 0.0;
  std::optional<ForceEvents::First> first;
  while (!first) {
    const double length = b.phase.step(0.5).length;
    first = forces.first(b.phase, 1.0, g, b.work);
    t += first ? first->share * length : length;
    ASSERT_LT(t, 0.31);
    b.phase.go_on();
    forces.passed(b.phase.loads());
  }
  EXPECT_NEAR(t, 0.3, 1e-8);
}

}  // namespace
}  // namespace wuerfel::test
