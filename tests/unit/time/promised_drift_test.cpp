// How far energy may drift.
#include "core/time/promised_drift.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

TEST(PromisedDrift, GrowsWithTimeFromEventToEventAndWithWhatWasLostInSteps) {
  // In motion: m v^2 / 2 + m g L.
  Scene scene = on_floor({cube("a", {0.0, 3.0})});
  scene.cubes[0].velocity = {2.0, 0.0};
  const Mechanism m(scene);
  const Scales scales = scales_of(m.system, m.state);
  const PromisedDrift drift(m.system, m.state, scales, 1e-8);
  const double in_motion = 2.0 + 9.81;
  EXPECT_NEAR(drift.of_events(0.0), 1e-7 * in_motion, 1e-20);
  EXPECT_NEAR(drift.of_events(3.0 * scales.time), 4e-7 * in_motion, 1e-19);
  EXPECT_NEAR(drift.of_steps(5.0), 1e-4 * (in_motion + 5.0), 1e-17);
}

TEST(PromisedDrift, WhatHangsFallsAsFarAsItsRodsReach) {
  // The smallest side of a double pendulum is its shorter rod; its places lie in a box of some 1.4 by 1.1 m.
  const Mechanism m(double_pendulum());
  const Scales scales = scales_of(m.system, m.state);
  const PromisedDrift drift(m.system, m.state, scales, 1.0);
  const Vec2 low(0.0, 0.0);
  const Vec2 high = m.state[0].position.cwiseMax(m.state[1].position);
  const double reach = (high - low).norm();
  ASSERT_GT(reach, scales.length);
  EXPECT_NEAR(drift.of_events(0.0), 10.0 * scales.weight * reach, 1e-12);
}

}  // namespace
}  // namespace wuerfel::test
