// What a step made is paid for, what it took is given back.
#include "core/time/stepping/step_energy.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/time/stepping/step_books.h"
#include "tests/support/landing_cube.h"

namespace wuerfel::test {
namespace {

TEST(StepEnergy, WhatAStepAddsToTheEnergyIsTakenBack) {
  LandingCube landing;
  landing.end[0].velocity = {0.7, 0.3};
  StepRecord record = record_of(landing.system(), landing.stride, landing.end);
  const double lost = sum_of(record.components[0].losses);
  State end = landing.end;
  // Along the ground nothing that the ground does can have changed the motion.
  const Rise rise = restore_energy(landing.system(), landing.stride, false, record, end);
  EXPECT_EQ(rise.unpaid, 0.0);
  EXPECT_NEAR(rise.whole, 0.5 * (0.49 + 0.09) - (0.5 - lost), 1e-14);
  EXPECT_EQ(end[0].velocity.x(), 0.7);
  EXPECT_LT(std::abs(end[0].velocity.y()), 0.3);
  State swaying = landing.end;
  restore_energy(landing.system(), landing.stride, true, record, swaying);
  EXPECT_EQ(swaying[0].velocity.y(), 0.3);
}

TEST(StepEnergy, WhatVelocitiesDoNotTakeBackIsLostByWhatLanded) {
  LandingCube landing;
  StepRecord record = record_of(landing.system(), landing.stride, landing.end);
  std::vector<StepLoss>& losses = record.components[0].losses;
  losses = {{0.4, 0.4, 0.1}};
  restore_energy(landing.system(), landing.stride, false, record, landing.end);
  ASSERT_EQ(losses.size(), 1U);
  EXPECT_NEAR(losses[0].energy, 0.5, 1e-15);  // it stands still
  losses = {{0.0, 1.0, 0.1, true}};
  restore_energy(landing.system(), landing.stride, false, record, landing.end);
  EXPECT_EQ(sum_of(losses), 0.1);  // nothing landed: a drift, which is not hidden
}

TEST(StepEnergy, WhatNoMotionCanPayForIsSaid) {
  LandingCube landing;
  StepRecord record = record_of(landing.system(), landing.stride, landing.end);
  record.components[0].losses.clear();
  landing.stride.start[0].velocity.setZero();
  landing.end[0].velocity = {0.3, 0.4};
  const Rise rise = restore_energy(landing.system(), landing.stride, false, record, landing.end);
  EXPECT_NEAR(rise.whole, 0.125, 1e-15);
  EXPECT_NEAR(rise.unpaid, 0.045, 1e-15);  // along the ground
  EXPECT_EQ(landing.end[0].velocity.y(), 0.0);
}

}  // namespace
}  // namespace wuerfel::test
