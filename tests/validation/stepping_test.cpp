// Time stepping: what its error control, its energy and its looks between steps promise.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/dynamics/momentum.h"
#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
#include "tests/support/bin_scene.h"
#include "tests/support/deepest_overlap.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

MotionSettings stepping(double step, double tolerance = 1e-8) {
  return {.integrator = Integrator::rattle, .tolerance = tolerance, .step = step};
}

double energy_of(const Simulation& simulation) { return simulation.snapshot({}).energy; }

/// Largest difference of places to the event driven motion at time t.
double error_of(const Scene& scene, const MotionSettings& settings, double t) {
  Simulation events(scene, {});
  Simulation steps(scene, settings);
  events.advance_to(t);
  steps.advance_to(t);
  double worst = 0.0;
  for (std::size_t i = 0; i < events.states().size(); ++i)
    worst = std::max(worst, (events.states()[i].position - steps.states()[i].position).norm());
  return worst;
}

TEST(Stepping, StepsFollowTheirError) {
  // A step of 1/30 s is halved as often as the tolerance asks for.
  const double loose = error_of(on_floor(leaning_tower(5, 0.3)), stepping(1.0 / 30.0, 1.0), 0.5);
  const double tight = error_of(on_floor(leaning_tower(5, 0.3)), stepping(1.0 / 30.0, 1e-10), 0.5);
  EXPECT_GT(loose, 1e-4);
  EXPECT_LT(tight, 0.1 * loose);
}

TEST(Stepping, EnergyRisesByNoMoreThanTheRootOfTheTolerance) {
  // Of all the energy that there is: it sways about its true value.
  for (const double step : {1.0 / 30.0, 1.0 / 60.0, 1.0 / 240.0}) {
    Simulation simulation(on_floor(leaning_tower(5, 0.3)), stepping(step));
    const double beginning = energy_of(simulation);
    for (int k = 1; k <= 150; ++k) {
      simulation.advance_to(0.01 * k);
      EXPECT_LE(energy_of(simulation), beginning * (1.0 + 1e-4)) << step << " at " << 0.01 * k;
    }
  }
}

TEST(Stepping, EnergyFallsByNoMoreThanItsBudget) {
  // Two cubes turn about each other after a blow at 40 m/s: every step takes a little.
  Scene scene;
  scene.cubes = {cube("a", {0.0, 0.5}), cube("bullet", {-6.0, 1.0})};
  scene.cubes[1].velocity = {40.0, 0.0};
  Simulation simulation(scene, stepping(1.0 / 240.0));
  for (int k = 1; k <= 25; ++k) {
    simulation.advance_to(0.01 * k);
    const Audit audit = simulation.audit();
    EXPECT_LE(std::abs(audit.drift()), audit.drift_budget) << "at " << 0.01 * k;
  }
}

// A floor of flush tiles is a floor.
TEST(Stepping, WhatSlidesOverSeamsKeepsItsVelocity) {
  for (const double height : {0.1, 0.5, 4.0}) {
    for (const double speed : {0.5, 3.0, 30.0}) {
      Scene scene;
      for (int i = 0; i < 12; ++i) {
        scene.fixed.push_back(
            {"tile" + std::to_string(i), {0.5, height}, {0.5 * i, -0.5 * height}, 0.0, {}});
      }
      SceneCube cube;
      cube.name = "slider";
      cube.size = {0.25, 0.25};
      cube.position = {0.3, 0.125};
      cube.velocity = {speed, 0.0};
      scene.cubes.push_back(cube);
      Simulation simulation(scene, stepping(1.0 / 240.0));
      simulation.advance_to(4.0 / speed);
      const BodyState& s = simulation.states()[0];
      EXPECT_NEAR(s.velocity.x(), speed, 1e-12 * speed) << height << " " << speed;
      EXPECT_NEAR(s.position.y(), 0.125, 1e-9);
      EXPECT_NEAR(s.angle, 0.0, 1e-9);
    }
  }
}

TEST(Stepping, CrowdsInSpaceKeepTheirMomentumAndTurning) {
  Scene scene;
  scene.gravity = Vec2::Zero();
  for (int k = 0; k < 36; ++k) {
    SceneCube cube;
    cube.name = "c" + std::to_string(k);
    cube.size = {0.35, 0.35};
    cube.mass = k % 3 == 0 ? 3.0 : 1.0;
    const int row = k / 6;
    cube.position = {0.8 * (k % 6), 0.8 * row};
    cube.velocity = {-0.5 * (cube.position.x() - 2.0), -0.5 * (cube.position.y() - 1.7)};
    cube.angle = 0.37 * k;
    cube.spin = (k % 5) - 2.0;
    scene.cubes.push_back(cube);
  }
  const System system = make_system(scene);
  std::vector<int> all(scene.cubes.size());
  std::iota(all.begin(), all.end(), 0);
  Simulation simulation(scene, {});
  const Momentum before = momentum_of(system, simulation.states(), all);
  double scale = 0.0;  // of the momenta of single cubes, some metres apart
  for (const SceneCube& cube : scene.cubes)
    scale += cube.mass * cube.velocity.norm();
  const double turning = before.angular + det(before.center, before.linear);
  for (int k = 1; k <= 30; ++k) {
    simulation.advance_to(0.1 * k);
    const Momentum now = momentum_of(system, simulation.states(), all);
    EXPECT_LE((now.linear - before.linear).norm(), 1e-11) << 0.1 * k;
    EXPECT_NEAR(now.angular + det(now.center, now.linear), turning, 1e-9 * scale) << 0.1 * k;
  }
  EXPECT_GT(simulation.cost().hand_overs, 0);
}

