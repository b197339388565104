// What programs ask a simulation.
#include "core/time/simulation.h"

#include <gtest/gtest.h>

#include "tests/support/parameter_names.h"
#include "tests/support/scenes.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

/// A cube that falls beside one that stands.
Scene one_falls() { return on_floor({cube("stands", {0.0, 0.5}), cube("falls", {3.0, 2.0})}); }

TEST(Simulation, NamesWhatHasMoved) {
  Simulation simulation(one_falls(), {});
  EXPECT_TRUE(simulation.moved().empty());
  EXPECT_FALSE(simulation.at_rest());
  simulation.advance_to(1.0);
  EXPECT_EQ(simulation.moved(), std::vector<std::string>{"falls"});
  EXPECT_TRUE(simulation.at_rest());
  EXPECT_NEAR(simulation.audit().impact_loss, 9.81 * 1.5, 1e-12);
  EXPECT_NEAR(simulation.audit().drift(), 0.0, 1e-12);
}

TEST(Simulation, EveryIntegratorMakesAMotion) {
  for (const Integrator integrator : all_integrators) {
    Simulation simulation(one_falls(), {.integrator = integrator});
    simulation.advance_to(0.25);
    EXPECT_EQ(simulation.time(), 0.25);
    // Of first order: 9.81 t / 480 below or above the parabola.
    const double fall = 2.0 - simulation.states()[1].position.y();
    EXPECT_NEAR(fall, 0.5 * 9.81 * 0.0625, 0.006) << to_string(integrator);
  }
}

/// A grain under a load of ten million times its weight, with too little friction to tell: it rests from the start.
TEST(Simulation, RestIsFoundWhateverTheMasses) {
  for (const double mu : {1e-8, 1e-3, 0.3}) {
    Scene scene = on_floor({cube("b0", {0.5, 0.5}), sized_cube("b1", {0.5, 1.25}, {3.0, 0.5}),
                            sized_cube("b2", {0.6, 1.75}, {3.0, 0.5}),
                            sized_cube("b3", {0.7, 2.15}, {2.0, 0.3}), cube("b4", {0.7, 2.8})});
    set_friction(mu, scene);
    scene.cubes[0].mass = 1.6e-4;
    scene.cubes[1].mass = 0.013;
    scene.cubes[3].mass = 3.8e-4;
    scene.cubes[4].mass = 4140.0;
    Simulation simulation(scene, {});
    simulation.advance_to(0.1);
    EXPECT_TRUE(simulation.at_rest()) << mu;
    EXPECT_EQ(simulation.cost().steps, 0) << mu;
  }
}

TEST(Simulation, AMomentIsSeenLaterAsItWas) {
  Simulation simulation(one_falls(), {});
  const SnapshotRequest request{.forces = true, .accelerations = true};
  simulation.advance_to(0.25);
  const Moment moment = simulation.moment();
  const Snapshot then = simulation.snapshot(request);
  simulation.advance_to(1.0);
  const Snapshot later = simulation.snapshot(moment, request);
  EXPECT_EQ(later.time, 0.25);
  EXPECT_EQ(later.boxes[1].center, then.boxes[1].center);
  EXPECT_EQ(later.forces, then.forces);
  EXPECT_NE(simulation.snapshot(request).forces.size(), then.forces.size());
}

}  // namespace
}  // namespace wuerfel::test
