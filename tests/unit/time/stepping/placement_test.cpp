// The first half of a step, in closed form.
#include "core/time/stepping/placement.h"

#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/taken_steps.h"

namespace wuerfel::test {
namespace {

TEST(Placement, FreeFlightIsAParabolaWithoutAProgram) {
  Scene scene;
  scene.cubes = {cube("a", {0.0, 5.0})};
  scene.cubes[0].velocity = {2.0, 1.0};
  scene.cubes[0].spin = 3.0;
  TakenStep s(scene);
  const State end = s.placement.find(s.stride, s.book);
  const double fall = 0.5 * g * TakenStep::h * TakenStep::h;
  EXPECT_NEAR(end[0].position.x(), 2.0 * TakenStep::h, 1e-16);
  EXPECT_NEAR(end[0].position.y(), 5.0 + TakenStep::h - fall, 1e-15);
  EXPECT_EQ(end[0].angle, 3.0 * TakenStep::h);
  EXPECT_NEAR(s.stride.half[0].velocity.y(), 1.0 - 0.5 * g * TakenStep::h, 1e-15);
  EXPECT_TRUE(s.stride.blows.empty());
  EXPECT_EQ(s.book.cost.qp_solves, 0);
}

TEST(Placement, TheGroundCarriesTheWeightOfHalfAStep) {
  TakenStep s(on_floor({cube("a", {0.0, 0.5}), cube("b", {4.0, 0.5})}));
  const State end = s.placement.find(s.stride, s.book);
  // Margins of 5e-11 m lift at 5e-9 m/s.
  EXPECT_NEAR(s.first().y(), 2.0 * 0.5 * g * TakenStep::h, 2e-8);
  EXPECT_EQ(s.first().x(), 0.0);
  for (const int i : {0, 1}) {
    EXPECT_NEAR(end[i].position.y(), 0.5, 1.1e-10);
    EXPECT_NEAR(s.stride.half[i].velocity.y(), 0.0, 1.1e-8);
  }
}

// What a step leaves closed the next one finds closed: a pile would never come to rest.
TEST(Placement, WhatRubsDoesNotCloseGapsThatCountAsClosed) {
  Scene scene = on_floor({cube("a", {0.0, 0.5 + 5e-9})});
  scene.cubes[0].material.friction = scene.planes[0].material.friction = 0.5;
  TakenStep s(scene);
  const State end = s.placement.find(s.stride, s.book);
  EXPECT_NEAR(end[0].position.y(), 0.5 + 5e-9, 1e-15);
  EXPECT_NEAR(s.first().y(), 0.5 * g * TakenStep::h, 1e-12);
}

// Crowds are placed once, which leaves such gaps: to close them would move all that stands.
TEST(Placement, AmongManyThatRubGapsThatNobodySeesStay) {
  constexpr double gap = 5e-6;
  for (const auto& [count, height] :
       {std::pair{24, 0.5}, std::pair{25, 0.5 + gap}, std::pair{401, 0.5 + gap}}) {
    Scene scene = on_floor({});
    scene.planes[0].material.friction = 0.5;
    for (int k = 0; k < count; ++k) {
      scene.cubes.push_back(cube("c" + std::to_string(k), {1.001 * k, 0.5 + gap}));
      scene.cubes.back().material.friction = 0.5;
    }
    TakenStep s(scene);
    for (const BodyState& end : s.placement.find(s.stride, s.book))
      EXPECT_NEAR(end.position.y(), height, 1e-10) << count << " cubes";
  }
}

TEST(Placement, WhatMeetsOnTheWaySharesTheRoomByMass) {
  // p (1 + 1/3) h is the overlap of 0.005 m of free flight.
  TakenStep s(flying_at(3.0));
  const State end = s.placement.find(s.stride, s.book);
  const double p = 0.375;
  EXPECT_NEAR(s.stride.half[0].velocity.x(), 1.0 - p, 1e-8);
  EXPECT_NEAR(s.stride.half[1].velocity.x(), p / 3.0, 1e-8);
  EXPECT_NEAR(end[0].position.x(), 0.01 - 0.01 * p, 1e-10);
  EXPECT_NEAR(end[1].position.x(), 1.005 + 0.01 * p / 3.0, 1e-10);
  EXPECT_NEAR(s.first().norm(), p, 1e-8);
  EXPECT_NEAR(s.stride.half[0].velocity.x() + 3.0 * s.stride.half[1].velocity.x(), 1.0, 1e-15);
}

TEST(Placement, WhatFreeFlightDoesNotBringTogetherIsSkipped) {
  Scene scene = flying_at(1.0);
  scene.cubes[0].velocity = {0.4, 0.0};
  TakenStep s(scene);
  const State end = s.placement.find(s.stride, s.book);
  EXPECT_EQ(end[0].position.x(), 0.004);
  EXPECT_EQ(s.book.cost.qp_solves, 0);
  EXPECT_EQ(s.book.cost.skipped_certificate, 1);
}

TEST(Placement, ARodPullsAlongItsStartUntilItHasItsLength) {
  // From the height of its pivot a pendulum falls freely, and the rod pulls it back to the circle.
  //    o-------*
  for (const double speed : {0.0, 5.0}) {
    Scene scene;
    scene.points.push_back({"bob", 2.0, {1.0, 0.0}, {0.0, -speed}, {}});
    scene.rods.push_back({"rod", {"bob", Vec2::Zero()}, {"", Vec2::Zero()}, 1.0});
    TakenStep s(scene);
    const State end = s.placement.find(s.stride, s.book);
    const double fall = speed * TakenStep::h + 0.5 * g * TakenStep::h * TakenStep::h;
    const double reach = std::sqrt(1.0 - fall * fall);
    EXPECT_NEAR(end[0].position.y(), -fall, 1e-17);
    EXPECT_NEAR(end[0].position.x(), reach, 1e-13);
    // The mass times what that takes of its velocity.
    EXPECT_NEAR(std::abs(s.stride.rods_first[0]), 2.0 * (1.0 - reach) / TakenStep::h, 1e-10);
    EXPECT_TRUE(s.stride.jammed.empty());
  }
}

}  // namespace
}  // namespace wuerfel::test
