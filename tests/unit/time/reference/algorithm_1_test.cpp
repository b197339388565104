// One step of Algorithm 1, by hand.
#include "core/time/reference/algorithm_1.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/grid_steps.h"

namespace wuerfel::test {
namespace {

TEST(Algorithm1, TakesTheOldVelocityAsPrintedOrTheNewOne) {
  for (const Integrator integrator : {Integrator::euler, Integrator::symplectic}) {
    Bookkeeping book;
    const BodyState s = one_step(turning_flight(), integrator, Formulation::rigid, book);
    const double v_y = integrator == Integrator::euler ? 1.0 : 1.0 - g * dt;
    EXPECT_NEAR(s.position.x(), 1.0 + 3.0 * dt, rounding);
    EXPECT_NEAR(s.position.y(), 10.0 + v_y * dt, 10.0 * rounding);
    EXPECT_NEAR(s.velocity.y(), 1.0 - g * dt, rounding);
    EXPECT_NEAR(s.angle, 0.25 + 2.0 * dt, rounding);
    EXPECT_EQ(s.spin, 2.0);
    EXPECT_EQ(book.cost.qp_solves, 0);
    EXPECT_EQ(book.cost.skipped_free, 1);
  }
}

TEST(Algorithm1, PointsStepAlongTheirTangentsAndAreMadeACubeAgain) {
  // A point at r goes to r + omega dt perp(r): turned by atan(omega dt). The velocities there,
  // omega perp(r) - omega^2 dt r, have the spin omega sqrt(1 + (omega dt)^2).
  Bookkeeping book;
  const BodyState s = one_step(turning_flight(), Integrator::euler, Formulation::points, book);
  EXPECT_NEAR(s.angle, 0.25 + std::atan(2.0 * dt), rounding);
  EXPECT_NEAR(s.spin, 2.0 * std::sqrt(1.0 + 4.0 * dt * dt), 4.0 * rounding);
  EXPECT_NEAR(s.position.x(), 1.0 + 3.0 * dt, rounding);
}

TEST(Algorithm1, WhatSlidesOnTheFloorStaysOnIt) {
  Scene scene = on_floor({cube("a", {0.0, 0.5})});
  scene.cubes[0].velocity = {1.0, 0.0};
  for (const Formulation formulation : {Formulation::rigid, Formulation::points}) {
    Bookkeeping book;
    const BodyState s = one_step(scene, Integrator::euler, formulation, book);
    EXPECT_NEAR(s.position.x(), dt, 1e-13);
    EXPECT_NEAR(s.position.y(), 0.5, 1e-11);
    EXPECT_NEAR(s.velocity.x(), 1.0, 1e-13);
    EXPECT_NEAR(s.velocity.y(), 0.0, 1e-11);
    EXPECT_TRUE(book.events.empty());
  }
}

TEST(Algorithm1, WhatHitsTheFloorIsStoppedAtTheStart) {
  Scene scene = on_floor({cube("a", {0.0, 0.5})});
  scene.cubes[0].velocity = {1.0, -2.0};
  Bookkeeping book;
  const BodyState s = one_step(scene, Integrator::euler, Formulation::rigid, book);
  EXPECT_NEAR(s.velocity.y(), 0.0, 1e-12);
  EXPECT_NEAR(book.audit.impact_loss, 2.0, 1e-12);  // m v^2 / 2
  ASSERT_EQ(book.events.size(), 2U);
  EXPECT_NEAR(book.events[0].impulse + book.events[1].impulse, 2.0, 1e-12);
}

}  // namespace
}  // namespace wuerfel::test
