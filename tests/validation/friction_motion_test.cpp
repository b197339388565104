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

// | +----------+
// |/|    b     |     A block that leans on a rough wall, and a sled that slides away under it, as if the block had no weight where
// | +----------+     forces of least squares were asked, which pull at the wall.
// | <- |   sled   |
TEST(Sliding, AccelerationsOfManyForcesAreThoseOfSomeThatTheLawAllows) {
  const double mu = 0.7;
  Scene scene = with_friction(on_floor({sized_cube("sled", {1.7, 0.13}, {2.4, 0.26}),
                                        sized_cube("b", {1.0, 0.51}, {2.0, 0.5})}),
                              mu);
  scene.planes[0].material.friction = 0.0;
  scene.planes.push_back({"wall", Vec2::Zero(), Vec2::UnitX(), {mu, 0.0}});
  scene.cubes[0].velocity = {-3.0, 0.0};
  scene.cubes[1].mass = 3.0;
  Simulation simulation(scene, {});
  simulation.advance_to(0.02);
  // The wall takes mu N, of which its friction, up or down, takes mu^2 N at most.
  const double a = (simulation.states()[0].velocity.x() + 3.0) / 0.02;
  EXPECT_GE(a, mu * 3.0 * g / (1.0 + mu * mu));
  EXPECT_LE(a, mu * 3.0 * g / (1.0 - mu * mu));
  EXPECT_TRUE(simulation.states()[1].velocity.isZero(1e-9));
}

//        +--t--+        s pushes d away under t, whose other contacts depend on one another: t tips where what bears it, friction's
// +-s-+--d---+          moment counted, is past the end of d.
TEST(Sliding, TipsAtTheEndOfWhatSlidesAwayBelow) {
  constexpr double mu = 0.2;
  const Vec2 d(0.6012218806916816, 0.5448980042490169);
  const Vec2 t(0.5590352742325029, 0.35128913477095974);
  const Vec2 s(0.5, 0.33631081928057255);
  Scene scene =
      with_friction(on_floor({sized_cube("d", 0.5 * d, d),
                              sized_cube("t", {0.3099011306819295, d.y() + 0.5 * t.y()}, t),
                              sized_cube("s", {-2.0, 0.5 * s.y()}, s)}),
                    mu);
  scene.cubes[0].mass = 0.6925766643013042;
  scene.cubes[1].mass = 0.3645954683935056;
  scene.cubes[2].mass = 1.1862132503515797;
  scene.cubes[2].velocity = {4.167371291654968, 0.0};
  Simulation simulation(scene, {});
  int upright = 0;
  for (int k = 0; k < 40; ++k) {
    simulation.advance_to(0.55 + 0.005 * k);
    const BodyState& below = simulation.states()[0];
    const BodyState& on_top = simulation.states()[1];
    const bool slides = below.velocity.x() > on_top.velocity.x() + 1e-3;
    if (!slides || std::abs(on_top.angle) > 1e-9 || std::abs(on_top.spin) > 1e-9) continue;
    ++upright;
    EXPECT_LE(below.position.x() - 0.5 * d.x(), on_top.position.x() - 0.5 * mu * t.y() + 1e-9);
  }
  EXPECT_GT(upright, 5);
  EXPECT_GT(std::abs(simulation.states()[1].angle), 0.01);
}

// A corner that stays closed slips, whatever the other one of its side, which opens, is called.
TEST(Rocking, MirrorsItself) {
  for (const double friction : {0.05, 0.1, 0.2}) {
    Scene scene =
        with_friction(on_floor({sized_cube("a", Vec2::Zero(), {1.0, 2.0}, 0.05)}), friction);
    scene.cubes[0].position.y() = 0.5 * std::sin(0.05) + std::cos(0.05);
    Simulation one(scene, {});
    Simulation other(mirrored(scene), {});
    for (int k = 1; k <= 20; ++k) {
      one.advance_to(0.02 * k);
      other.advance_to(0.02 * k);
      const BodyState& a = one.states()[0];
      const BodyState& b = other.states()[0];
      EXPECT_NEAR(a.position.x(), -b.position.x(), 1e-10) << friction << ' ' << k;
      EXPECT_NEAR(a.position.y(), b.position.y(), 1e-10);
      EXPECT_NEAR(a.angle, -b.angle, 1e-10);
    }
    if (friction == 0.1) {
      EXPECT_NEAR(one.states()[0].position.x(), 0.0154068890632, 1e-9);  // it has come to rest
    }
  }
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

// Friction stops the cube along the incline before its bounces are over, or lets it go on: the end of the series is the same, even
// where the last bounces are as low as what counts as touching.
TEST(Bouncing, OnAnInclineEndsWhenItsSeriesDoes) {
  for (const double friction : {0.0, 0.1, 0.6}) {
    for (const double restitution : {0.2, 0.3, 0.5, 0.8}) {
      Scene scene = on_incline(friction, 0.3, 1.5);
      const Vec2 normal = scene.planes[0].normal;
      scene.cubes[0].position += 0.5 * normal;
      scene.cubes[0].material.restitution = restitution;
      scene.planes[0].material.restitution = restitution;
      Simulation simulation(scene, {});
      const double fall = std::sqrt(2.0 * 0.5 / (g * normal.y()));
      const double end = fall * (1.0 + 2.0 * restitution / (1.0 - restitution));
      simulation.advance_to(end + 0.01);
      EXPECT_NEAR(simulation.events().back().t, end, 1e-9) << friction << " " << restitution;
      EXPECT_EQ(count(simulation.events(), EventKind::rest), friction > std::tan(0.3) ? 1 : 0);
    }
  }
}

}  // namespace
}  // namespace wuerfel::test
