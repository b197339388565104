// One step of Algorithm 1, and of Moreau's, by hand.
#include "core/time/reference/algorithm_1.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/time/reference/active_restrictions.h"
#include "core/time/reference/moreau.h"
#include "core/time/simulation.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

constexpr double g = 9.81;
constexpr double dt = 0.125;
constexpr double rounding = 1e-15;

BodyState one_step(const Scene& scene,
                   Integrator integrator,
                   Formulation formulation,
                   Bookkeeping& book) {
  const System system = make_system(scene);
  MotionSettings settings;
  settings.formulation = formulation;
  Workspace work(system, settings);
  GridPoint point;
  point.state = initial_state(scene);
  find_restrictions(point, work, book);
  if (integrator == Integrator::moreau) {
    step_by_moreau(point, dt, work, book);
  } else {
    step_by_algorithm_1(point, dt, integrator == Integrator::euler, work, book);
  }
  EXPECT_EQ(point.t, dt);
  return point.state[0];
}

Scene flying() {
  Scene scene;
  scene.cubes = {cube("a", {1.0, 10.0}, 0.25, 2.0)};
  scene.cubes[0].velocity = {3.0, 1.0};
  return scene;
}

TEST(Algorithm1, TakesTheOldVelocityAsPrintedOrTheNewOne) {
  for (const Integrator integrator : {Integrator::euler, Integrator::symplectic}) {
    Bookkeeping book;
    const BodyState s = one_step(flying(), integrator, Formulation::rigid, book);
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
  const BodyState s = one_step(flying(), Integrator::euler, Formulation::points, book);
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

TEST(Moreau, FallsWithTheNewVelocityAndStopsAtTheFloor) {
  Bookkeeping book;
  const BodyState free = one_step(flying(), Integrator::moreau, Formulation::rigid, book);
  EXPECT_NEAR(free.velocity.y(), 1.0 - g * dt, rounding);
  EXPECT_NEAR(free.position.y(), 10.0 + (1.0 - g * dt) * dt, 10.0 * rounding);
  Scene scene = on_floor({cube("a", {0.0, 0.5})});
  scene.cubes[0].velocity = {1.0, 0.0};
  const BodyState held = one_step(scene, Integrator::moreau, Formulation::rigid, book);
  EXPECT_NEAR(held.velocity.y(), 0.0, 1e-12);
  EXPECT_NEAR(held.position.x(), dt, 1e-13);
}

// A bridge of bodies, points and rods whose velocities are rounding half a second after a cube has fallen on it.
TEST(Moreau, WhatHasPointsComesToRest) {
  MotionSettings settings;
  settings.integrator = Integrator::moreau;
  Simulation simulation(shipped_scene("truss_bridge"), settings);
  simulation.advance_to(4.0);
  EXPECT_GE(simulation.cost().skipped_rest, 900);
  EXPECT_LE(simulation.cost().qp_solves, 200);
}

}  // namespace
}  // namespace wuerfel::test
