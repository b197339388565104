// Groups of cubes: who moves with whom, and that nobody else notices.
#include "core/time/island_motion.h"

#include <gtest/gtest.h>

#include "core/time/policy.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// In space: two cubes that fly towards each other meet after 1.5 s.
///   +---+              +---+
///   | a |->          <-| b |
///   +---+              +---+
Scene meeting() {
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {-2.0, 0.0}), cube("b", {2.0, 0.0})};
  scene.cubes[0].velocity = {1.0, 0.0};
  scene.cubes[1].velocity = {-1.0, 0.0};
  return scene;
}

TEST(IslandMotion, GroupsThatMeetAreJoined) {
  const Mechanism m(meeting());
  IslandMotion motion(m.system, {}, m.state);
  motion.advance_to(3.0);
  for (const BodyState& s : motion.state())
    EXPECT_NEAR(s.velocity.norm(), 0.0, 1e-15);
  EXPECT_NEAR(motion.state()[0].position.x(), -0.5, 1e-14);
  ASSERT_FALSE(motion.book().events.empty());
  EXPECT_NEAR(motion.book().events[0].t, 1.5, 1e-14);
  EXPECT_NEAR(motion.book().audit.impact_loss, 1.0, 1e-14);
}

TEST(IslandMotion, WhoIsFarAwayMovesAsIfItWereAlone) {
  Scene scene = meeting();
  SceneCube far = cube("far", {100.0, 0.0});
  far.spin = 2.0;
  far.velocity = {0.3, 0.1};
  scene.cubes.push_back(far);
  Scene alone;
  alone.gravity = Vec2::Zero();
  alone.cubes = {far};
  const Mechanism together(scene);
  const Mechanism single(alone);
  IslandMotion a(together.system, {}, together.state);
  IslandMotion b(single.system, {}, single.state);
  a.advance_to(2.0);
  b.advance_to(2.0);
  EXPECT_NEAR((a.state()[2].position - b.state()[0].position).norm(), 0.0, 1e-13);
  EXPECT_NEAR(a.state()[2].angle, b.state()[0].angle, 1e-14);
}

TEST(IslandMotion, LookingDoesNotChangeTheMotion) {
  const Mechanism m(meeting());
  IslandMotion seldom(m.system, {}, m.state);
  IslandMotion often(m.system, {}, m.state);
  for (int k = 1; k <= 40; ++k) {
    often.advance_to(0.05 * k);
    EXPECT_FALSE(often.state().empty());
  }
  seldom.advance_to(2.0);
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(seldom.state()[i].position, often.state()[i].position);
  EXPECT_EQ(seldom.book().events.size(), often.book().events.size());
}

TEST(IslandMotion, WhatRestsInStepsDoesNotBounce) {
  Scene scene = on_floor({cube("a", {0.0, 1.0}, 0.1)});
  scene.cubes[0].material = scene.planes[0].material = {.friction = 0.4, .restitution = 0.5};
  const Mechanism m(scene);
  MotionSettings settings;
  settings.integrator = Integrator::rattle;
  IslandMotion motion(m.system, settings, m.state);
  motion.advance_to(5.0);
  EXPECT_NEAR(motion.state()[0].position.y(), 0.5, 1e-9);
  // Else every step has it bounce, and takes its velocity and that much of the weight away again.
  EXPECT_LT(motion.book().audit.momentum_settled, 1e-9);
}

TEST(Track, KnowsItsStatesUntilTheyAreForgotten) {
  const Mechanism m(on_floor({cube("a", {0.0, 3.0})}));
  Track track(m.system, {}, policy_of({}));
  track.start(m.state, 0.0, 1e-9, {0}, {});
  while (track.clock() < 0.5)
    track.advance(0.5);
  EXPECT_NEAR(track.at(0.3)[0].position.y(), 3.0 - 0.5 * 9.81 * 0.09, 1e-13);
  EXPECT_EQ(track.at(track.clock())[0].position, track.state()[0].position);
  std::vector<BoundingBox> swept(1, {m.state[0].position, m.state[0].position});
  track.sweep(0.0, swept);
  EXPECT_LE(swept[0].low.y(), track.state()[0].position.y() - 0.7);
  EXPECT_GE(swept[0].high.y(), 3.7);
  track.forget_before(0.4);
  EXPECT_NEAR(track.at(0.45)[0].position.y(), 3.0 - 0.5 * 9.81 * 0.2025, 1e-13);
}

TEST(Track, RestEndsTheClock) {
  const Mechanism m(on_floor({cube("a", {0.0, 0.5})}));
  Track track(m.system, {}, policy_of({}));
  track.start(m.state, 0.0, 1e-9, {0}, {});
  EXPECT_TRUE(track.at_rest());
  track.advance(1.0);
  EXPECT_EQ(track.clock(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(track.at(7.0)[0].position, m.state[0].position);
}

TEST(Track, StepsAllTheTimeWhereThatIsTheChoice) {
  const Mechanism m(on_floor({cube("a", {0.0, 3.0})}));
  MotionSettings settings;
  settings.integrator = Integrator::rattle;
  settings.step = 0.02;
  Track track(m.system, settings, policy_of(settings));
  track.start(m.state, 0.0, 1e-9, {0}, {});
  EXPECT_GT(track.stepping().until, 1e300);
  track.advance(1.0);
  EXPECT_LE(track.clock(), 0.02 + 1e-15);
  EXPECT_TRUE(track.loaded_at(0.0).empty());
}

TEST(MotionPolicy, SaysWhatAnIntegratorMeans) {
  MotionSettings settings;
  settings.step = 0.125;
  settings.tolerance = 1e-8;
  const auto policy = [&](Integrator integrator) {
    settings.integrator = integrator;
    return policy_of(settings);
  };
  using Method = MotionPolicy::Method;
  EXPECT_EQ(policy(Integrator::automatic).method, Method::groups);
  EXPECT_EQ(policy(Integrator::automatic).step, 0.0);
  EXPECT_NEAR(policy(Integrator::automatic).allowed_error, 2e-3, 1e-18);
  EXPECT_TRUE(policy(Integrator::event).only_events);
  EXPECT_TRUE(policy(Integrator::rattle).only_steps);
  EXPECT_EQ(policy(Integrator::rattle).step, 0.125);
  EXPECT_NEAR(policy(Integrator::rattle).sway, 0.25e-4, 1e-19);
  EXPECT_EQ(policy(Integrator::moreau).method, Method::moreau);
  EXPECT_EQ(policy(Integrator::symplectic).method, Method::algorithm_1);
  EXPECT_FALSE(policy(Integrator::symplectic).as_printed);
  EXPECT_TRUE(policy(Integrator::euler).as_printed);
}

}  // namespace
}  // namespace wuerfel::test
