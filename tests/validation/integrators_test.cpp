// The integrators against each other and against their own order: what a step or a tolerance
// promises.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/time/events/dop853.h"
#include "core/time/simulation.h"
#include "tests/support/max_norm.h"
#include "tests/support/reference_case.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

State state_at(const Scene& scene, double t, Integrator integrator, double step) {
  MotionSettings settings{.integrator = integrator, .step = step};
  // The steps that are asked for, none of them halved for its error.
  if (integrator == Integrator::rattle) settings.tolerance = 1.0;
  Simulation simulation(scene, settings);
  simulation.advance_to(t);
  return simulation.states();
}

void oscillator(const std::vector<double>& y, std::vector<double>& rate) {
  rate.resize(2);
  rate[0] = y[1];
  rate[1] = -y[0];
}

double oscillator_error(int steps, bool dense) {
  const double h = 2.0 / steps;
  Dop853 method;
  std::vector<double> y = {1.0, 0.0};
  std::vector<double> rate(2);
  double worst = 0.0;
  for (int k = 0; k < steps; ++k) {
    oscillator(y, rate);
    method.step(oscillator, y, rate, h);
    std::vector<double> next = method.next();
    if (dense) {
      std::vector<double> next_rate(2);
      oscillator(next, next_rate);
      DenseStep polynomial;
      method.dense(oscillator, y, next_rate, polynomial);
      for (const double s : {0.17, 0.5, 0.83})
        worst = std::max(worst, std::abs(polynomial.component(s, 0) - std::cos((k + s) * h)));
    }
    y = next;
  }
  return dense ? worst : std::abs(y[0] - std::cos(2.0));
}

TEST(Dop853, IsOfOrderEight) {
  const double order = std::log2(oscillator_error(2, false) / oscillator_error(4, false));
  EXPECT_GT(order, 7.5);
  EXPECT_LT(order, 9.5);
}

TEST(Dop853, HasDenseOutputOfOrderSeven) {
  // Local errors of order eight.
  const double order = std::log2(oscillator_error(2, true) / oscillator_error(4, true));
  EXPECT_GT(order, 6.5);
  EXPECT_LT(order, 9.5);
}

/// Error of a reference motion at a time of its smooth phase, against the event integrator.
double smooth_error(const std::string& name, double t, Integrator integrator, double step) {
  const Scene scene = read_reference_case(name).scene;
  return distance(state_at(scene, t, integrator, step),
                  state_at(scene, t, Integrator::event, step));
}

struct Smooth {
  const char* name;
  double t;
};

class Order : public testing::TestWithParam<Smooth> {};

TEST_P(Order, OfRattleIsTwo) {
  const auto [name, t] = GetParam();
  const double coarse = smooth_error(name, t, Integrator::rattle, t / 32.0);
  const double fine = smooth_error(name, t, Integrator::rattle, t / 128.0);
  EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 2.0, 0.15) << coarse << " " << fine;
}

TEST_P(Order, OfMoreauAndSymplecticIsOne) {
  const auto [name, t] = GetParam();
  for (const Integrator integrator : {Integrator::moreau, Integrator::symplectic}) {
    const double coarse = smooth_error(name, t, integrator, t / 128.0);
    const double fine = smooth_error(name, t, integrator, t / 512.0);
    EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 1.0, 0.25)
        << to_string(integrator) << " " << coarse << " " << fine;
  }
}

INSTANTIATE_TEST_SUITE_P(Smooth,
                         Order,
                         testing::Values(Smooth{"tip_corner_square", 0.4375},
                                         Smooth{"edge_tip_square_d0.05", 0.59375},
                                         Smooth{"edge_rider_plank2", 0.328125},
                                         Smooth{"ladder_block", 0.40625}),
                         [](const auto& test) { return test_name(test.param.name); });

TEST(Integrators, SteppingComesToTheEventDrivenMotion) {
  // A slide off a table; the collapse of a leaning tower while its cubes roll over one another.
  struct Case {
    Scene scene;
    double t = 0.0;
  };
  Scene table = on_floor({cube("a", {0.0, 1.5})});
  table.cubes[0].velocity = {1.0, 0.0};
  table.fixed.push_back({"table", {1.0, 1.0}, {0.0, 0.5}, 0.0, {}});
  for (const Case& c : {Case{table, 1.0}, Case{on_floor(leaning_tower(5, 0.3)), 0.6}}) {
    const State exact = state_at(c.scene, c.t, Integrator::event, 0.0);
    const double coarse = distance(state_at(c.scene, c.t, Integrator::rattle, 1e-3), exact);
    const double fine = distance(state_at(c.scene, c.t, Integrator::rattle, 6.25e-5), exact);
    EXPECT_LT(fine, 1e-3);
    EXPECT_LT(fine, 0.2 * coarse);
  }
}

TEST(Integrators, ATighterToleranceGivesMoreDigits) {
  const ReferenceCase reference = read_reference_case("tip_corner_square");
  const double t = 0.45;
  MotionSettings settings{.tolerance = 1e-13};
  Simulation exact(reference.scene, settings);
  exact.advance_to(t);
  double before = 1.0;
  for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
    settings.tolerance = tolerance;
    Simulation simulation(reference.scene, settings);
    simulation.advance_to(t);
    const double error = distance(simulation.states(), exact.states());
    EXPECT_LE(error, tolerance);
    EXPECT_LT(error, before);
    before = error;
  }
}

TEST(Integrators, FreeFlightIsExact) {
  Scene scene = on_floor({cube("a", {0.0, 10.0}, 0.3)});
  scene.cubes[0].velocity = {1.0, 2.0};
  scene.cubes[0].spin = 0.5;
  for (const Integrator integrator : {Integrator::automatic, Integrator::event}) {
    const State state = state_at(scene, 1.0, integrator, 0.0);
    EXPECT_NEAR(state[0].position.x(), 1.0, 1e-15);
    EXPECT_NEAR(state[0].position.y(), 10.0 + 2.0 - 0.5 * 9.81, 4e-15);
    EXPECT_NEAR(state[0].angle, 0.8, 2e-16);
  }
}

TEST(Integrators, TenHoursOfRestDriftByNothing) {
  const std::vector<SceneCube> cubes = tower(10);
  const Scene scene = on_floor(cubes);
  Simulation simulation(scene, {});
  simulation.advance_to(36000.0);
  EXPECT_TRUE(simulation.moved().empty());
  EXPECT_TRUE(simulation.at_rest());
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    EXPECT_EQ(simulation.states()[i].position, cubes[i].position);
    EXPECT_EQ(simulation.states()[i].angle, 0.0);
  }
  EXPECT_LE(simulation.cost().qp_solves, 2);
}

}  // namespace
}  // namespace wuerfel::test
