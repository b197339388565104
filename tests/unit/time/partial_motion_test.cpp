// What moves while most of a group stands: as on fixed ground, and only as long as forces and impulses hold the others.
#include "core/time/partial_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/snapshot.h"
#include "core/time/simulation.h"
#include "tests/support/scenes.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

/// Flush columns of unit cubes, their left side at 0.
std::vector<SceneCube> wall(int columns, int rows) {
  std::vector<SceneCube> cubes(columns * rows);
  for (int k = 0; k < columns * rows; ++k) {
    const int row = k / columns;
    cubes[k] = cube("w" + std::to_string(k), {k - columns * row + 0.5, row + 0.5});
  }
  return cubes;
}

/// A cube by itself, over a fixed box of the size of the wall.
Scene alone_on_box(const SceneCube& mover, int columns, int rows) {
  Scene scene = on_floor({mover});
  scene.fixed.push_back(post("box", {0.5 * columns, 0.5 * rows}, Vec2(columns, rows)));
  return scene;
}

void expect_same(const BodyState& a, const BodyState& b, double error) {
  EXPECT_NEAR((a.position - b.position).norm(), 0.0, error);
  EXPECT_NEAR(a.angle, b.angle, error);
  EXPECT_NEAR((a.velocity - b.velocity).norm(), 0.0, 10.0 * error);
  EXPECT_NEAR(a.spin, b.spin, 10.0 * error);
}

/// A mover, mu of its contacts, over a wall, simulated beside the same over a box: it moves alike, and the wall not by a bit.
struct OverAWall {
  OverAWall(SceneCube mover, double mu) : scene(with_friction(on_floor(wall(4, 4)), 0.6)) {
    mover.material.friction = mu * mu / 0.6;
    Scene box = alone_on_box(mover, 4, 4);
    box.fixed.front().material.friction = 0.6;
    box.planes.front().material.friction = 0.6;
    on_box = std::make_unique<Simulation>(box, MotionSettings{});
    scene.cubes.push_back(mover);
    on_wall = std::make_unique<Simulation>(scene, MotionSettings{});
  }
  void expect_same_until(double t) {
    const State start = initial_state(scene);
    for (int k = 1; k <= 10; ++k) {
      on_wall->advance_to(0.1 * k * t);
      on_box->advance_to(0.1 * k * t);
      const State& state = on_wall->states();
      expect_same(state.back(), on_box->states().back(), 1e-10);  // what their steps allow
      for (std::size_t i = 0; i + 1 < state.size(); ++i) {
        EXPECT_EQ(state[i].position, start[i].position) << i;
        EXPECT_EQ(state[i].angle, start[i].angle) << i;
        EXPECT_TRUE(is_still(state[i])) << i;
      }
    }
    EXPECT_LE(on_wall->audit().momentum_settled, 1e-9);
  }

  Scene scene;
  std::unique_ptr<Simulation> on_box;
  std::unique_ptr<Simulation> on_wall;
};

TEST(PartialMotion, ACubeTipsFromAWallAsFromABox) {
  OverAWall tips(cube("a", {4.05, 4.5}), 0.6);
  tips.expect_same_until(0.6);
  EXPECT_LT(tips.on_wall->states().back().angle, -0.2);
}

TEST(PartialMotion, ACubeSlidesOverSeamsAsOverABox) {
  SceneCube slider = cube("a", {0.7, 4.5});
  slider.velocity = {4.0, 0.0};
  OverAWall slides(slider, 0.3);
  slides.expect_same_until(1.2);
  EXPECT_NEAR(slides.on_wall->states().back().position.x(), 0.7 + 4.0 * 1.2 - 0.15 * g * 1.44,
              1e-9);
}

//  +-----------------+
//  |      plank      |    It stands on a, and presses on b, which slides away under it.
//  +-----------------+
//   | a |       | b |->
TEST(PartialMotion, NothingSlidesUnderALoadAsWithoutIt) {
  Scene scene = on_floor(
      {cube("a", {0.0, 0.5}), cube("b", {4.0, 0.5}), sized_cube("plank", {2.0, 1.25}, {6.0, 0.5})});
  scene.cubes[1].velocity = {1.0, 0.0};
  scene.cubes[2].mass = 10.0;
  set_friction(0.2, scene);
  scene.cubes[0].material.friction = 3.2;  // 0.8 of each pair
  Simulation simulation(scene, {});
  simulation.advance_to(0.02);
  // Where the plank stands, b bears 10 g 1.5 / 4 at least, and rubs on both sides.
  const double least = 0.2 * (g + 2.0 * 10.0 * g * 1.5 / 4.0);
  EXPECT_LE(simulation.states()[1].velocity.x(), 1.0 - 0.02 * least);
}

