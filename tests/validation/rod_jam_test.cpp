// Rods that cannot go on: what they take at once, and what is said where forces drive what they hold.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/promises.h"
#include "core/time/simulation.h"
#include "tests/support/parameter_names.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

Simulation simulation_of(const std::string& text, Integrator integrator) {
  return {parse_scene(text, "s.toml"), {.integrator = integrator}};
}

/// A point between two rods in one line, which nothing pulls at.
const std::string tightrope =
    "point = [{name = \"p\", position = [0, 0]}]\n"
    "rod = [{name = \"l\", from = \"p\", to = [-1, 0]}, {name = \"r\", from = \"p\", to = [1, "
    "0]}]\n";

/// The same, upright, pushed by a cube that slides down a slope.
const std::string pushed =
    "plane = [{name = \"slope\", point = [0, -0.35], normal = [-1, 1]}]\n"
    "point = [{name = \"p\", position = [0, 0]}]\n"
    "rod = [{name = \"l\", from = \"p\", to = [0, 1]}, {name = \"r\", from = \"p\", to = [0, "
    "-1]}]\n"
    "cube = [{name = \"c\", on = \"slope\", offset = 1.8, size = 0.5}]\n";

class JamWithEveryIntegrator : public testing::TestWithParam<Integrator> {};

TEST_P(JamWithEveryIntegrator, BooksWhatARopeTakesThatIsStruckAcross) {
  Simulation simulation = simulation_of(
      "gravity = [0, 0]\n" + tightrope
          + "cube = [{name = \"c\", size = 0.4, position = [0, 1], velocity = [0, -4]}]\n",
      GetParam());
  simulation.advance_to(1.0);
  const Audit audit = simulation.audit();
  EXPECT_NEAR(audit.impact_loss, 8.0, 1e-6);
  EXPECT_NEAR(audit.drift(), 0.0, 1e-6);
  const State& s = simulation.states();  // the cube, the point
  EXPECT_NEAR(s[0].velocity.norm(), 0.0, 1e-4);
  EXPECT_NEAR(s[1].position.norm(), 0.0, 1e-7);
  EXPECT_NEAR(s[1].velocity.norm(), 0.0, 1e-9);
  const auto& events = simulation.events();
  EXPECT_TRUE(std::ranges::any_of(events, [](const Event& e) {
    return e.kind == EventKind::jam && e.on == "p" && e.from == "l" && e.impulse > 1.0;
  }));
  EXPECT_EQ(audit.rods_contradicting, 0);
  EXPECT_TRUE(simulation.breaches().empty());
}

TEST_P(JamWithEveryIntegrator, IsNotSilentWhereForcesGoOnToPushAcrossARope) {
  Simulation simulation = simulation_of(pushed, GetParam());
  simulation.advance_to(0.7);
  const Audit audit = simulation.audit();
  // It gives by some 1e-6 of its length, to first order nothing, and holds: or somebody says so.
  EXPECT_NEAR(simulation.states()[1].position.norm(), 0.0, 1e-4);
  EXPECT_NEAR(audit.impact_loss, 9.035, 0.5);
  EXPECT_TRUE(std::abs(audit.drift()) <= 1e-5 || !broken_promises(audit).empty());
}

INSTANTIATE_TEST_SUITE_P(All,
                         JamWithEveryIntegrator,
                         testing::ValuesIn(all_integrators),
                         name_of_integrator);

TEST_P(JamWithEveryIntegrator, HoldsOrNamesRodsThatForcesDrive) {
  // A point in the middle of a rope lies on a block that slides away. To first order nothing holds it then; lengths
  // within their promise let it sink by some 1e-6, and hold. Where a step finds that they cannot it says so.
  Simulation simulation = simulation_of(
      tightrope
          + "plane = [{name = \"floor\", point = [0, -0.5]}]\n"
            "cube = [{name = \"block\", size = 0.5, position = [0, -0.25], velocity = [1, 0]}]\n",
      GetParam());
  simulation.advance_to(0.3);
  const Audit audit = simulation.audit();
  EXPECT_NEAR(simulation.states()[1].position.norm(), 0.0, 1e-5);
  EXPECT_LE(audit.max_rod_error, promised_rod_error);
  const Breach* breach = first_breach(simulation.breaches(), Promise::rods);
  if (GetParam() == Integrator::euler) {
    ASSERT_NE(breach, nullptr);
    EXPECT_EQ(breach->bodies, (std::vector<std::string>{"l", "r"}));
    EXPECT_NEAR(breach->t, 0.25, 0.01);
    EXPECT_GT(audit.rods_contradicting, 0);
  } else {
    EXPECT_EQ(breach, nullptr);
    EXPECT_NEAR(audit.drift(), 0.0, 1e-4);
  }
}

