// Eq. (1) against finite differences along random motions.
#include "core/constraints/rod.h"

#include <gtest/gtest.h>

#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

constexpr int trials = 200;
// Observed: 2e-12 and 2e-9 (rounding of the second difference).
constexpr double first_tolerance = 1e-10;
constexpr double second_tolerance = 1e-7;

TEST(Rod, VelocityRowIsHalfTheRateOfTheSquaredLength) {
  RandomNumbers random(1);
  for (int trial = 0; trial < trials; ++trial) {
    const CubicMotion i(random);
    const CubicMotion j(random);
    const RodRow row = rod_velocity_row(i.at(0), j.at(0));
    const auto error = [&](double t) { return rod_error(i.at(t), j.at(t), 1.0); };
    EXPECT_NEAR(2.0 * (row.g.dot(i.v() - j.v()) + row.c), first_difference(error, 1e-3), first_tolerance);
  }
}

TEST(Rod, AccelerationRowMatchesSecondDifference) {
  RandomNumbers random(2);
  for (int trial = 0; trial < trials; ++trial) {
    const CubicMotion i(random);
    const CubicMotion j(random);
    const RodRow row = rod_acceleration_row(i.at(0), j.at(0), i.v(), j.v());
    const auto error = [&](double t) { return rod_error(i.at(t), j.at(t), 1.0); };
    EXPECT_NEAR(2.0 * (row.g.dot(i.a() - j.a()) + row.c), second_difference(error, 2e-3), second_tolerance);
  }
}

TEST(Rod, PositionRowRestoresTheLengthToFirstOrder) {
  RandomNumbers random(3);
  for (int trial = 0; trial < trials; ++trial) {
    const Vec2 p_i = random.next_vec2();
    const Vec2 p_j = p_i + random.next_vec2() + Vec2(2.0, 0.0);
    const double l = (p_i - p_j).norm() * (1.0 + 1e-6);
    const RodRow row = rod_position_row(p_i, p_j, l);
    const Vec2 d = -row.c / row.g.squaredNorm() * row.g;  // smallest d of p_i with row 0
    EXPECT_NEAR(rod_error(p_i + d, p_j, l), 0.0, 1e-10);
  }
}

}  // namespace
}  // namespace wuerfel::test
