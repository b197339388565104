// The second half of a step, in closed form.
#include "core/time/stepping/landing.h"

#include <gtest/gtest.h>

#include "core/time/stepping/placement.h"
#include "tests/support/taken_steps.h"

namespace wuerfel::test {
namespace {

TEST(Landing, TheFloorStopsWhatHasComeToIt) {
  Scene scene = on_floor({cube("a", {0.0, 0.5})});
  scene.cubes[0].velocity = {0.3, -2.0};
  scene.cubes[0].mass = 3.0;
  TakenStep s(scene);
  const State after = s.land(s.m.state);
  EXPECT_NEAR(after[0].velocity.y(), 0.0, 1e-14);
  EXPECT_EQ(after[0].velocity.x(), 0.3);
  Vec2 sum = Vec2::Zero();
  ASSERT_EQ(s.stride.blows.size(), 2U);
  for (const auto& [id, blow] : s.stride.blows)
    sum += blow.second;
  EXPECT_NEAR(sum.y(), 6.0, 1e-13);
  EXPECT_EQ(s.book.cost.qp_solves, 1);
}

TEST(Landing, WhatOpensIsNotTouched) {
  Scene scene = on_floor({cube("a", {0.0, 0.5})});
  scene.cubes[0].velocity = {0.0, 2.0};
  TakenStep s(scene);
  const State after = s.land(s.m.state);
  EXPECT_EQ(after[0].velocity.y(), 2.0);
  EXPECT_EQ(s.book.cost.qp_solves, 0);
}

TEST(Landing, InelasticBlowsShareMomentumElasticOnesExchangeIt) {
  //   +---++---+    of equal mass, at 1 m/s and at rest
  //   | a || b |
  //   +---++---+
  Scene scene = flying_at(1.0);
  scene.cubes[1].position.x() = 1.0;
  for (const double e : {0.0, 0.5, 1.0}) {
    for (SceneCube& c : scene.cubes)
      c.material.restitution = e;
    TakenStep s(scene);
    const State after = s.land(s.m.state);
    EXPECT_NEAR(after[0].velocity.x(), 0.5 * (1.0 - e), 1e-13) << e;
    EXPECT_NEAR(after[1].velocity.x(), 0.5 * (1.0 + e), 1e-13) << e;
  }
}

TEST(Landing, ABlowThatThePlacementHasTakenIsLeftToTheImpactLaw) {
  for (const double e : {0.5, 1.0}) {
    Scene scene = flying_at(1.0);
    for (SceneCube& c : scene.cubes)
      c.material.restitution = e;
    TakenStep s(scene);
    State end = s.placement.find(s.stride, s.book);
    for (std::size_t i = 0; i < end.size(); ++i)
      end[i].velocity = s.stride.half[i].velocity;
    EXPECT_NEAR(end[0].velocity.x(), 0.75, 1e-7) << "it knew of no restitution";
    const State after = s.land(end);
    EXPECT_NEAR(after[0].velocity.x(), 0.5 * (1.0 - e), 1e-7) << e;
    EXPECT_NEAR(after[1].velocity.x(), 0.5 * (1.0 + e), 1e-7) << e;
    // Both halves together are what a has lost.
    Vec2 whole = s.first();
    for (const auto& [id, blow] : s.stride.blows)
      whole += blow.second;
    EXPECT_NEAR(whole.norm(), 0.5 * (1.0 + e), 1e-7) << e;
  }
}

TEST(Landing, WhatWasPressedTakesPartWhileItIsNear) {
  TakenStep s(on_floor({cube("a", {0.0, 0.5})}));
  s.placement.find(s.stride, s.book);
  ASSERT_EQ(s.stride.blows.size(), 2U);
  State lifted = s.m.state;
  lifted[0].position.y() += 0.9e-3;
  s.find_touching(lifted);
  EXPECT_EQ(s.landing.touching().size(), 2U);
  lifted[0].position.y() += 0.2e-3;
  s.find_touching(lifted);
  EXPECT_TRUE(s.landing.touching().empty()) << "1e-3 of the side is near";
}

}  // namespace
}  // namespace wuerfel::test
