// Groups of cubes: who moves with whom, and that nobody else notices.
#include "core/time/island_motion.h"

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
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
  IslandMotion motion(m.system, {.integrator = Integrator::rattle}, m.state);
  motion.advance_to(5.0);
  EXPECT_NEAR(motion.state()[0].position.y(), 0.5, 1e-9);
  // Else every step has it bounce, and takes its velocity and that much of the weight away again.
  EXPECT_LT(motion.book().audit.momentum_settled, 1e-9);
}

TEST(IslandMotion, BooksNothingTwiceWhereAWindowIsCutShort) {
  // Two that spin about each other take a thousand steps before the window is over in which a falls; then b has come near it.
  Scene scene = parse_scene(R"(
material = { restitution = 0.5 }
plane = [{ name = "floor" }]
cube = [{ name = "a", position = [0, 1], velocity = [3, 0] }, { name = "b", position = [2, 3] },
        { name = "c", size = [1, 0.5], mass = 10, position = [20, 40], spin = -400 },
        { name = "d", size = [1, 0.5], position = [23, 42] }]
rod = [{ from = "d.w", to = "c.se" }]
)",
                            "spinners.toml");
  Simulation simulation(scene, {});
  simulation.advance_to(1.5);
  EXPECT_NEAR(simulation.audit().drift(), 0.0, 1e-5);
}

}  // namespace
}  // namespace wuerfel::test
