// One step of Moreau's, by hand, and rest.
#include "core/time/reference/moreau.h"

#include <gtest/gtest.h>

#include "core/time/simulation.h"
#include "tests/support/grid_steps.h"

namespace wuerfel::test {
namespace {

TEST(Moreau, FallsWithTheNewVelocityAndStopsAtTheFloor) {
  Bookkeeping book;
  const BodyState free = one_step(turning_flight(), Integrator::moreau, Formulation::rigid, book);
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
  Simulation simulation(shipped_scene("truss_bridge"), {.integrator = Integrator::moreau});
  simulation.advance_to(4.0);
  EXPECT_GE(simulation.cost().skipped_rest, 900);
  EXPECT_LE(simulation.cost().qp_solves, 200);
}

}  // namespace
}  // namespace wuerfel::test
