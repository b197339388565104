// When contacts let go, in closed form.
#include "core/time/events/force_events.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "tests/support/phases.h"

namespace wuerfel::test {
namespace {

TEST(ForceEvents, WhatIsPressedAllTheTimeDoesNotLetGo) {
  Begun b(slide());
  ForceEvents forces;
  forces.begin(b.phase, 1e-11);
  b.phase.step(0.3);
  EXPECT_FALSE(forces.first(b.phase, 1.0, g, b.work).has_value());
}

TEST(ForceEvents, ABlockOverAnEdgeLetsGoOfTheCornerThatItTipsAwayFrom) {
  //    +-----+-->      the centre passes the end of the post: the load of the rear end of the overlap
  //    |  a  |         m g (x_end - x) / overlap vanishes where it is above the end
  //  ######
  Scene scene;
  scene.fixed = {post("shelf", {-2.0, -0.5}, {4.0, 1.0})};
  scene.cubes = {cube("a", {-0.3, 0.5})};
  scene.cubes[0].velocity = {1.0, 0.0};
  Begun b(scene);
  ASSERT_EQ(b.phase.loads().size(), 2U);
  ForceEvents forces;
  forces.begin(b.phase, 1e-11);
  double t = 0.0;
  std::optional<ForceEvents::First> first;
  while (!first) {
    const double length = b.phase.step(0.5).length;
    first = forces.first(b.phase, 1.0, g, b.work);
    t += first ? first->share * length : length;
    ASSERT_LT(t, 0.31);
    b.phase.go_on();
    forces.passed(b.phase.loads());
  }
  EXPECT_NEAR(t, 0.3, 1e-8);
}

TEST(ForceEvents, AWallLetsGoWhereALadderHasSlidToTwoThirdsOfItsHeight) {
  //  |\          without friction the load of the wall vanishes where sin(theta) is 2/3 of what it was at the start
  //  | \         (rod without thickness; a plank of 1/1000 is as good to 1e-2)
  //  |__\__
  const double length = 2.0;
  const double width = 0.002;
  const double angle = 1.2;
  const Box box = make_box(Vec2::Zero(), -angle, {length, width});
  Vec2 low = Vec2::Zero();
  for (int k = 0; k < Box::corners; ++k)
    low = low.cwiseMin(box.arm[k]);
  Scene scene = on_floor({sized_cube("ladder", -low, {length, width}, -angle)});
  scene.planes.push_back({"wall", Vec2::Zero(), Vec2::UnitX(), {}});
  Begun b(scene);
  ASSERT_EQ(b.phase.loads().size(), 2U);
  ForceEvents forces;
  forces.begin(b.phase, 1e-11);
  std::optional<ForceEvents::First> first;
  for (int steps = 0; !first && steps < 1000; ++steps) {
    b.phase.step(0.1);
    first = forces.first(b.phase, 1.0, g, b.work);
    if (first) b.phase.cut(first->share * b.phase.last().length);
    b.phase.go_on();
    forces.passed(b.phase.loads());
  }
  ASSERT_TRUE(first);
  ASSERT_TRUE(first->load);
  EXPECT_NEAR(b.phase.loads()[*first->load], 0.0, 1e-6);
  EXPECT_NEAR(std::sin(-b.phase.state()[0].angle), 2.0 / 3.0 * std::sin(angle), 1e-2);
}

TEST(ForceEvents, IsLookedForUpToTheShareThatIsGiven) {
  Scene scene;
  scene.fixed = {post("shelf", {-2.0, -0.5}, {4.0, 1.0})};
  scene.cubes = {cube("a", {-0.01, 0.5})};
  scene.cubes[0].velocity = {1.0, 0.0};
  Begun b(scene);
  ForceEvents forces;
  forces.begin(b.phase, 1e-11);
  const double length = b.phase.step(0.02).length;
  ASSERT_NEAR(length, 0.02, 1e-15);
  EXPECT_FALSE(forces.first(b.phase, 0.4, g, b.work));
  EXPECT_TRUE(forces.first(b.phase, 0.6, g, b.work));
}

}  // namespace
}  // namespace wuerfel::test
