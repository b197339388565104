// Eq. (1) against finite differences along random motions.
#include "core/constraints/rod.h"

#include <gtest/gtest.h>

#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

TEST(Rod, VelocityRowIsHalfTheRateOfTheSquaredLength) {
  RandomNumbers random(1);
  for (int trial = 0; trial < trials; ++trial) {
    const CubicMotion i(random);
    const CubicMotion j(random);
    const RodRow row = rod_velocity_row(i.at(0), j.at(0));
    const auto error = [&](double t) { return rod_error(i.at(t), j.at(t), 1.0); };
    EXPECT_NEAR(2.0 * (row.g.dot(i.v() - j.v()) + row.c), first_difference(error, 1e-3),
                first_tolerance);
  }
}

TEST(Rod, AccelerationRowMatchesSecondDifference) {
  RandomNumbers random(2);
  for (int trial = 0; trial < trials; ++trial) {
    const CubicMotion i(random);
    const CubicMotion j(random);
    const RodRow row = rod_acceleration_row(i.at(0), j.at(0), i.v(), j.v());
    const auto error = [&](double t) { return rod_error(i.at(t), j.at(t), 1.0); };
    EXPECT_NEAR(2.0 * (row.g.dot(i.a() - j.a()) + row.c), second_difference(error, 2e-3),
                second_tolerance);
  }
}

TEST(Rod, OfASoundCubeHasNoError) {
  const Vec2 size(2.0, 0.5);
  CubePoints points = points_of({{3.0, 4.0}, 0.7, {1.0, 0.0}, 2.0}, size);
  EXPECT_LE(largest_rod_error(points, size), 4e-15);
  // Along the first rod, of length 2, and mostly along the spoke, whose square is 1.0625.
  points.p[1] += 1e-6 * (points.p[1] - points.p[0]);
  EXPECT_NEAR(largest_rod_error(points, size), 2e-6 / 1.0625, 1e-11);
}

}  // namespace
}  // namespace wuerfel::test
