// Eq. (2)-(8) against finite differences along random motions, at every place of the corner on the
// side.
#include "core/constraints/side.h"

#include <gtest/gtest.h>

#include "core/dynamics/pull_back.h"
#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

constexpr int trials = 200;
constexpr double first_step = 1e-3;
constexpr double second_step = 2e-3;
constexpr double first_tolerance = 1e-10;
constexpr double second_tolerance = 1e-7;

/// Three points that move at random; p_k starts on the side at `alpha` and, if asked for, with A' =
/// 0.
struct Triple {
  CubicMotion i;
  CubicMotion j;
  CubicMotion k;

  Triple(RandomNumbers& random, double alpha, bool at_rest) : i(random), j(random), k(random) {
    k.c[0] = alpha * j.c[0] + (1.0 - alpha) * i.c[0];
    if (!at_rest) return;
    const Vec2 n = perp(j.c[0] - i.c[0]);
    const double rate = n.dot(k.v() - alpha * j.v() - (1.0 - alpha) * i.v());
    k.c[1] -= rate / n.squaredNorm() * n;
  }
  [[nodiscard]] double area(double t) const { return side_area(i.at(t), j.at(t), k.at(t)); }
};

double value(const SideRow& row, const Vec2& x_i, const Vec2& x_j, const Vec2& x_k) {
  return row.g_i.dot(x_i) + row.g_j.dot(x_j) + row.g_k.dot(x_k) + row.c;
}

class SideAt : public testing::TestWithParam<double> {};

TEST_P(SideAt, ParameterIsThatOfEquation5) {
  RandomNumbers random(1);
  for (int trial = 0; trial < trials; ++trial) {
    const Triple m(random, GetParam(), false);
    EXPECT_NEAR(edge_parameter(m.i.at(0), m.j.at(0), m.k.at(0)), GetParam(), 1e-12);
    EXPECT_NEAR(m.area(0.0), 0.0, 1e-14);
  }
}

TEST_P(SideAt, VelocityRowIsTheRateOfTheArea) {
  RandomNumbers random(2);
  for (int trial = 0; trial < trials; ++trial) {
    const Triple m(random, GetParam(), false);
    const SideRow row = side_velocity_row(m.i.at(0), m.j.at(0), GetParam());
    const double rate = value(row, m.i.v(), m.j.v(), m.k.v());
    EXPECT_NEAR(rate, first_difference([&](double t) { return m.area(t); }, first_step),
                first_tolerance);
    EXPECT_NEAR(rate, side_area_rate(m.i.at(0), m.j.at(0), m.k.at(0), m.i.v(), m.j.v(), m.k.v()),
                1e-13);
  }
}

TEST_P(SideAt, AccelerationRowMatchesSecondDifference) {
  RandomNumbers random(3);
  for (int trial = 0; trial < trials; ++trial) {
    const Triple m(random, GetParam(), true);
    const SideRow row =
        side_acceleration_row(m.i.at(0), m.j.at(0), GetParam(), m.i.v(), m.j.v(), m.k.v());
    EXPECT_NEAR(value(row, m.i.a(), m.j.a(), m.k.a()),
                second_difference([&](double t) { return m.area(t); }, second_step),
                second_tolerance);
  }
}

TEST_P(SideAt, AccelerationRowOfDeterminantsIsThatOfThePaper) {
  RandomNumbers random(4);
  for (int trial = 0; trial < trials; ++trial) {
    const Triple m(random, GetParam(), true);
    const SideRow row =
        side_acceleration_row(m.i.at(0), m.j.at(0), GetParam(), m.i.v(), m.j.v(), m.k.v());
    EXPECT_NEAR(row.c,
                2.0 * (det(m.i.v(), m.j.v()) + det(m.j.v(), m.k.v()) + det(m.k.v(), m.i.v())),
                1e-13);
  }
}

TEST_P(SideAt, PulledBackRowMatchesSecondDifferenceOfRigidMotions) {
  RandomNumbers random(5);
  for (int trial = 0; trial < trials; ++trial) {
    // A cube that carries the side and one that carries the corner, both turning.
    const double alpha = GetParam();
    const Vec2 arm_i = random.next_vec2();
    const Vec2 arm_j = random.next_vec2();
    const Vec2 arm_k = random.next_vec2();
    CubicMotion a(random);
    CubicMotion b(random);
    const CubicMotion turn_a(random);
    const CubicMotion turn_b(random);
    b.c[0] = a.c[0] + alpha * arm_j + (1.0 - alpha) * arm_i - arm_k;
    const auto carried = [](const CubicMotion& x, const CubicMotion& turn, const Vec2& arm,
                            double t) {
      const double phi = turn.at(t).x() - turn.at(0.0).x();
      return Vec2(x.at(t) + std::cos(phi) * arm + std::sin(phi) * perp(arm));
    };
    const double spin_a = turn_a.v().x();
    const double spin_b = turn_b.v().x();
    const Vec2 v_i = a.v() + spin_a * perp(arm_i);
    const Vec2 v_j = a.v() + spin_a * perp(arm_j);
    Vec2 v_k = b.v() + spin_b * perp(arm_k);
    const Vec2 n = perp(arm_j - arm_i);
    const Vec2 shift = -n.dot(v_k - alpha * v_j - (1.0 - alpha) * v_i) / n.squaredNorm() * n;
    b.c[1] += shift;
    v_k += shift;

    const SideRow row = side_acceleration_row(arm_i, arm_j, alpha, v_i, v_j, v_k);
    RigidRow on;
    RigidRow from;
    pull_back(row.g_k, arm_k, spin_b, on);
    pull_back(row.g_i, arm_i, spin_a, from);
    pull_back(row.g_j, arm_j, spin_a, from);
    const double rigid = on.g[0] * b.a().x() + on.g[1] * b.a().y() + on.g[2] * turn_b.a().x()
                         + from.g[0] * a.a().x() + from.g[1] * a.a().y()
                         + from.g[2] * turn_a.a().x() + on.centripetal + from.centripetal + row.c;
    const auto area = [&](double t) {
      return side_area(carried(a, turn_a, arm_i, t), carried(a, turn_a, arm_j, t),
                       carried(b, turn_b, arm_k, t));
    };
    EXPECT_NEAR(rigid, second_difference(area, second_step), second_tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Places,
                         SideAt,
                         testing::Values(0.0, 1e-9, 0.25, 0.5, 1.0 - 1e-9, 1.0),
                         [](const auto& test) { return "Number" + std::to_string(test.index); });

TEST(Side, IsPositiveToTheLeftOfIToJ) {
  EXPECT_GT(side_area({0, 0}, {1, 0}, {0.5, 0.1}), 0.0);
  EXPECT_LT(side_area({0, 0}, {1, 0}, {0.5, -0.1}), 0.0);
  EXPECT_EQ(side_area({0, 0}, {2, 0}, {7, 3}), 6.0);  // twice the triangle's area
}

}  // namespace
}  // namespace wuerfel::test
