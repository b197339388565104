// What Algorithm 1 must do exactly, and what it must do to the order of its step.
#include <cmath>

#include <gtest/gtest.h>

#include "core/time/simulation.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

SceneCube moving_cube(const Vec2& position, double angle, const Vec2& velocity, double spin) {
  SceneCube c = cube("a", position, angle, spin);
  c.velocity = velocity;
  return c;
}

struct Method {
  Integrator integrator;
  Formulation formulation;
};

class FreeFall : public testing::TestWithParam<Method> {};

TEST_P(FreeFall, IsTheIntegratorsOwnSum) {
  const MotionSettings settings{.integrator = GetParam().integrator,
                                .formulation = GetParam().formulation,
                                .step = 1.0 / 128.0};
  Scene scene;
  scene.cubes = {moving_cube({0.0, 10.0}, 0.3, {1.0, 2.0}, 0.5)};
  Simulation simulation(scene, settings);
  simulation.advance_to(1.0);
  Vec2 p(0.0, 10.0);
  Vec2 v(1.0, 2.0);
  for (int k = 0; k < 128; ++k) {
    const Vec2 v_old = v;
    v += Vec2(0.0, -9.81) * settings.step;
    p += (settings.integrator == Integrator::euler ? v_old : v) * settings.step;
  }
  const BodyState& s = simulation.states()[0];
  EXPECT_NEAR((s.position - p).norm(), 0.0, 1e-12);
  EXPECT_NEAR((s.velocity - v).norm(), 0.0, 1e-12);
  // Points that step along their tangents gain the share (omega dt)^2 of their angular momentum in
  // each step: an excess of omega^3 dt t^2 / 2 in the angle, 2.4e-4 here, which is the algorithm's
  // and not ours.
  const double turn = settings.formulation == Formulation::points ? 5e-4 : 1e-13;
  EXPECT_NEAR(s.angle, 0.3 + 0.5, turn);
  EXPECT_LE(simulation.audit().max_rod_error, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All,
                         FreeFall,
                         testing::Values(Method{Integrator::euler, Formulation::points},
                                         Method{Integrator::euler, Formulation::rigid},
                                         Method{Integrator::symplectic, Formulation::points},
                                         Method{Integrator::symplectic, Formulation::rigid}),
                         [](const auto& test) {
                           return std::string(to_string(test.param.integrator)) + "_"
                                  + std::string(to_string(test.param.formulation));
                         });

TEST(Motion, LookingBetweenStepsDoesNotChangeIt) {
  const Scene scene = on_floor({moving_cube({0.0, 1.5}, 0.3, {0.2, 0.0}, 0.4)});
  Simulation quiet(scene, {});
  Simulation watched(scene, {});
  for (int k = 1; k < 70; ++k)
    watched.advance_to(0.01 * k);
  watched.advance_to(0.7);
  quiet.advance_to(0.7);
  EXPECT_EQ(quiet.states()[0].position, watched.states()[0].position);
  EXPECT_EQ(quiet.states()[0].angle, watched.states()[0].angle);
  EXPECT_EQ(quiet.events().size(), watched.events().size());
}

TEST(Motion, SameSceneGivesTheSameBits) {
  const Scene scene = on_floor({moving_cube({0.0, 1.5}, 0.3, {0.2, 0.0}, 0.4)});
  Simulation first(scene, {});
  Simulation second(scene, {});
  first.advance_to(0.8);
  second.advance_to(0.8);
  EXPECT_EQ(first.states()[0].position, second.states()[0].position);
  EXPECT_EQ(first.states()[0].velocity, second.states()[0].velocity);
}

TEST(Motion, AStandingTowerDoesNotMoveAtAll) {
  const Scene scene = on_floor(tower(5));
  Simulation simulation(scene, {});
  simulation.advance_to(1.0);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(simulation.states()[i].position, scene.cubes[i].position);
    EXPECT_EQ(simulation.states()[i].angle, 0.0);
  }
  EXPECT_TRUE(simulation.moved().empty());
  EXPECT_TRUE(simulation.at_rest());
  EXPECT_LE(simulation.cost().qp_solves, 2) << "certified rest is not solved again";
}

/// Angle of a square that tips about its corner on the frictionless floor, at t = 0.292543 s: exact
/// answer of the reference case tip_corner_square.
double tipping_error(double step, Integrator integrator) {
  Scene scene = on_floor({cube("a", {0.0, 0.7035741925769523333}, 0.6853981633974483096157)});
  Simulation simulation(scene, {.integrator = integrator, .step = step});
  simulation.advance_to(0.292543);
  EXPECT_LE(simulation.audit().max_penetration, 1e-9);
  return std::abs(simulation.states()[0].angle - 0.4731182850977074098196);
}

TEST(Motion, TippingConvergesWithFirstOrder) {
  for (const Integrator integrator : {Integrator::symplectic, Integrator::euler}) {
    const double coarse = tipping_error(1.0 / 120.0, integrator);
    const double fine = tipping_error(1.0 / 480.0, integrator);
    // First order: a quarter of the error for a quarter of the step.
    EXPECT_LT(fine, 0.35 * coarse);
    EXPECT_GT(fine, 0.15 * coarse);
    EXPECT_LT(coarse, 0.02);
  }
}

TEST(Motion, ImpactsOnlyLoseEnergyAndLeaveNoOverlap) {
  const Scene scene = on_floor({moving_cube({0.0, 2.0}, 0.4, {0.3, 0.0}, 1.0)});
  Simulation simulation(scene, {});
  double before = simulation.audit().energy_start;
  for (int k = 1; k <= 150; ++k) {
    simulation.advance_to(k / 100.0);
    const Audit audit = simulation.audit();
    EXPECT_LE(audit.max_penetration, 1e-9);
    before = audit.energy_end;
  }
  EXPECT_GT(simulation.audit().impact_loss, 1.0);
  EXPECT_LT(before, simulation.audit().energy_start);
  EXPECT_EQ(simulation.audit().missed_solves, 0);
  EXPECT_FALSE(simulation.events().empty());
}

TEST(Motion, APulseIsFeltBetweenStepsAndStopsTheMotion) {
  const MotionSettings settings{.integrator = Integrator::moreau};
  Simulation simulation(on_floor({moving_cube({0.0, 2.0}, 0.4, {0.3, 0.0}, 1.0)}), settings);
  struct Stop {};
  int beats = 0;
  simulation.set_pulse([&] {
    if (++beats == 5) throw Stop{};
  });
  EXPECT_THROW(simulation.advance_to(10.0), Stop);
  EXPECT_EQ(beats, 5);
}

}  // namespace
}  // namespace wuerfel::test
