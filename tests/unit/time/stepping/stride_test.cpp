// Contacts and impulses of a step.
#include "core/time/stepping/stride.h"

#include <gtest/gtest.h>

#include "tests/support/landing_cube.h"

namespace wuerfel::test {
namespace {

TEST(Stride, ClosingSpeedsAreInUnitsOfTheFall) {
  const LandingCube landing;
  const Stride& stride = landing.stride;
  const Contact& c = stride.blows.begin()->second.start;
  EXPECT_NEAR(closing_speed(landing.system(), stride, c), 1.0 / (stride.scales.gravity * 0.1),
              1e-14);
}

TEST(Stride, NearIsNearTheSideAndBetweenItsEnds) {
  Scene scene;
  scene.cubes = {cube("a", {0.0, 0.0}), sized_cube("b", {0.0, 2.0}, {1.0, 0.5})};
  const System system = make_system(scene);
  Contact c;
  c.on = 0;
  c.from = 1;
  c.alpha = 0.5;
  c.gap = -0.04;
  EXPECT_TRUE(is_near(system, c, 0.1)) << "of 0.5 m, the smaller side";
  c.gap = 0.06;
  EXPECT_FALSE(is_near(system, c, 0.1));
  c.gap = 0.0;
  c.alpha = 1.01;
  EXPECT_FALSE(is_near(system, c, 0.1));
}

TEST(Stride, ImpulsesHaveAPartAlongTheSideWhereItRubs) {
  Contact c;
  c.normal = {0.6, 0.8};
  IslandSolution solution;
  solution.forces = {0.0, 5.0};
  EXPECT_NEAR((impulse_at(c, solution, 1) - Vec2(3.0, 4.0)).norm(), 0.0, 1e-15);
  solution.tangential = {0.0, 5.0};
  EXPECT_NEAR((impulse_at(c, solution, 1) - Vec2(-1.0, 7.0)).norm(), 0.0, 1e-15);
}

TEST(Stride, ContactsActThatHaveAnImpulseInEitherHalf) {
  LandingCube landing;
  EXPECT_EQ(acting(landing.stride).size(), 2U);
  Blow& blow = landing.stride.blows.begin()->second;
  blow.first.setZero();
  EXPECT_EQ(acting(landing.stride).size(), 1U);
  blow.second = {0.0, 1.0};
  EXPECT_EQ(acting(landing.stride).size(), 2U);
}

}  // namespace
}  // namespace wuerfel::test