TEST(Stepping, AHeavyCubeIsNotLiftedByALightOneOnIt) {
  Scene scene = parse_scene(
      "version = 1\n[[plane]]\n[[cube]]\nposition = [0, 0.5]\nmass = 1e9\n"
      "[[cube]]\nposition = [0.3, 2.5]\nangle = 0.2\n",
      "light.toml");
  Simulation simulation(scene, {});
  simulation.advance_to(1.0);
  EXPECT_NEAR(simulation.states()[0].position.y(), 0.5, 2e-10);
}

/// Largest difference of velocities, m/s and rad/s, to the event driven motion at time t.
double velocity_error_of(const Scene& scene, double step, double t) {
  Simulation events(scene, {});
  Simulation steps(scene, stepping(step));
  events.advance_to(t);
  steps.advance_to(t);
  double worst = 0.0;
  for (std::size_t i = 0; i < events.states().size(); ++i) {
    const BodyState& a = events.states()[i];
    const BodyState& b = steps.states()[i];
    worst = std::max({worst, (a.velocity - b.velocity).norm(), std::abs(a.spin - b.spin)});
  }
  return worst;
}

// A box slides down a wall and strikes the floor: the wall holds it against the blow, and does no more than the impact law says,
// wherever in a step that happens.
TEST(Stepping, WhatHoldsAgainstABounceDoesNotPushBeyondIt) {
  for (const double friction : {0.0, 0.2, 0.6}) {
    const Scene scene = parse_scene(
        "version = 1\nmaterial = { friction = " + std::to_string(friction)
            + ", restitution = 0.5 }\n[[plane]]\n[[plane]]\npoint = [-2.5, 0.0]\nnormal = [1.0, 0.0]\n"
              "[[cube]]\nsize = [0.6751746883867202, 0.4358904857830988]\n"
              "position = [-2.1002062090951683, 1.1418912313295608]\nangle = -0.6739257014633959\n",
        "corner.toml");
    for (const double step : {0.002, 0.0005, 0.00025})
      EXPECT_LT(velocity_error_of(scene, step, 0.4), 0.03) << friction << " " << step;
  }
}

TEST(Stepping, PilesThatRubComeToRestByALawThatIsExact) {
  Scene scene = bin_scene(14, 4.0, 12.0, 2);
  for (SceneCube& cube : scene.cubes)
    cube.material.friction = 0.6;
  for (SceneFixed& fixed : scene.fixed)
    fixed.material.friction = 0.6;
  scene.planes[0].material.friction = 0.6;
  Simulation simulation(scene, {});
  simulation.advance_to(6.0);
  const State rest = simulation.states();
  simulation.advance_to(60.0);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    EXPECT_TRUE(rest[i].velocity.isZero(0.0));
    EXPECT_EQ(rest[i].position, simulation.states()[i].position);
    EXPECT_EQ(rest[i].angle, simulation.states()[i].angle);
  }
  EXPECT_LE(simulation.audit().friction_residual, 1e-6);
  EXPECT_LE(simulation.audit().max_overlap, 1e-9);
  EXPECT_GT(simulation.audit().friction_loss, 1.0);
}

TEST(Stepping, CrowdsGainNoEnergy) {
  // What there is and what impacts have taken is never more than there was.
  Simulation simulation(bin_scene(30, 6.0, 20.0, 1), {});
  for (int k = 1; k <= 200; ++k) {
    simulation.advance_to(0.0137 * k);
    const Audit audit = simulation.audit();
    EXPECT_LE(audit.drift(), 1e-9 * audit.energy_start) << "at " << 0.0137 * k;
  }
  EXPECT_GT(simulation.cost().hand_overs, 0);
}

TEST(Stepping, LooksBetweenStepsLeaveNoOverlap) {
  const Scene scene = bin_scene(12, 4.0, 14.0, 5);
  const System system = make_system(scene);
  Simulation simulation(scene, stepping(1.0 / 60.0));
  for (int k = 1; k <= 300; ++k) {
    simulation.advance_to(0.00737 * k);
    ASSERT_LE(deepest_overlap(system, simulation.states()), 1e-9) << "at " << 0.00737 * k;
  }
}

TEST(Stepping, ForcesBetweenStepsCarryTheWeight) {
  // A stack of three slides for ever: at every instant the floor carries it.
  const Scene scene = parse_scene(R"(
version = 1
[[plane]]
[[cube]]
velocity = [1, 0]
position = [0, 0.5]
[[cube]]
velocity = [1, 0]
position = [0.2, 1.5]
[[cube]]
velocity = [1, 0]
position = [0, 2.5]
)",
                                  "slide.toml");
  Simulation simulation(scene, stepping(1.0 / 60.0));
  for (int k = 1; k <= 20; ++k) {
    simulation.advance_to(0.0313 * k);
    const Snapshot snapshot = simulation.snapshot({.forces = true});
    double lift = 0.0;
    for (const SnapshotForce& arrow : snapshot.forces) {
      if (arrow.point.y() < 0.1) lift += arrow.force.y();
    }
    EXPECT_NEAR(lift, 3.0 * 9.81, 1e-6) << "at " << 0.0313 * k;
  }
}

TEST(Stepping, ImpactsAreTimedByTheGapTheyClose) {
  // A fall of half a metre: 0.3193 s, whatever the step.
  const Scene scene =
      parse_scene("version = 1\n[[plane]]\n[[cube]]\nposition = [0, 1]\n", "fall.toml");
  Simulation simulation(scene, stepping(1.0 / 60.0));
  simulation.advance_to(0.5);
  ASSERT_FALSE(simulation.events().empty());
  EXPECT_NEAR(simulation.events().front().t, std::sqrt(2.0 * 0.5 / 9.81), 1e-3);
}

}  // namespace
}  // namespace wuerfel::test