TEST(PartialMotion, AWallWithstandsABlow) {
  // Without friction its impulses go straight down, and leave a column by the floor.
  SceneCube ball = cube("a", {1.66, 5.8}, 0.3);
  ball.size = Vec2(0.5, 0.5);
  OverAWall falls(ball, 0.0);
  falls.expect_same_until(0.7);
  EXPECT_GE(falls.on_wall->events().size(), 2U);
  EXPECT_EQ(falls.on_wall->events().front().kind, EventKind::impact);
}

TEST(PartialMotion, EndsWithABlowThatMovesWhatStood) {
  Scene scene = on_floor(wall(4, 4));
  SceneCube ball = cube("ball", {-1.0, 3.5}, 0.2);
  ball.velocity = {8.0, 0.0};
  scene.cubes.push_back(ball);
  Simulation simulation(with_friction(scene, 0.4), {});
  simulation.advance_to(0.5);
  EXPECT_GT(simulation.states()[12].position.x(), 0.6) << "the cube of the top row that was hit";
  EXPECT_NEAR((simulation.states()[0].position - Vec2(0.5, 0.5)).norm(), 0.0, 1e-5) << "below";
  EXPECT_LE(simulation.audit().momentum_linear, 1e-9);
  EXPECT_LE(simulation.audit().max_overlap, 1e-9);
}

/// A block slides along a plank that reaches out over the edge of a base, at x = 3 m + 3 m/s t - 0.15 g t^2. Friction brings its
/// weight forward by 0.3 times half its height, and turns the plank at the arm of its thickness, which is held until
///     2 kg (x + 0.075 m - 4 m) + 0.3 * 2 kg 0.2 m > 1 kg 0.1 m.
Scene plank() {
  Scene scene = on_floor(wall(12, 1));
  for (SceneCube& c : scene.cubes)
    c.position.x() -= 12.0;
  scene.cubes.push_back(sized_cube("base", {2.0, 1.5}, {4.0, 3.0}));
  scene.cubes.back().mass = 20.0;
  scene.cubes.push_back(sized_cube("plank", {3.9, 3.1}, {3.0, 0.2}));
  SceneCube block = sized_cube("block", {3.0, 3.45}, {0.5, 0.5});
  block.mass = 2.0;
  block.velocity = {3.0, 0.0};
  scene.cubes.push_back(block);
  return with_friction(scene, 0.3);
}

TEST(PartialMotion, EndsWhereForcesNoLongerHoldWhatStood) {
  Simulation simulation(plank(), {});
  const double slack = 0.15 * g;
  const double tips = (3.0 - std::sqrt(9.0 - 4.0 * slack * 0.915)) / (2.0 * slack);
  simulation.advance_to(tips - 0.06);
  EXPECT_TRUE(is_still(simulation.states()[13]));
  EXPECT_EQ(simulation.states()[13].angle, 0.0);
  simulation.advance_to(tips + 0.2);
  EXPECT_LT(simulation.states()[13].angle, -0.01);
  Simulation stepped(plank(), {.integrator = Integrator::rattle, .step = 5e-4});
  stepped.advance_to(tips + 0.2);
  expect_same(simulation.states()[13], stepped.states()[13], 1e-3);
}

/// A block that slides along a plank on a wall of columns, of which it pulls some along.
struct SlidingBlock {
  int columns, rows;
  double friction, plank, length, plank_mass, block, side, block_mass, speed;
};

Scene sliding_block(const SlidingBlock& of) {
  Scene scene = on_floor(wall(of.columns, of.rows));
  scene.cubes.push_back(sized_cube("plank", {of.plank, of.rows + 0.1}, {of.length, 0.2}));
  scene.cubes.back().mass = of.plank_mass;
  scene.cubes.push_back(
      sized_cube("block", {of.block, of.rows + 0.2 + 0.5 * of.side}, {of.side, of.side}));
  scene.cubes.back().mass = of.block_mass;
  scene.cubes.back().velocity = {of.speed, 0.0};
  return with_friction(scene, of.friction);
}

class StandingWall : public testing::TestWithParam<SlidingBlock> {};

