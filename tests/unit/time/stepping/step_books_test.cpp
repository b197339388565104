// The books of a step that is made up by hand.
#include "core/time/stepping/step_books.h"

#include <gtest/gtest.h>

#include "core/dynamics/momentum.h"
#include "core/time/stepping/step_energy.h"
#include "tests/support/landing_cube.h"

namespace wuerfel::test {
namespace {

TEST(StepBooks, WhatClosesLosesWhatItsImpulsesTake) {
  const LandingCube landing;
  const StepRecord record = record_of(landing.system(), landing.stride, landing.end);
  ASSERT_EQ(record.components.size(), 1U);
  EXPECT_EQ(record.components[0].cubes, std::vector<int>{0});
  EXPECT_NEAR(sum_of(record.components[0].losses), 0.5, 1e-15);
  ASSERT_EQ(record.impulses.size(), 2U);
  for (const StepImpulse& p : record.impulses) {
    EXPECT_NEAR(p.begin, 0.4, 1e-14);
    EXPECT_EQ(p.end, p.begin);
  }
  EXPECT_NEAR(record.impulses[0].turn_on + record.impulses[1].turn_on, 0.0, 1e-16);
}

/// Slower than an impact: 0.1 g h at 0.04 g h^2 from the ground, 0.2 of the step away in free fall.
StepRecord record_of_slow_landing(double opening) {
  LandingCube landing;
  Stride& stride = landing.stride;
  const double gh = stride.scales.gravity * stride.h;
  stride.start[0].velocity = {0.0, -0.1 * gh};
  landing.end[0].velocity = {0.0, opening * gh};
  for (auto& [id, blow] : stride.blows)
    blow.start.gap = 0.04 * gh * stride.h;
  return record_of(landing.system(), stride, landing.end);
}

TEST(StepBooks, WhatLandsSlowlyActsAndLosesFromThenOn) {
  const StepRecord record = record_of_slow_landing(0.0);
  for (const StepImpulse& p : record.impulses) {
    EXPECT_NEAR(p.begin, 0.2, 1e-14);
    EXPECT_EQ(p.end, 1.0);
  }
  ASSERT_FALSE(record.components[0].losses.empty());
  const StepLoss& loss = record.components[0].losses.front();
  EXPECT_NEAR(loss.by(0.6), 0.5 * loss.energy, 1e-14);
  EXPECT_EQ(loss.by(0.1), 0.0);
  EXPECT_EQ(loss.by(1.0), loss.energy);
}

TEST(StepBooks, WhatOpensAtFirstAndActsAllTheSameHasLanded) {
  // It loses nothing by its own work; what the step misses beyond is its loss, and no drift.
  LandingCube landing;
  landing.stride.start[0].velocity = {0.0, 0.4};
  StepRecord record = record_of(landing.system(), landing.stride, landing.end);
  EXPECT_EQ(sum_of(record.components[0].losses), 0.0);
  restore_energy(landing.system(), landing.stride, false, record, landing.end);
  EXPECT_NEAR(sum_of(record.components[0].losses), 0.08, 1e-15);
}

TEST(StepBooks, WhatBouncesActsAtOnce) {
  for (const StepImpulse& p : record_of_slow_landing(0.1).impulses) {
    EXPECT_NEAR(p.begin, 0.2, 1e-14);
    EXPECT_EQ(p.end, p.begin);
  }
}

TEST(StepBooks, ImpactsHappenWhenTheGapCloses) {
  const LandingCube landing;
  const std::vector<Event> events = impacts_of(landing.system(), landing.stride, 3.0);
  ASSERT_EQ(events.size(), 2U);
  for (const Event& e : events) {
    EXPECT_NEAR(e.t, 3.04, 1e-14);
    EXPECT_NEAR(e.impulse, 0.5, 1e-16);
    EXPECT_EQ(e.on, "a");
    EXPECT_EQ(e.from, "floor");
  }
}

/// Without restitution and without weight: it opens at `speed` g h from the ground that it stands on, and comes back.
double loss_of_opening(double speed) {
  LandingCube landing;
  Stride& stride = landing.stride;
  stride.start[0].position.y() = stride.before[0].position.y() = 0.5;
  stride.start[0].velocity = {0.0, speed * stride.scales.gravity * stride.h};
  stride.half = stride.start;
  stride.before[0].velocity = {0.0, -1.0};
  for (auto& [id, blow] : stride.blows) {
    blow.start.gap = blow.end.gap = 0.0;
    blow.first.setZero();
    blow.second = {0.0, 0.5};
  }
  return sum_of(record_of(landing.system(), stride, landing.end).components.front().losses);
}

TEST(StepBooks, WhatOpensAndLandsIsLostWhatLastsIsSway) {
  EXPECT_NEAR(loss_of_opening(0.1), 0.5, 1e-14);
  EXPECT_EQ(loss_of_opening(1e-3), 0.0);
}

// Or energy that is put right moves all that stands along with the little that moves.
TEST(StepBooks, GroundThatRubsHoldsWhatDoesNotSlideInAllDirections) {
  const auto kept_along = [](const LandingCube& landing) {
    const StepRecord record = record_of(landing.system(), landing.stride, landing.end);
    const StepComponent& part = record.components.at(0);
    State fast = landing.end;
    fast[0].velocity = {1.0, 1.0};
    return kept_motion(momentum_of(landing.system(), fast, part.cubes), part.held_along).velocity;
  };
  LandingCube landing(0.5);
  EXPECT_TRUE(kept_along(landing).isZero(0.0));
  landing.end[0].velocity.x() = 0.1;
  EXPECT_EQ(kept_along(landing), Vec2(1.0, 0.0));
  EXPECT_EQ(kept_along(LandingCube()), Vec2(1.0, 0.0));
  EXPECT_EQ(kept_along(LandingCube(0.5, 0.5)),
            Vec2(1.0, 0.0));  // more is put right where it bounces
}

}  // namespace
}  // namespace wuerfel::test
