// Motion with rods and pins against closed forms and a reference of 28 digits.
#include <cmath>
#include <string>
#include <tuple>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
#include "tests/support/parameter_names.h"
#include "tests/support/scenes.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

Simulation simulation_of(const std::string& text, const MotionSettings& settings = {}) {
  return {parse_scene(text, "s.toml"), settings};
}

TEST(Dumbbell, ThrownItsCentreFallsOnItsParabolaAndItTurnsEvenly) {
  const std::string text =
      "point = [{name = \"a\", mass = 1, position = [0, 0], velocity = [2, 3]},"
      "         {name = \"b\", mass = 3, position = [1, 0], velocity = [2, 7]}]\n"
      "rod = [{name = \"bar\", from = \"a\", to = \"b\"}]\n";
  Simulation simulation = simulation_of(text);
  const double t = 1.7;
  simulation.advance_to(t);
  const State& s = simulation.states();
  const Vec2 center = 0.25 * (s[0].position + 3.0 * s[1].position);
  EXPECT_NEAR((center - Vec2(0.75 + 2.0 * t, 6.0 * t - 0.5 * g * t * t)).norm(), 0.0, 1e-11);
  const Vec2 bar = s[1].position - s[0].position;
  // Its angle is as exact as the tolerance, its spin as rounding.
  EXPECT_NEAR((bar - Vec2(std::cos(4.0 * t), std::sin(4.0 * t))).norm(), 0.0, 1e-9);
  EXPECT_NEAR(det(bar, s[1].velocity - s[0].velocity), 4.0, 1e-13);
  const Audit audit = simulation.audit();
  EXPECT_LE(audit.momentum_linear, 1e-14);
  EXPECT_LE(audit.momentum_angular, 1e-14);
  // Tension of the reduced mass.
  EXPECT_NEAR(simulation.snapshot({.forces = true}).links[0].tension, 0.75 * 16.0, 1e-7);
  EXPECT_TRUE(simulation.events().empty());
}

