#include "core/geometry/trig.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

constexpr double tolerance = 5e-16;

TEST(Trig, SineAndCosineAreThoseOfTheLibraryToRounding) {
  RandomNumbers random(7);
  for (const double range : {1e-8, 1.0, 10.0, 1e3, 1e6}) {
    for (int trial = 0; trial < 20000; ++trial) {
      const double angle = range * random.next();
      double s = 0.0;
      double c = 0.0;
      sin_cos(angle, s, c);
      ASSERT_NEAR(s, std::sin(angle), tolerance) << angle;
      ASSERT_NEAR(c, std::cos(angle), tolerance) << angle;
    }
  }
}

TEST(Trig, RightAnglesAreExactAtZeroOnly) {
  double s = 1.0;
  double c = 0.0;
  sin_cos(0.0, s, c);
  EXPECT_EQ(s, 0.0);
  EXPECT_EQ(c, 1.0);
}

TEST(Trig, ArcTangentIsThatOfTheLibraryToRounding) {
  RandomNumbers random(8);
  for (int trial = 0; trial < 100000; ++trial) {
    const double y = random.next();
    const double x = random.next();
    ASSERT_NEAR(wuerfel::atan2(y, x), std::atan2(y, x), tolerance) << y << " " << x;
  }
  EXPECT_EQ(wuerfel::atan2(0.0, 0.0), 0.0);
  EXPECT_NEAR(wuerfel::atan2(0.0, -1.0), 3.14159265358979323846, tolerance);
  EXPECT_NEAR(wuerfel::atan2(1e-300, 1.0), 1e-300, 1e-310);
}

}  // namespace
}  // namespace wuerfel::test
