// Motion while the same contacts stay closed, against closed forms.
#include "core/time/events/smooth_phase.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/support/phases.h"

namespace wuerfel::test {
namespace {

TEST(SmoothPhase, FreeFallIsOneStepOfAnyLength) {
  Begun b(thrown());
  EXPECT_TRUE(b.phase.free());
  const SmoothStep& step = b.phase.step(0.5);
  EXPECT_EQ(step.length, 0.5);
  EXPECT_NEAR(step.end[0].position.y(), 3.5 + 1.0 - 0.5 * g * 0.25, 1e-14);
  b.phase.cut(0.2);
  EXPECT_EQ(b.phase.last().elapsed, 0.2);
  EXPECT_NEAR(b.phase.last().end[0].velocity.y(), 2.0 - 0.2 * g, 1e-14);
  b.phase.go_on();
  EXPECT_NEAR(b.phase.state()[0].position.x(), 0.2, 1e-15);
}

TEST(SmoothPhase, SlidingIsUniformlyAcceleratedAndBearsTheWeightAcross) {
  Begun b(slide());
  EXPECT_FALSE(b.phase.free());
  const std::vector<double> loads = b.phase.loads();
  EXPECT_NEAR(std::accumulate(loads.begin(), loads.end(), 0.0), 0.8 * g, 1e-13);
  double t = 0.0;
  while (t < 0.4) {
    t += b.phase.step(0.4 - t).length;
    b.phase.go_on();
  }
  const BodyState& s = b.phase.state()[0];
  EXPECT_NEAR(s.velocity.dot(Vec2(0.8, -0.6)), 0.6 * g * 0.4, 1e-13);
  EXPECT_NEAR(s.position.dot(Vec2(0.6, 0.8)), 0.5, 1e-15);
  EXPECT_NEAR(s.velocity.dot(Vec2(0.6, 0.8)), 0.0, 1e-15);
}

TEST(SmoothPhase, AnEndIsShiftedByItsAccelerations) {
  Begun b(thrown());
  b.phase.step(0.1);
  b.phase.shift_end(1e-6);
  EXPECT_NEAR(b.phase.last().elapsed, 0.1 + 1e-6, 1e-16);
  EXPECT_NEAR(b.phase.last().end[0].velocity.y(), 2.0 - g * (0.1 + 1e-6), 1e-14);
}

}  // namespace
}  // namespace wuerfel::test