TEST(Linkage, ThrownItKeepsItsMomentaToRounding) {
  // Two bars on a pin, a point on a rod, turning against each other.
  const std::string text =
      "cube = [{name = \"a\", size = [1, 0.2], position = [0.5, 0], velocity = [1, 4], spin = 3},"
      "        {name = \"b\", size = [1, 0.2], position = [1.5, 0], velocity = [1, 5.5], mass = "
      "2}]\n"
      "point = [{name = \"p\", position = [2, -1], velocity = [2, 5.5], mass = 0.5}]\n"
      "pin = [{from = \"a.e\", to = \"b.w\"}]\n"
      "rod = [{from = \"b.e\", to = \"p\"}]\n";
  Simulation simulation = simulation_of(text);
  const auto momenta = [&] {
    const State& s = simulation.states();
    const double mass[3] = {1.0, 2.0, 0.5};
    const double inertia[3] = {1.04 / 12.0, 2.0 * 1.04 / 12.0, 0.0};
    Vec2 center = Vec2::Zero();
    Vec2 linear = Vec2::Zero();
    for (int k = 0; k < 3; ++k) {
      center += mass[k] / 3.5 * s[k].position;
      linear += mass[k] * s[k].velocity;
    }
    double angular = 0.0;
    for (int k = 0; k < 3; ++k)
      angular += mass[k] * det(s[k].position - center, s[k].velocity) + inertia[k] * s[k].spin;
    return std::tuple(center, linear, angular);
  };
  simulation.advance_to(0.0);
  const auto [center, linear, angular] = momenta();
  const double t = 2.0;
  simulation.advance_to(t);
  const auto [end, later, turning] = momenta();
  const Vec2 fall(0.0, -0.5 * g * t * t);
  EXPECT_NEAR((end - center - t / 3.5 * linear - fall).norm(), 0.0, 1e-13);
  EXPECT_NEAR((later - linear - Vec2(0.0, -3.5 * g * t)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(turning, angular, 1e-13);
  EXPECT_EQ(simulation.states()[2].spin, 0.0);
  EXPECT_LE(simulation.audit().max_rod_error, 1e-12);
}

TEST(RodImpact, ACubeOnARodThatHitsAWallTakesTheRodsImpulse) {
  // Both rows at the instant of the impact: M (v+ - v-) = J' p, J v+ = 0.
  const double a = 0.3;
  Scene scene;
  SceneCube cube;
  cube.name = "a";
  cube.mass = 2.0;
  cube.angle = a;
  cube.velocity = {1.5, 0.0};
  scene.cubes.push_back(cube);
  const auto turned = [&](double x, double y) {
    return Vec2(std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y);
  };
  const Vec2 r = turned(0.5, -0.5);  // of the corner that hits
  const Vec2 h = turned(-0.5, 0.5);  // of the corner that hangs
  scene.rods.push_back({"rod", {"a", {-0.5, 0.5}}, {"", h + Vec2(0.0, 2.0)}, 2.0});
  scene.planes.push_back({"wall", r, -Vec2::UnitX(), {}});
  Simulation simulation(scene, {});
  simulation.advance_to(0.0);
  Eigen::Matrix<double, 2, 3> J;
  J << -1.0, 0.0, r.y(), 0.0, 1.0, h.x();
  const Eigen::Vector3d inverse_mass(0.5, 0.5, 6.0 / 2.0);
  const Eigen::Vector3d before(1.5, 0.0, 0.0);
  const Eigen::Matrix2d A = J * inverse_mass.asDiagonal() * J.transpose();
  const Eigen::Vector2d p = A.inverse() * (-J * before);
  const Eigen::Vector3d after = before + inverse_mass.asDiagonal() * J.transpose() * p;
  const BodyState& s = simulation.states()[0];
  EXPECT_NEAR(s.velocity.x(), after.x(), 1e-10);
  EXPECT_NEAR(s.velocity.y(), after.y(), 1e-10);
  EXPECT_NEAR(s.spin, after.z(), 1e-10);
  ASSERT_EQ(simulation.events().size(), 1U);
  EXPECT_NEAR(simulation.events()[0].impulse, p.x(), 1e-10);
}

TEST(RodImpact, AVelocityAlongARodIsTakenAtTheStart) {
  Simulation simulation = simulation_of(
      "point = [{name = \"p\", position = [0, -1], velocity = [0.5, -2], mass = 3}]\n"
      "rod = [{name = \"r\", from = \"p\", to = [0, 0]}]\n");
  EXPECT_NEAR((simulation.states()[0].velocity - Vec2(0.5, 0.0)).norm(), 0.0, 1e-12);
  ASSERT_EQ(simulation.events().size(), 1U);
  EXPECT_EQ(simulation.events()[0].kind, EventKind::impact);
  EXPECT_EQ(simulation.events()[0].on, "p");
  EXPECT_NEAR(simulation.events()[0].impulse, 6.0, 1e-10);
  EXPECT_NEAR(simulation.audit().impact_loss, 6.0, 1e-10);
}

std::string chain_text(int count) {
  std::string points = "point = [";
  std::string rods = "rod = [{from = [0, 0], to = \"p1\"}";
  for (int k = 1; k <= count; ++k) {
    points += (k > 1 ? ", " : "") + ("{name = \"p" + std::to_string(k))
              + "\", mass = 0.1, position = [" + std::to_string(0.1 * k) + ", 0]}";
    if (k > 1)
      rods += ", {from = \"p" + std::to_string(k - 1) + "\", to = \"p" + std::to_string(k) + "\"}";
  }
  return points + "]\n" + rods + "]\n";
}

TEST(Chain, OfTwentyLinksKeepsItsEnergy) {
  Simulation simulation = simulation_of(chain_text(20), {.integrator = Integrator::event});
  simulation.advance_to(20.0);
  const Audit audit = simulation.audit();
  // Its energy: what it can fall.
  EXPECT_LE(std::abs(audit.drift()), 1e-6 * 20 * 0.1 * g * 1.0);
  EXPECT_LE(audit.max_rod_error, 1e-12);
}

class EveryIntegrator : public testing::TestWithParam<Integrator> {};

TEST_P(EveryIntegrator, KeepsLengthsAndPins) {
  const MotionSettings settings{.integrator = GetParam()};
  Simulation simulation = simulation_of(
      "cube = [{name = \"a\", size = [1, 0.2], position = [0.5, 0]}, {name = \"b\", size = [1, "
      "0.2], position = [1.5, 0]}]\n"
      "point = [{name = \"p\", position = [2, -1], mass = 0.5}]\n"
      "pin = [{from = \"a.w\", to = [0, 0]}, {from = \"a.e\", to = \"b.w\"}]\n"
      "rod = [{from = \"b.e\", to = \"p\"}]\n",
      settings);
  for (const double t : {0.3, 0.711, 1.2}) {
    simulation.advance_to(t);
    EXPECT_LE(
        std::abs((simulation.snapshot({}).links[2].a - simulation.snapshot({}).links[2].b).norm()),
        1e-12);
    EXPECT_NEAR((simulation.snapshot({}).links[0].a - simulation.snapshot({}).links[0].b).norm(),
                1.0, 1e-12);
  }
  EXPECT_LE(simulation.audit().max_rod_error, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All,
                         EveryIntegrator,
                         testing::ValuesIn(all_integrators),
                         name_of_integrator);

TEST(Rattle, IsOfSecondOrderWithRods) {
  // Against the reference of the double pendulum, whose error falls by four with half of the step.
  const auto error = [](double step) {
    constexpr double loose = 1e-2;  // the step decides
    Simulation simulation(double_pendulum(),
                          {.integrator = Integrator::rattle, .tolerance = loose, .step = step});
    simulation.advance_to(2.0);
    return (simulation.states()[1].position
            - Vec2(-0.84182969878893535483, -0.80069732992846889898))
        .norm();
  };
  const double coarse = error(1.0 / 256.0);
  const double fine = error(1.0 / 512.0);
  EXPECT_LE(coarse, 2e-3);
  EXPECT_NEAR(coarse / fine, 4.0, 0.02);
}

TEST(Rattle, EnergyOfRodsStaysWithinItsBudget) {
  const MotionSettings settings{.integrator = Integrator::rattle};
  const std::string pendulum =
      "point = [{name = \"upper\", position = [1, 0]}, {name = \"lower\", position = [2, 0]}]\n"
      "rod = [{from = [0, 0], to = \"upper\"}, {from = \"upper\", to = \"lower\"}]\n";
  const std::string bars =
      "chain = [{count = 10, from = [0, 0], to = [5, 0], size = [0.5, 0.12], mass = 0.2, loose = "
      "true}]\n";
  for (const std::string& text : {pendulum, bars}) {
    Simulation simulation = simulation_of(text, settings);
    for (int k = 1; k <= 12; ++k) {
      simulation.advance_to(0.5 * k);
      const Audit audit = simulation.audit();
      EXPECT_LE(std::abs(audit.drift()), audit.drift_budget) << text << 0.5 * k;
    }
    EXPECT_TRUE(simulation.breaches().empty());
  }
}

class SlidingPair : public testing::TestWithParam<Integrator> {};

TEST_P(SlidingPair, OnUnequalFloorsIsSlowedTogether) {
  const MotionSettings settings{.integrator = GetParam()};
  Simulation simulation = simulation_of(
      "plane = [{name = \"floor\"}]\n"
      "cube = [{name = \"a\", mass = 2, position = [0, 0.5], velocity = [4, 0]},"
      "        {name = \"b\", position = [3, 0.5], velocity = [4, 0]}]\n"
      "pair = [{bodies = [\"a\", \"floor\"], friction = 0.3}, {bodies = [\"b\", \"floor\"], "
      "friction = 0.1}]\n"
      "rod = [{from = \"a\", to = \"b\"}]\n",
      settings);
  const double slowing = 0.7 / 3.0 * g;
  simulation.advance_to(1.0);
  EXPECT_NEAR(simulation.states()[0].velocity.x(), 4.0 - slowing, 1e-6);
  EXPECT_NEAR(simulation.states()[1].velocity.x(), 4.0 - slowing, 1e-6);
  EXPECT_NEAR(simulation.snapshot({.forces = true}).links[0].tension, 2.0 / 3.0 * 0.2 * g, 1e-6);
  simulation.advance_to(2.0);
  EXPECT_NEAR(simulation.states()[0].position.x(), 8.0 / slowing, 1e-4);
  EXPECT_NEAR(simulation.audit().friction_loss, 24.0, 0.01);
  EXPECT_LE(simulation.audit().max_rod_error, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Both,
                         SlidingPair,
                         testing::Values(Integrator::event, Integrator::rattle),
                         [](const auto& test) { return std::string(to_string(test.param)); });

TEST(PointMass, LandsOnABoxAndSlidesOffItsEnd) {
  Simulation simulation = simulation_of(
      "fixed = [{name = \"table\", size = [2, 1], position = [0, 0]}]\n"
      "plane = [{name = \"floor\", point = [0, -1]}]\n"
      "point = [{name = \"p\", position = [0.5, 1.5], velocity = [1, 0]}]\n");
  const double fall = std::sqrt(2.0 / g);
  simulation.advance_to(fall + 0.01);
  EXPECT_NEAR(simulation.states()[0].position.y(), 0.5, 1e-9);
  simulation.advance_to(2.0);
  const auto& events = simulation.events();
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].kind, EventKind::impact);
  EXPECT_NEAR(events[0].t, fall, 1e-9);
  EXPECT_EQ(events[1].kind, EventKind::slide_off);
  EXPECT_NEAR(events[1].t, 0.5, 1e-9);
  EXPECT_EQ(events[2].kind, EventKind::impact);
  EXPECT_NEAR(events[2].t, 0.5 + std::sqrt(3.0 / g), 1e-9);
  EXPECT_LE(simulation.audit().max_penetration, 1e-9);
}

TEST(Rest, OfWhatHangsStillIsCertified) {
  Simulation simulation = simulation_of(
      "cube = [{name = \"a\", position = [0, -1.5]}]\n"
      "rod = [{from = \"a.n\", to = [0, 0]}]\n");
  simulation.advance_to(5.0);
  EXPECT_TRUE(simulation.at_rest());
  EXPECT_TRUE(simulation.moved().empty());
  EXPECT_EQ(simulation.states()[0].position, Vec2(0.0, -1.5));
}

}  // namespace
}  // namespace wuerfel::test
