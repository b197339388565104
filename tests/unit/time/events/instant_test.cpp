// What happens at an instant: impacts in closed form, rest, and how contacts go on.
#include "core/time/events/instant.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

Instant at_start(const Mechanism& m, double t = 0.0) {
  Workspace work(m.system, {});
  return happen(m.state, t, {}, {}, work);
}

int count(const Instant& now, EventKind kind) {
  return static_cast<int>(std::ranges::count(now.events, kind, &Event::kind));
}

TEST(Instant, TwoCubesThatMeetSquarelyGoOnTogether) {
  //   +---+  +---+
  //   | a |->| b |     m = 1, 3; inelastic: v = 1/4
  //   +---+  +---+
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.0, 0.0})};
  scene.cubes[0].velocity = {1.0, 0.0};
  scene.cubes[1].mass = 3.0;
  const Mechanism m(scene);
  const Instant now = at_start(m, 0.5);
  EXPECT_NEAR(now.state[0].velocity.x(), 0.25, 1e-14);
  EXPECT_NEAR(now.state[1].velocity.x(), 0.25, 1e-14);
  EXPECT_EQ(now.state[0].spin, 0.0);
  ASSERT_EQ(count(now, EventKind::impact), 2);
  double impulse = 0.0;
  for (const Event& e : now.events) {
    EXPECT_EQ(e.t, 0.5);
    impulse += e.impulse;
  }
  EXPECT_NEAR(impulse, 0.75, 1e-14);
  const double loss = kinetic_energy(m.system, m.state) - kinetic_energy(m.system, now.state);
  EXPECT_NEAR(loss, 0.5 - 0.5 * 4.0 / 16.0, 1e-14);
  ASSERT_EQ(now.modes.closed.touches.size(), 1U);
  EXPECT_EQ(now.modes.closed.touches[0].kind, Touch::Kind::flush);
}

TEST(Instant, ThreeCubesInARowShareTheMomentumAtOnce) {
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.0, 0.0}), cube("c", {2.0, 0.0})};
  scene.cubes[0].velocity = {2.0, 0.0};
  scene.cubes[2].mass = 3.0;
  const Instant now = at_start(Mechanism(scene));
  for (const BodyState& s : now.state)
    EXPECT_NEAR(s.velocity.x(), 0.4, 1e-14);
}

TEST(Instant, ACubeThatLandsOnItsCornerTurns) {
  // A corner below and right of the centre by r = (x, -y): v+ = 0 there, impulse p up:
  // p = v / (1/m + x^2 / I).
  Scene scene = on_floor({});
  const double angle = 0.3;
  const Vec2 arm = make_box(Vec2::Zero(), angle, Vec2::Ones()).arm[0];
  scene.cubes = {sized_cube("a", {0.0, -arm.y()}, Vec2::Ones(), angle)};
  scene.cubes[0].velocity = {0.0, -2.0};
  const Instant now = at_start(Mechanism(scene));
  const double impulse = 2.0 / (1.0 + 6.0 * arm.x() * arm.x());
  ASSERT_EQ(now.events.size(), 1U);
  EXPECT_NEAR(now.events[0].impulse, impulse, 1e-13);
  EXPECT_NEAR(now.state[0].velocity.y(), -2.0 + impulse, 1e-13);
  EXPECT_NEAR(now.state[0].spin, 6.0 * arm.x() * impulse, 1e-13);
}

TEST(Instant, WhatLandsFlatRests) {
  Scene scene = on_floor({cube("a", {0.0, 0.5})});
  scene.cubes[0].velocity = {0.0, -1.0};
  const Instant now = at_start(Mechanism(scene), 0.3);
  EXPECT_EQ(now.modes.resting[0], 1);
  EXPECT_EQ(count(now, EventKind::impact), 2);
  EXPECT_EQ(count(now, EventKind::rest), 1);
  EXPECT_TRUE(now.modes.closed.contacts.empty());
}

TEST(Instant, WhatRestsAlreadyIsSkipped) {
  const Mechanism m(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.1, 1.5})}));
  Workspace work(m.system, {});
  FormerPhase before;
  before.modes.resting = {1, 1};
  const Instant now = happen(m.state, 1.0, before, {}, work);
  EXPECT_EQ(now.skipped_rest, 1);
  EXPECT_EQ(work.solves.solved, 0);
  EXPECT_EQ(now.modes.resting, (std::vector<char>{1, 1}));
}

TEST(Instant, WhatTouchesNothingFalls) {
  const Mechanism m(on_floor({cube("a", {0.0, 2.0})}));
  const Instant now = at_start(m);
  EXPECT_EQ(now.skipped_free, 1);
  EXPECT_EQ(now.modes.resting[0], 0);
}

}  // namespace
}  // namespace wuerfel::test
