// Who looks at a motion changes nothing about it: neither its states nor what is kept book of. Also shown_joints.cpp.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
#include "tests/support/bin_scene.h"
#include "tests/support/deepest_overlap.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

class Looks : public testing::TestWithParam<Integrator> {};

void expect_same_books(const Simulation& a, const Simulation& b) {
  const Audit p = a.audit();
  const Audit q = b.audit();
  for (double Audit::*value : {&Audit::max_penetration, &Audit::max_overlap, &Audit::max_rod_error,
                               &Audit::max_kkt_residual, &Audit::drift_budget, &Audit::energy_start,
                               &Audit::energy_end, &Audit::impact_loss, &Audit::friction_loss})
    EXPECT_EQ(p.*value, q.*value);
  for (long Audit::*count :
       {&Audit::missed_solves, &Audit::unresolved, &Audit::searches_given_up, &Audit::wedged})
    EXPECT_EQ(p.*count, q.*count);
  for (long Cost::*count : {&Cost::steps, &Cost::qp_solves, &Cost::hand_overs, &Cost::skipped_free,
                            &Cost::skipped_rest, &Cost::skipped_certificate})
    EXPECT_EQ(a.cost().*count, b.cost().*count);
}

TEST_P(Looks, LeaveMotionAndBooksAsTheyAre) {
  // A crowd for the default, so that groups are stepped; a few cubes for the slow ones.
  const bool few = GetParam() != Integrator::automatic;
  const Scene scene = few ? bin_scene(4, 4.0, 6.0, 2) : bin_scene(12, 4.0, 14.0, 5);
  MotionSettings settings{.integrator = GetParam()};
  if (few) settings.step = 1.0 / 120.0;
  Simulation alone(scene, settings);
  Simulation watched(scene, settings);
  const SnapshotRequest all{.forces = true,
                            .rods = true,
                            .rod_forces = true,
                            .points = true,
                            .contacts = true,
                            .sides = true};
  const double end = few ? 1.0 : 1.5;
  for (int k = 0; 0.0137 * k < end; ++k) {
    watched.advance_to(0.0137 * k);
    (void)watched.snapshot(all);
    (void)watched.at_rest();
  }
  watched.advance_to(end);
  alone.advance_to(end);
  EXPECT_GT(watched.look_cost().qp_solves, 10);
  EXPECT_EQ(alone.look_cost().qp_solves, 0);
  expect_same_books(alone, watched);
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    EXPECT_EQ(alone.states()[i].position, watched.states()[i].position) << i;
    EXPECT_EQ(alone.states()[i].angle, watched.states()[i].angle) << i;
    EXPECT_EQ(alone.states()[i].velocity, watched.states()[i].velocity) << i;
  }
  EXPECT_EQ(alone.events().size(), watched.events().size());
}

INSTANTIATE_TEST_SUITE_P(All,
                         Looks,
                         testing::Values(Integrator::automatic,
                                         Integrator::event,
                                         Integrator::rattle,
                                         Integrator::moreau,
                                         Integrator::euler),
                         [](const auto& test) { return std::string(to_string(test.param)); });

TEST(Look, AtWhatRestsCostsNothingASecondTime) {
  std::vector<SceneCube> cubes = tower(10);
  cubes.push_back(cube("drop", {4.0, 3.0}));
  Simulation simulation(on_floor(cubes), {});
  constexpr int frames = 60;
  std::size_t arrows = 0;
  for (int k = 0; k <= frames; ++k) {
    simulation.advance_to(k / 30.0);
    arrows = simulation.snapshot({.forces = true}).forces.size();
  }
  EXPECT_EQ(arrows, 22U);
  EXPECT_TRUE(simulation.at_rest());
  // The tower once; the cube that lands once.
  EXPECT_EQ(simulation.look_cost().qp_solves, 2);
  EXPECT_EQ(simulation.look_cost().force_choices, 2);
}

TEST(Look, TheSameInstantIsSeenTheSameHoweverOftenOneLooked) {
  const Scene scene = bin_scene(12, 4.0, 14.0, 5);
  Simulation often(scene, {});
  for (int k = 1; k < 140; ++k) {
    often.advance_to(0.01 * k);
    (void)often.snapshot({.forces = true});
  }
  Simulation once(scene, {});
  often.advance_to(1.4);
  once.advance_to(1.4);
  const Snapshot a = often.snapshot({.forces = true});
  const Snapshot b = once.snapshot({.forces = true});
  ASSERT_EQ(a.forces.size(), b.forces.size());
  for (std::size_t k = 0; k < a.forces.size(); ++k)
    EXPECT_EQ(a.forces[k].force, b.forces[k].force) << k;
  EXPECT_EQ(a.force_residual, b.force_residual);
}

