// Meetings, ends of sides: events that geometry gives, at times in closed form.
#include "core/time/events/geometric_events.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/phases.h"

namespace wuerfel::test {
namespace {

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

/// The first event of geometry in a step of `length` s from the first instant of a scene.
std::optional<GeometricEvents::First> first_in(Begun& b, double length) {
  GeometricEvents geometry(b.m.system);
  geometry.begin(b.phase.state(), b.now.modes.closed, b.now.modes.resting);
  const SmoothStep& step = b.phase.step(length);
  auto first = geometry.first(step.motion, step.length, step.range).first;
  if (first) first->share *= step.length / length;
  return first;
}

TEST(GeometricEvents, OfTwoThatFallTheLowerOneIsFirst) {
  Begun b(on_floor({cube("a", {0.0, 3.0}), cube("b", {3.0, 2.0})}));
  const auto first = first_in(b, 1.0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->function.on, 1);
  EXPECT_NEAR(first->share, std::sqrt(2.0 * 1.5 / g), 1e-8);
}

TEST(GeometricEvents, CubesThatFlyTowardsEachOtherMeet) {
  // In space, 3 m apart, at 1 and 2 m/s.
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {4.0, 0.3})};
  scene.cubes[0].velocity = {1.0, 0.0};
  scene.cubes[1].velocity = {-2.0, 0.0};
  Begun b(scene);
  const auto first = first_in(b, 2.0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->function.kind, EventFunction::Kind::separation);
  EXPECT_NEAR(2.0 * first->share, 1.0, 1e-8);
  // One step aside they fly past each other.
  scene.cubes[1].position.y() = 1.1;
  Begun past(scene);
  EXPECT_FALSE(first_in(past, 2.0));
}

TEST(GeometricEvents, FlushSidesEndWhereTheirLastCornerLeaves) {
  //  +-----+->
  //  |  a  |          its rear is 1.5 m from the end of the shelf
  //  #############
  Scene scene;
  scene.fixed = {post("shelf", {-2.0, -0.5}, {4.0, 1.0})};
  scene.cubes = {cube("a", {-1.0, 0.5})};
  scene.cubes[0].velocity = {2.0, 0.0};
  Begun b(scene);
  double t = 0.0;
  std::optional<GeometricEvents::First> first;
  while (!first && t < 1.0) {
    const double most = std::min(0.4, b.phase.step(0.4).length);
    first = first_in(b, most);
    t += first ? first->share * most : most;
    b.phase.go_on();
  }
  ASSERT_TRUE(first);
  EXPECT_NEAR(t, 0.75, 1e-8);
}

TEST(GeometricEvents, WhatTouchesAndOpensIsNotMet) {
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.0, 0.0})};
  scene.cubes[1].velocity = {0.5, 0.0};
  Begun b(scene);
  EXPECT_FALSE(first_in(b, 1.0));
}

TEST(GeometricEvents, WhatGoesOnTouchingWithoutBeingClosedIsNotMet) {
  //   +---++---+->    both at the same velocity
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.0, 0.0})};
  for (SceneCube& c : scene.cubes)
    c.velocity = {0.0, 1.0};
  const Mechanism m(scene);
  SmoothPhase phase(m.system, true);
  phase.begin(m.state, {}, {0, 0}, 1e-12);
  GeometricEvents geometry(m.system);
  geometry.begin(phase.state(), {}, {0, 0});
  const SmoothStep& step = phase.step(1.0);
  EXPECT_FALSE(geometry.first(step.motion, step.length, step.range).first);
}

TEST(GeometricEvents, WhoIsAloneInTheWorldMeetsNobody) {
  Scene alone;
  alone.cubes = {cube("a", {0.0, 0.0})};
  const Mechanism m(alone);
  GeometricEvents geometry(m.system);
  geometry.begin(m.state, {}, {0});
  EXPECT_FALSE(geometry.watches());
  const Mechanism two(on_floor(alone.cubes));
  GeometricEvents ground(two.system);
  ground.begin(two.state, {}, {0});
  EXPECT_TRUE(ground.watches());
}

}  // namespace
}  // namespace wuerfel::test
