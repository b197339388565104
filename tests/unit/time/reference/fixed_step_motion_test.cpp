// Steps of one length: grid times, looks between them, and what is promised.
#include "core/time/reference/fixed_step_motion.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

TEST(FixedStepMotion, LooksBetweenGridTimesAreStepsAside) {
  const Mechanism m(on_floor({sized_cube("a", {0.0, 1.2}, Vec2::Ones(), 0.2)}));
  const MotionSettings settings{.integrator = Integrator::symplectic, .step = 0.01};
  FixedStepMotion seldom(m.system, settings, m.state);
  FixedStepMotion often(m.system, settings, m.state);
  for (int k = 1; k <= 100; ++k) {
    often.advance_to(0.004 * k);
    EXPECT_FALSE(often.state().empty());
  }
  seldom.advance_to(0.4);
  EXPECT_EQ(seldom.state()[0].position, often.state()[0].position);
  EXPECT_EQ(seldom.state()[0].angle, often.state()[0].angle);
  EXPECT_EQ(seldom.book().cost.steps, 40);
  EXPECT_EQ(often.book().cost.steps, 40);
}

TEST(FixedStepMotion, BetweenGridTimesTheFallGoesOn) {
  const Mechanism m(on_floor({cube("a", {0.0, 9.0})}));
  FixedStepMotion motion(m.system, {.integrator = Integrator::symplectic, .step = 0.125}, m.state);
  motion.advance_to(0.1875);
  // One whole step and a half one, each with the new velocity.
  const double v_1 = -9.81 * 0.125;
  const double v_2 = v_1 - 9.81 * 0.0625;
  EXPECT_NEAR(motion.state()[0].velocity.y(), v_2, 1e-14);
  EXPECT_NEAR(motion.state()[0].position.y(), 9.0 + 0.125 * v_1 + 0.0625 * v_2, 1e-14);
}

TEST(FixedStepMotion, RestsWhereNothingChangesButTheTime) {
  const Mechanism m(on_floor(tower(3)));
  for (const Integrator integrator : {Integrator::symplectic, Integrator::moreau}) {
    FixedStepMotion motion(m.system, {.integrator = integrator, .step = 0.01}, m.state);
    motion.advance_to(1.0);
    EXPECT_EQ(motion.book().cost.steps, 100);
    EXPECT_GE(motion.book().cost.skipped_rest, 98);
    EXPECT_LE(motion.book().cost.qp_solves, 4);
    EXPECT_EQ(motion.state()[2].position, m.state[2].position);
  }
}

TEST(FixedStepMotion, WhatRunsAwayEndsWithWhatToDo) {
  Scene scene;
  scene.gravity = {0.0, -1e30};
  scene.cubes = {cube("a", {0.0, 0.0})};
  const Mechanism m(scene);
  FixedStepMotion motion(m.system, {.integrator = Integrator::euler, .step = 1e8}, m.state);
  EXPECT_THROW(motion.advance_to(1e10), SolverError);
}

}  // namespace
}  // namespace wuerfel::test