TEST(Look, StatesAreWhereTheirForcesAre) {
  Simulation simulation(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.3, 1.5})}), {});
  const Snapshot snapshot = simulation.snapshot({.forces = true, .contacts = true});
  EXPECT_EQ(snapshot.time, 0.0);
  EXPECT_EQ(snapshot.forces.size(), 4U);
  EXPECT_EQ(snapshot.contacts.size(), 4U);
  EXPECT_LE(snapshot.force_residual, 1e-13);
}

TEST(Look, JointsAreTheResultantsOfTheirCorners) {
  Simulation simulation(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.3, 1.5})}), {});
  const Snapshot snapshot =
      simulation.snapshot({.forces = true, .joints = true, .unique = true, .accelerations = true});
  ASSERT_EQ(snapshot.joints.size(), 2U);
  for (const SnapshotJoint& joint : snapshot.joints) {
    const bool upper = joint.body == 1;
    EXPECT_EQ(joint.other, upper ? 0 : 2) << "a, or the floor behind two boxes";
    EXPECT_NEAR(joint.force.y(), (upper ? 1.0 : 2.0) * snapshot.boxes[0].mass * 9.81, 1e-10);
    EXPECT_NEAR(joint.point.x(), upper ? 0.3 : 0.15, 1e-12) << "below what it carries";
    EXPECT_NEAR((joint.to - joint.from).norm(), upper ? 0.7 : 1.0, 1e-12);
    EXPECT_GT((joint.to - joint.from).dot(perp(joint.normal)), 0.0);
    EXPECT_TRUE(joint.unique);
  }
  EXPECT_TRUE(snapshot.boxes[0].acceleration.isZero(1e-9));
  EXPECT_EQ(snapshot.gravity.y(), -9.81);
  EXPECT_EQ(snapshot.energy_start, snapshot.energy);
}

TEST(Look, PushesNothingOutFromBelowWhatIsHeavy) {
  // The slab of 10 t comes down on a light one. What takes that out of the slab in looks may not be the least work (away from
  // below it, by two metres), for others stand there of whom its group knows nothing.
  const Scene scene = parse_scene(R"(
material = { friction = 0.3, restitution = 0.5519468963523283 }
plane = [{ name = "floor" }]
cube = [{ size = [1, 0.5], mass = 0.001, position = [2.8, 1.7], velocity = [-0.2, -2] },
        { size = [2, 0.2], position = [0, 5], velocity = [4, 2] },
        { size = [2, 0.2], mass = 1e4, position = [-3, 7.5], velocity = [3.9, 1.34] },
        { size = [0.3, 2], mass = 0.001, position = [3, 7.5], velocity = [0.19409632639309748, -1.0297913493603184] }]
)",
                                  "slabs.toml");
  const Mechanism m(scene);
  Simulation simulation(scene, {});
  for (int k = 0; k < 60; ++k) {
    simulation.advance_to(1.325 + 0.00025 * k);
    EXPECT_LE(deepest_overlap(m.system, simulation.states()), 1e-9) << "at " << simulation.time();
  }
}

TEST(Look, GainsNothingWhileABlowIsTakenBack) {
  // A block of nine comes apart. Places between the ends of a step know of blows of which its velocities know nothing any more.
  const Scene scene = parse_scene(R"(
material = { friction = 240115.0, restitution = 0.9 }
plane = [{ name = "floor", friction = 0.6222 }]
cube = [{ position = [0, 1], friction = 1.0 },
        { position = [1, 1], friction = 0.00013949932726646982 },
        { position = [2, 1], friction = 0.1 },
        { position = [0, 2], friction = 0.004776748380456321 },
        { position = [1, 2], friction = 0.0312, restitution = 0.0 },
        { position = [2, 2] },
        { position = [0, 3], friction = 0.52 },
        { position = [1, 3], friction = 5.4, restitution = 0.0 },
        { position = [2, 3], velocity = [-2.779, 0.2], restitution = 0.0 }]
)",
                                  "block.toml");
  Simulation simulation(scene, {});
  double lowest = simulation.snapshot({}).energy;
  for (int k = 1; k <= 300; ++k) {
    simulation.advance_to(k / 600.0);
    const double energy = simulation.snapshot({}).energy;
    EXPECT_LE(energy, lowest + 1e-5) << "at " << simulation.time();
    lowest = std::min(lowest, energy);
  }
}

}  // namespace
}  // namespace wuerfel::test
