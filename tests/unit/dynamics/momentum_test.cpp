// Impulses and what they may not change.
#include "core/dynamics/momentum.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

//   +---+ +---+
//   | a | | b |   in space, both moving and turning, one turned
//   +---+ +---+
Mechanism pair_in_space() {
  Scene scene;
  scene.gravity = {0.0, -9.81};
  scene.cubes = {cube("a", {0.0, 2.0}), cube("b", {1.3, 2.2})};
  scene.cubes[0].velocity = {1.0, 0.5};
  scene.cubes[0].spin = 2.0;
  scene.cubes[1].velocity = {-1.5, 0.25};
  scene.cubes[1].spin = -0.7;
  scene.cubes[1].angle = 0.4;
  scene.cubes[1].mass = 3.0;
  return Mechanism(scene);
}

const std::vector<int> both = {0, 1};

double angular_about_origin(const System& system, const State& state) {
  const Momentum m = momentum_of(system, state, both);
  return m.angular + det(m.center, m.linear);
}

Contact corner_before_side(const Mechanism& m) {
  std::vector<Box> boxes;
  pose_boxes(m.system, m.state, boxes);
  Contact c;
  c.on = 1;
  c.from = 0;
  c.corner = 3;
  c.side = 1;
  return at_poses(m.system, boxes, c);
}

TEST(Momentum, APushChangesNoSum) {
  const Mechanism m = pair_in_space();
  State pushed = m.state;
  push(m.system, corner_before_side(m), {0.7, -1.9}, pushed);
  EXPECT_GT((pushed[1].velocity - m.state[1].velocity).norm(), 0.1);
  EXPECT_LE(
      (momentum_of(m.system, pushed, both).linear - momentum_of(m.system, m.state, both).linear)
          .norm(),
      1e-15);
  EXPECT_NEAR(angular_about_origin(m.system, pushed), angular_about_origin(m.system, m.state),
              1e-14);
}

TEST(Momentum, ThePushOfAUnitNormalChangesTheGapsRateByTheInverseMass) {
  const Mechanism m = pair_in_space();
  const Contact c = corner_before_side(m);
  State pushed = m.state;
  push(m.system, c, 2.0 * c.normal, pushed);
  const double change = gap_rate(c, contact_velocity(m.system, pushed, c))
                        - gap_rate(c, contact_velocity(m.system, m.state, c));
  EXPECT_NEAR(change,
              c.normal.dot(relative_velocity(m.system, pushed, c)
                           - relative_velocity(m.system, m.state, c)),
              1e-14);
  EXPECT_GT(change, 2.0 * (1.0 + 1.0 / 3.0));  // and turning adds to it
}

TEST(Momentum, ScalingToAnEnergyKeepsBothSums) {
  const Mechanism m = pair_in_space();
  for (const double change : {-0.3, 0.01}) {
    State state = m.state;
    const RigidMotion kept = kept_motion(momentum_of(m.system, state, both), {});
    const double goal = energy_of(m.system, state, both) + change;
    EXPECT_NEAR(scale_to_energy(m.system, both, kept, goal, 1.5, state), 0.0, 1e-12);
    EXPECT_NEAR(energy_of(m.system, state, both), goal, 1e-12);
    EXPECT_LE(
        (momentum_of(m.system, state, both).linear - momentum_of(m.system, m.state, both).linear)
            .norm(),
        1e-14);
    EXPECT_NEAR(angular_about_origin(m.system, state), angular_about_origin(m.system, m.state),
                1e-13);
  }
}

TEST(Momentum, WhatCannotBeTakenIsSaid) {
  const Mechanism m = pair_in_space();
  State state = m.state;
  const RigidMotion kept = kept_motion(momentum_of(m.system, state, both), {});
  const double missing = scale_to_energy(m.system, both, kept, -1000.0, 1.0, state);
  EXPECT_NEAR(energy_of(m.system, state, both) + missing, -1000.0, 1e-10);
  EXPECT_NEAR(state[0].spin, state[1].spin, 1e-14);  // one rigid motion is left
}

TEST(Momentum, AlongOneFloorOnlyTheWayAlongItIsKept) {
  const Mechanism m = pair_in_space();
  const std::vector<Vec2> floor = {Vec2::UnitY()};
  const std::vector<Vec2> corner = {Vec2::UnitY(), Vec2::UnitX()};
  const Momentum sum = momentum_of(m.system, m.state, both);
  EXPECT_NEAR(kept_motion(sum, floor).velocity.x(), sum.linear.x() / 4.0, 1e-15);
  EXPECT_EQ(kept_motion(sum, floor).velocity.y(), 0.0);
  EXPECT_EQ(kept_motion(sum, floor).spin, 0.0);
  EXPECT_TRUE(kept_motion(sum, corner).velocity.isZero(0.0));
}

TEST(Momentum, WhatWasMovedGoesOnTurningAsBefore) {
  const Mechanism m = pair_in_space();
  State moved = m.state;
  moved[0].position += Vec2(3e-4, -1e-4);
  moved[1].position -= Vec2(1e-4, -1e-4 / 3.0);  // the centre of mass stays
  keep_turning(m.system, {corner_before_side(m)}, m.state, moved);
  EXPECT_NEAR(angular_about_origin(m.system, moved), angular_about_origin(m.system, m.state),
              1e-13);
}

}  // namespace
}  // namespace wuerfel::test