TEST(RodJam, KeepsTheMomentaOfWhatFlies) {
  // Three points in one line, held there by three rods, struck across in the middle: as a rigid body they go on.
  Simulation simulation = simulation_of(
      "gravity = [0, 0]\n"
      "point = [{name = \"a\", position = [-1, 0]}, {name = \"b\", position = [0.5, 0], mass = 2},"
      "         {name = \"c\", position = [1, 0]}]\n"
      "rod = [{from = \"a\", to = \"b\"}, {from = \"b\", to = \"c\"}, {from = \"a\", to = \"c\"}]\n"
      "cube = [{name = \"hammer\", size = 0.4, position = [0.5, 1], velocity = [0, -4]}]\n",
      Integrator::automatic);
  simulation.advance_to(0.2);
  const State& s = simulation.states();
  // Inelastic: masses 4 (centre 0.25, inertia 2.25) and 1 at the arm 0.25.
  const double compliance = 1.0 + 0.25 + 0.25 * 0.25 / 2.25;
  const double impulse = 4.0 / compliance;
  const double spin = -0.25 * impulse / 2.25;
  EXPECT_NEAR(s[0].velocity.y(), -4.0 + impulse, 1e-8);  // the cube, then the points
  EXPECT_NEAR(s[1].velocity.y() + 2.0 * s[2].velocity.y() + s[3].velocity.y(), -impulse, 1e-8);
  EXPECT_NEAR((s[3].velocity - s[1].velocity).norm(), std::abs(2.0 * spin), 1e-8);
  const Audit audit = simulation.audit();
  EXPECT_NEAR(audit.impact_loss, 0.5 * 4.0 * impulse, 1e-8);
  EXPECT_LE(audit.momentum_linear, 1e-12);
  EXPECT_LE(audit.momentum_angular, 1e-8);
  EXPECT_LE(audit.max_rod_error, 1e-12);
  EXPECT_EQ(audit.rods_contradicting, 0);
}

TEST(RodJam, RodsThatNothingLeadsBackToAreNotTorn) {
  // Cubes in a row, a micrometre apart; two of them are held by a rod as short as that, and one from above.
  Simulation simulation = simulation_of(
      "material = {friction = 0.3}\n"
      "plane = [{name = \"floor\"}]\n"
      "cube = [{name = \"a\", position = [0, 0.5]}, {name = \"b\", position = [1.000001, 0.5], "
      "velocity = "
      "[-1.794833159803472, 0]},"
      "{name = \"c\", position = [2.000002, 0.5]}, {name = \"d\", position = [3.000003, 0.5]}]\n"
      "rod = [{from = \"b.e\", to = \"c.w\"}, {from = \"b.se\", to = [2.5175833025202268, "
      "2.0346490772365655]}]\n",
      Integrator::automatic);
  simulation.advance_to(0.5);
  const Audit audit = simulation.audit();
  EXPECT_GT(audit.rods_contradicting, 0);
  EXPECT_LE(audit.max_rod_error, 1e-6);
  EXPECT_LE(audit.energy_end, audit.energy_start);
}

TEST(RodJam, AParallelogramSwingsThroughItsStretchedPosition) {
  // Rods and cube in one line there: rods depend on one another, and do not contradict.
  const double l = 2.0;
  const double a = 2.0;
  Scene scene;
  SceneCube cube;
  cube.name = "a";
  cube.position = Vec2(0.0, -0.5) + l * Vec2(std::sin(a), -std::cos(a));
  scene.cubes.push_back(cube);
  scene.rods.push_back({"left", {"a", {-0.5, 0.5}}, {"", {-0.5, 0.0}}, l});
  scene.rods.push_back({"right", {"a", {0.5, 0.5}}, {"", {0.5, 0.0}}, l});
  Simulation simulation(scene, {});
  simulation.advance_to(4.0);
  const BodyState& s = simulation.states()[0];
  EXPECT_NEAR(0.5 * s.velocity.squaredNorm() + g * (s.position.y() - cube.position.y()), 0.0, 1e-7);
  EXPECT_NEAR(s.angle, 0.0, 1e-9);
  EXPECT_TRUE(simulation.events().empty());
  EXPECT_EQ(simulation.audit().rods_contradicting, 0);
}

}  // namespace
}  // namespace wuerfel::test
