// Motions with friction and restitution that have exact answers.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/time/simulation.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

/// A unit cube on an incline that rises to the right by `angle`, on its way up with `speed`.
Scene on_incline(double friction, double angle, double speed) {
  const Vec2 normal(-std::sin(angle), std::cos(angle));
  Scene scene;
  scene.cubes = {cube("a", 0.5 * normal, angle, 0.0)};
  scene.cubes[0].velocity = -speed * perp(normal);
  scene.planes = {{"floor", Vec2::Zero(), normal, {friction, 0.0}}};
  scene.cubes[0].material = scene.planes[0].material;
  return scene;
}

long count(const std::vector<Event>& events, EventKind kind) {
  return std::ranges::count(events, kind, &Event::kind);
}

TEST(Incline, HoldsACubeExactlyBelowTheAngleOfFriction) {
  const double angle = 0.3;
  Simulation simulation(on_incline(std::tan(angle) * (1.0 + 1e-6), angle, 0.0), {});
  const Vec2 start = simulation.states()[0].position;
  simulation.advance_to(100.0);
  EXPECT_EQ(simulation.states()[0].position, start);
  EXPECT_EQ(simulation.states()[0].angle, angle);
}

TEST(Incline, LetsACubeSlideAboveTheAngleOfFriction) {
  const double angle = 0.3;
  const double friction = 0.9 * std::tan(angle);
  Simulation simulation(on_incline(friction, angle, 0.0), {});
  const Vec2 start = simulation.states()[0].position;
  simulation.advance_to(1.0);
  const double a = g * (std::sin(angle) - friction * std::cos(angle));
  EXPECT_NEAR((simulation.states()[0].position - start).norm(), 0.5 * a, 1e-10);
}

TEST(Incline, ReversesASlipUphill) {
  const double angle = 0.3;
  const double friction = 0.2;
  const double speed = 2.0;
  Simulation simulation(on_incline(friction, angle, speed), {});
  simulation.advance_to(1.0);
  const double up = g * (std::sin(angle) + friction * std::cos(angle));
  const double down = g * (std::sin(angle) - friction * std::cos(angle));
  const double t = speed / up;
  ASSERT_EQ(simulation.events().size(), 1);
  EXPECT_EQ(simulation.events()[0].kind, EventKind::slip);
  EXPECT_NEAR(simulation.events()[0].t, t, 1e-10);
  EXPECT_NEAR(simulation.states()[0].velocity.norm(), down * (1.0 - t), 1e-9);
}

TEST(Incline, StopsASlipUphillWhereItHolds) {
  const double angle = 0.3;
  const double friction = 0.4;
  Simulation simulation(on_incline(friction, angle, 1.0), {});
  simulation.advance_to(1.0);
  const double up = g * (std::sin(angle) + friction * std::cos(angle));
  ASSERT_EQ(count(simulation.events(), EventKind::rest), 1);
  EXPECT_NEAR(simulation.events().back().t, 1.0 / up, 1e-10);
  EXPECT_TRUE(simulation.states()[0].velocity.isZero(0.0));
}

TEST(Sliding, TakesNothingWhereNothingPresses) {
  //        ^ 3 m/s
  // +---+---+---+    the outer ones stand and rub the floor: forces that squeeze the middle one would balance, too
  // | a | b | c |
  // ~~~~~~~~~~~~~
  Scene scene = on_floor({cube("a", {0.0, 0.5}), cube("b", {1.0, 0.5}), cube("c", {2.0, 0.5})});
  scene.planes[0].material = {1.0, 0.0};
  for (SceneCube& c : scene.cubes)
    c.material = scene.planes[0].material;
  scene.cubes[1].velocity.y() = 3.0;
  Simulation simulation(scene, {});
  for (const double t : {0.2, 0.3, 0.5}) {
    simulation.advance_to(t);
    EXPECT_NEAR(simulation.states()[1].velocity.y(), 3.0 - g * t, 1e-12);
    EXPECT_NEAR(simulation.audit().friction_loss, 0.0, 1e-12);
  }
}

TEST(Bouncing, EndsWhenItsSeriesDoes) {
  Scene scene;
  scene.cubes = {cube("a", {0.0, 1.5}, 0.0, 0.0)};
  scene.planes = {{"floor", Vec2::Zero(), Vec2::UnitY(), {0.0, 0.5}}};
  scene.cubes[0].material = scene.planes[0].material;
  Simulation simulation(scene, {});
  simulation.advance_to(3.0);
  // One fall, and rises and falls that last twice as long, half as long from bounce to bounce.
  const double fall = std::sqrt(2.0 / g);
  EXPECT_NEAR(simulation.events().back().t, fall * (1.0 + 2.0), 1e-9);
  EXPECT_NEAR(simulation.states()[0].position.y(), 0.5, 1e-9);
}

}  // namespace
}  // namespace wuerfel::test
