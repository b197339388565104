// Time stepping: what its error control, its energy and its looks between steps promise.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
#include "tests/support/bin_scene.h"
#include "tests/support/deepest_overlap.h"

namespace wuerfel::test {
namespace {

MotionSettings stepping(double step, double tolerance = 1e-8) {
  MotionSettings settings;
  settings.integrator = Integrator::rattle;
  settings.step = step;
  settings.tolerance = tolerance;
  return settings;
}

double energy_of(const Simulation& simulation) { return simulation.snapshot({}).energy; }

Scene leaning_tower() {
  return parse_scene("version = 1\n[[plane]]\n[[tower]]\ncount = 5\nlean = 0.3\nbase = [0, 0]\n",
                     "tower.toml");
}

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
  const double loose = error_of(leaning_tower(), stepping(1.0 / 30.0, 1.0), 0.5);
  const double tight = error_of(leaning_tower(), stepping(1.0 / 30.0, 1e-10), 0.5);
  EXPECT_GT(loose, 1e-4);
  EXPECT_LT(tight, 0.1 * loose);
}

TEST(Stepping, EnergyRisesByNoMoreThanTheRootOfTheTolerance) {
  // Of all the energy that there is: it sways about its true value.
  for (const double step : {1.0 / 30.0, 1.0 / 60.0, 1.0 / 240.0}) {
    Simulation simulation(leaning_tower(), stepping(step));
    const double beginning = energy_of(simulation);
    for (int k = 1; k <= 150; ++k) {
      simulation.advance_to(0.01 * k);
      EXPECT_LE(energy_of(simulation), beginning * (1.0 + 1e-4)) << step << " at " << 0.01 * k;
    }
  }
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
  SnapshotRequest request;
  request.forces = true;
  for (int k = 1; k <= 20; ++k) {
    simulation.advance_to(0.0313 * k);
    const Snapshot snapshot = simulation.snapshot(request);
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