/// Friction has several solutions here: what is looked at takes the one that the motion goes by.
TEST_P(StandingWall, DoesNotAccelerateWhereItStands) {
  Simulation simulation(sliding_block(GetParam()), {});
  int stood = 0;
  for (int k = 1; k < 30; ++k) {
    simulation.advance_to(k / 30.0);
    const State before = simulation.states();
    const Snapshot seen = simulation.snapshot({.forces = true, .accelerations = true});
    simulation.advance_to((k + 1) / 30.0);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const BodyState& after = simulation.states()[i];
      if (!is_still(before[i]) || !is_still(after) || before[i].position != after.position)
        continue;
      ++stood;
      EXPECT_LE(seen.boxes[i].acceleration.norm(), 1e-8) << i << " at " << k / 30.0;
    }
  }
  EXPECT_GT(stood, 100);
  EXPECT_EQ(simulation.audit().friction_inexact, 0);
}

INSTANTIATE_TEST_SUITE_P(
    PartialMotion,
    StandingWall,
    testing::Values(SlidingBlock{4, 2, 0.2, 0.9958, 1.5238, 0.2, 0.9896, 0.5, 10.0, -2.2347},
                    SlidingBlock{6, 4, 0.3, 5.8365, 2.454, 0.2, 6.7748, 0.5, 2.0, -1.3638},
                    SlidingBlock{4, 4, 0.5, 1.9981, 2.4049, 1.0, 1.9737, 0.3, 10.0, 2.6516},
                    SlidingBlock{3, 4, 0.5, 2.0195, 2.4243, 3.0, 2.5021, 0.5, 10.0, -2.9545}));

TEST(PartialMotion, IsNotLookedForWhereManyMove) {
  Scene scene = with_friction(on_floor(wall(4, 4)), 0.5);
  const System system = make_system(scene);
  State state = initial_state(scene);
  EXPECT_TRUE(PartialMotion::few_move(system, state));
  for (int i = 0; i < 6; ++i)
    state[i].velocity = {1.0, 0.0};
  EXPECT_TRUE(PartialMotion::few_move(system, state));
  state[6].velocity = {1.0, 0.0};
  EXPECT_FALSE(PartialMotion::few_move(system, state));
}

class Found : public testing::Test {
 protected:
  std::unique_ptr<PartialMotion> find(const Scene& scene) {
    system = make_system(scene);
    work = std::make_unique<Workspace>(system, MotionSettings{});
    return PartialMotion::find(initial_state(scene), 0.0, touching_tolerance, {}, policy_of({}),
                               *work);
  }
  System system;
  std::unique_ptr<Workspace> work;
};

TEST_F(Found, NoneWhereAllStandOrABlowIsDue) {
  EXPECT_EQ(find(with_friction(on_floor(wall(4, 4)), 0.5)), nullptr);
  Scene scene = on_floor(wall(4, 4));
  SceneCube ball = cube("ball", {1.5, 4.5});
  ball.velocity = {0.0, -1.0};
  scene.cubes.push_back(ball);
  EXPECT_EQ(find(with_friction(scene, 0.5)), nullptr);
}

TEST_F(Found, WhatRodsJoinToACubeThatMovesMovesWithIt) {
  Scene scene = on_floor(wall(4, 4));
  scene.cubes.push_back(cube("ball", {3.5, 6.5}));
  scene.rods.push_back({"rod", {"ball", Vec2::Zero()}, {"w14", Vec2::Zero()}, std::sqrt(10.0)});
  const std::unique_ptr<PartialMotion> part = find(with_friction(scene, 0.5));
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->resting()[16], 0);
  EXPECT_EQ(part->resting()[14], 0) << "the cube that it is tied to";
  EXPECT_EQ(part->resting()[13], 1);
}

TEST_F(Found, OnlyWhatMovesSweeps) {
  Scene scene = on_floor(wall(4, 4));
  scene.cubes.push_back(cube("a", {4.05, 4.5}));
  const std::unique_ptr<PartialMotion> part = find(with_friction(scene, 0.6));
  ASSERT_NE(part, nullptr);
  Bookkeeping book;
  while (part->clock() < 0.5) {
    part->advance(0.5, book);
    ASSERT_TRUE(part->goes_on());
  }
  EXPECT_GT(book.cost.steps, 0);
  EXPECT_EQ(part->at(0.0).back().position, Vec2(4.05, 4.5));
  EXPECT_EQ(part->at(part->clock()).back().position, part->state().back().position);
  std::vector<BoundingBox> swept(17, {Vec2::Constant(50.0), Vec2::Constant(-50.0)});
  part->sweep(0.0, swept);
  EXPECT_EQ(swept[0].low.x(), 50.0);
  EXPECT_LT(swept[16].low.y(), 4.0);
  EXPECT_GT(swept[16].high.y(), 5.0);
}

}  // namespace
}  // namespace wuerfel::test
