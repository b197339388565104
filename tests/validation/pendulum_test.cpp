// Pendulums of rods and pins against closed forms and a reference of 28 digits.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
#include "tests/support/scenes.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Angular frequency of small swings and the quarter of the period of a pendulum of the length `l` that swings up to `a`.
double small_frequency(double l) { return std::sqrt(g / l); }
double quarter_period(double l, double a) {
  return std::comp_ellint_1(std::sin(0.5 * a)) / small_frequency(l);
}

class PointPendulum : public testing::TestWithParam<double> {};

TEST_P(PointPendulum, FollowsEllipticFunctions) {
  const double a = GetParam();
  const double l = 1.3;
  Scene scene;
  scene.points.push_back({"p", 2.0, {l * std::sin(a), -l * std::cos(a)}, Vec2::Zero(), {}});
  scene.rods.push_back({"rod", {"p", Vec2::Zero()}, {"", Vec2::Zero()}, l});
  Simulation simulation(scene, {.tolerance = 1e-11});
  const double quarter = quarter_period(l, a);
  simulation.advance_to(12.0 * quarter);
  const BodyState& back = simulation.states()[0];
  EXPECT_NEAR((back.position - scene.points[0].position).norm(), 0.0, 1e-9);
  EXPECT_NEAR(back.velocity.norm(), 0.0, 1e-9 * 10.0);
  simulation.advance_to(13.0 * quarter);
  const BodyState& lowest = simulation.states()[0];
  EXPECT_NEAR((lowest.position - Vec2(0.0, -l)).norm(), 0.0, 1e-8);
  EXPECT_NEAR(lowest.velocity.norm(), 2.0 * l * small_frequency(l) * std::sin(0.5 * a), 1e-9);
  EXPECT_LE(simulation.audit().max_rod_error, 1e-12);
  // Tension at the lowest point: m g + m v^2 / l.
  const Snapshot snapshot = simulation.snapshot({.forces = true});
  EXPECT_NEAR(snapshot.links[0].tension, 2.0 * (g + lowest.velocity.squaredNorm() / l), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Amplitudes,
                         PointPendulum,
                         testing::Values(0.1, 1.5, 3.0),
                         [](const auto& test) {
                           return "a" + std::to_string(std::lround(10.0 * test.param));
                         });

TEST(PhysicalPendulum, ACubeOnAPinAtItsCornerSwingsLikeAPoint) {
  // Inertia about the corner 2/3 m s^2, the centre s / sqrt(2) away: a point on 2 sqrt(2) / 3 s.
  const double l = 2.0 * std::numbers::sqrt2 / 3.0;
  const double a = 1.2;
  const double d = std::numbers::sqrt2 / 2.0;
  Scene scene;
  SceneCube cube;
  cube.name = "a";
  cube.position = {d * std::sin(a), -d * std::cos(a)};
  cube.angle = a - 0.75 * pi;  // its corner sw at the origin
  scene.cubes.push_back(cube);
  scene.pins.push_back({"pin", {"a", {-0.5, -0.5}}, {"", Vec2::Zero()}, false});
  Simulation simulation(scene, {.tolerance = 1e-11});
  const double quarter = quarter_period(l, a);
  simulation.advance_to(quarter);
  EXPECT_NEAR((simulation.states()[0].position - Vec2(0.0, -d)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(simulation.states()[0].spin), 2.0 * small_frequency(l) * std::sin(0.5 * a),
              1e-9);
  simulation.advance_to(12.0 * quarter);
  EXPECT_NEAR((simulation.states()[0].position - scene.cubes[0].position).norm(), 0.0, 1e-9);
  EXPECT_LE(simulation.audit().max_rod_error, 1e-12);
}

TEST(ParallelRods, ACubeSwingsOnThemLikeAPoint) {
  const double l = 2.0;
  const double a = 0.9;
  const Vec2 down(l * std::sin(a), -l * std::cos(a));
  Scene scene;
  SceneCube cube;
  cube.name = "a";
  cube.position = Vec2(0.0, -0.5) + down;
  scene.cubes.push_back(cube);
  scene.rods.push_back({"left", {"a", {-0.5, 0.5}}, {"", {-0.5, 0.0}}, l});
  scene.rods.push_back({"right", {"a", {0.5, 0.5}}, {"", {0.5, 0.0}}, l});
  Simulation simulation(scene, {.tolerance = 1e-11});
  const double quarter = quarter_period(l, a);
  simulation.advance_to(5.0 * quarter);
  const BodyState& lowest = simulation.states()[0];
  EXPECT_NEAR((lowest.position - Vec2(0.0, -0.5 - l)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(lowest.angle, 0.0, 1e-11);
  EXPECT_NEAR(lowest.velocity.norm(), 2.0 * l * small_frequency(l) * std::sin(0.5 * a), 1e-9);
  simulation.advance_to(12.0 * quarter);
  EXPECT_NEAR((simulation.states()[0].position - cube.position).norm(), 0.0, 1e-9);
}

TEST(DoublePendulum, FollowsTheReference) {
  // Gragg, Bulirsch and Stoer with 30 digits.
  Simulation simulation(double_pendulum(), {});
  simulation.advance_to(2.0);
  const State& s = simulation.states();
  EXPECT_NEAR((s[0].position - Vec2(-0.99986449158829600849, -0.016462030885596724537)).norm(), 0.0,
              1e-7);
  EXPECT_NEAR((s[1].position - Vec2(-0.84182969878893535483, -0.80069732992846889898)).norm(), 0.0,
              1e-7);
  EXPECT_NEAR((s[0].velocity - Vec2(0.068847052899615857049, -4.1816057826167577772)).norm(), 0.0,
              1e-6);
  EXPECT_NEAR((s[1].velocity - Vec2(2.0244260650554149696, -3.787528234250849371)).norm(), 0.0,
              1e-6);
}

}  // namespace
}  // namespace wuerfel::test
