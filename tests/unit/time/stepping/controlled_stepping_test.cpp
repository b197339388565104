// Steps that follow their error, and looks between them.
#include "core/time/stepping/controlled_stepping.h"

#include <gtest/gtest.h>

#include "core/time/stepping/step_look.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

Scene flying() {
  Scene scene;
  scene.cubes = {cube("a", {0.0, 50.0})};
  scene.cubes[0].velocity = {1.0, 2.0};
  return scene;
}

TEST(ControlledStepping, StepsGrowWhereTheyAreEasyAndEndWhereTheyShould) {
  const Mechanism m(flying());
  ControlledStepping stepping(m.system, {}, policy_of({}));
  stepping.begin(m.state, 0.001, 0.01);
  Bookkeeping book;
  double t = 0.0;
  double longest = 0.0;
  while (t < 0.1) {
    const double next = stepping.advance(t, 0.1, book);
    ASSERT_GT(next, t);
    longest = std::max(longest, next - t);
    t = next;
  }
  EXPECT_EQ(t, 0.1);
  EXPECT_NEAR(longest, 0.01, 1e-15);
  EXPECT_NEAR(stepping.state()[0].position.y(), 50.2 - 0.5 * 9.81 * 0.01, 1e-13);
  EXPECT_FALSE(is_slower_than(m.system, stepping.state(), 1.0));
  EXPECT_TRUE(is_slower_than(m.system, stepping.state(), 2.0));
}

TEST(ControlledStepping, NothingHappensInATimeTooShortForAStep) {
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.005, 0.0})};
  scene.cubes[0].velocity = {1.0, 0.0};
  const Mechanism m(scene);
  ControlledStepping stepping(m.system, {}, policy_of({}));
  const double moment = 1e-9;
  const auto expect_nothing = [&](double t) {
    Bookkeeping book;
    EXPECT_EQ(stepping.advance(t, t + moment, book), t + moment);
    ASSERT_NE(stepping.record(), nullptr);
    EXPECT_TRUE(stepping.record()->impulses.empty());
    const State& end = stepping.state();
    const State look = StepLook(m.system, {}).at(end, end, moment, 0.5, *stepping.record());
    EXPECT_EQ(look[0].velocity, end[0].velocity);
  };
  stepping.begin(m.state, 0.01, 0.01);
  expect_nothing(0.0);
  Bookkeeping book;
  EXPECT_EQ(stepping.advance(0.0, 0.01, book), 0.01);
  EXPECT_FALSE(stepping.record()->impulses.empty());
  expect_nothing(0.01);
}

TEST(StepLook, InFreeFlightItIsTheParabola) {
  const Mechanism m(flying());
  RattleStepper stepper(m.system, {}, 0.0);
  stepper.begin(m.state);
  const double h = 0.1;
  const Step step = stepper.step(m.state, 0.0, h);
  StepLook look(m.system, {});
  for (const double share : {0.25, 0.5, 0.9}) {
    const double t = share * h;
    const State s = look.at(m.state, step.state, h, share, *step.record);
    EXPECT_NEAR(s[0].position.x(), t, 1e-14);
    EXPECT_NEAR(s[0].position.y(), 50.0 + 2.0 * t - 0.5 * 9.81 * t * t, 1e-13);
    EXPECT_NEAR(s[0].velocity.y(), 2.0 - 9.81 * t, 1e-13);
  }
}

TEST(StepLook, WhatIsStruckFliesOnUntilItIs) {
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.005, 0.0})};
  scene.cubes[0].velocity = {1.0, 0.0};
  const Mechanism m(scene);
  RattleStepper stepper(m.system, {}, 0.0);
  stepper.begin(m.state);
  const double h = 0.01;
  const Step step = stepper.step(m.state, 0.0, h);
  StepLook look(m.system, {});
  const State before = look.at(m.state, step.state, h, 0.25, *step.record);
  EXPECT_NEAR(before[0].position.x(), 0.0025, 1e-9);
  EXPECT_NEAR(before[0].velocity.x(), 1.0, 1e-12);
  EXPECT_NEAR(before[1].velocity.x(), 0.0, 1e-12);
  const State after = look.at(m.state, step.state, h, 0.75, *step.record);
  EXPECT_NEAR(after[0].position.x(), 0.005 + 0.00125, 1e-9);
  EXPECT_NEAR(after[0].velocity.x(), 0.5, 1e-12);
  EXPECT_NEAR(after[1].velocity.x(), 0.5, 1e-12);
}

}  // namespace
}  // namespace wuerfel::test
