// Eq. (2)-(8) against finite differences along random motions, at every place of the corner on the
// side.
#include "core/constraints/side.h"

#include <gtest/gtest.h>

#include "core/dynamics/pull_back.h"
#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

constexpr double first_step = 1e-3;
constexpr double second_step = 2e-3;

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

/// Eq. (3) as printed, with determinants.
double area_rate(const Triple& m) {
  const Vec2 p_i = m.i.at(0);
  const Vec2 v_i = m.i.v();
  return det(m.j.v() - v_i, m.k.at(0) - p_i) + det(m.j.at(0) - p_i, m.k.v() - v_i);
}

/// How far p_k has slid along a rigid side, times the side's length: its place in the side's frame.
double slide(const Vec2& p_i, const Vec2& p_j, const Vec2& p_k) {
  return (p_k - p_i).dot(p_i - p_j);
}

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
    EXPECT_NEAR(rate, area_rate(m), 1e-13);
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

/// A side carried by one cube and a corner carried by another, both turning; the corner is at
/// `alpha` of the side and stays on its line to first order.
struct CarriedTriple {
  CubicMotion a, b, turn_a, turn_b;
  Vec2 arm_i, arm_j, arm_k;

  CarriedTriple(RandomNumbers& random, double alpha)
      : a(random),
        b(random),
        turn_a(random),
        turn_b(random),
        arm_i(random.next_vec2()),
        arm_j(random.next_vec2()),
        arm_k(random.next_vec2()) {
    b.c[0] = a.c[0] + alpha * arm_j + (1.0 - alpha) * arm_i - arm_k;
    const Vec2 n = perp(arm_j - arm_i);
    b.c[1] -= n.dot(v_k() - alpha * v_j() - (1.0 - alpha) * v_i()) / n.squaredNorm() * n;
  }
  [[nodiscard]] static Vec2 carried(const CubicMotion& x,
                                    const CubicMotion& turn,
                                    const Vec2& arm,
                                    double t) {
    const double phi = turn.at(t).x() - turn.at(0.0).x();
    return x.at(t) + std::cos(phi) * arm + std::sin(phi) * perp(arm);
  }
  [[nodiscard]] Vec2 p_i(double t) const { return carried(a, turn_a, arm_i, t); }
  [[nodiscard]] Vec2 p_j(double t) const { return carried(a, turn_a, arm_j, t); }
  [[nodiscard]] Vec2 p_k(double t) const { return carried(b, turn_b, arm_k, t); }
  [[nodiscard]] double spin_a() const { return turn_a.v().x(); }
  [[nodiscard]] double spin_b() const { return turn_b.v().x(); }
  [[nodiscard]] Vec2 v_i() const { return a.v() + spin_a() * perp(arm_i); }
  [[nodiscard]] Vec2 v_j() const { return a.v() + spin_a() * perp(arm_j); }
  [[nodiscard]] Vec2 v_k() const { return b.v() + spin_b() * perp(arm_k); }

  /// The value of a row on points in the accelerations of the two cubes.
  [[nodiscard]] double pulled_back(const SideRow& row) const {
    RigidRow on;
    RigidRow from;
    pull_back(row.g_k, arm_k, spin_b(), on);
    pull_back(row.g_i, arm_i, spin_a(), from);
    pull_back(row.g_j, arm_j, spin_a(), from);
    return on.g[0] * b.a().x() + on.g[1] * b.a().y() + on.g[2] * turn_b.a().x()
           + from.g[0] * a.a().x() + from.g[1] * a.a().y() + from.g[2] * turn_a.a().x()
           + on.centripetal + from.centripetal + row.c;
  }
};

TEST_P(SideAt, PulledBackRowMatchesSecondDifferenceOfRigidMotions) {
  RandomNumbers random(5);
  for (int trial = 0; trial < trials; ++trial) {
    const CarriedTriple m(random, GetParam());
    const SideRow row =
        side_acceleration_row(m.arm_i, m.arm_j, GetParam(), m.v_i(), m.v_j(), m.v_k());
    const auto area = [&](double t) { return side_area(m.p_i(t), m.p_j(t), m.p_k(t)); };
    EXPECT_NEAR(m.pulled_back(row), second_difference(area, second_step), second_tolerance);
  }
}

TEST_P(SideAt, TangentRowIsTheRateOfTheSlide) {
  RandomNumbers random(6);
  for (int trial = 0; trial < trials; ++trial) {
    const CarriedTriple m(random, GetParam());
    const SideRow row = side_tangent_row(m.arm_i, m.arm_j, GetParam());
    const auto place = [&](double t) { return slide(m.p_i(t), m.p_j(t), m.p_k(t)); };
    EXPECT_NEAR(value(row, m.v_i(), m.v_j(), m.v_k()), first_difference(place, first_step),
                first_tolerance);
  }
}

TEST_P(SideAt, PulledBackTangentRowMatchesSecondDifferenceOfTheSlide) {
  RandomNumbers random(7);
  for (int trial = 0; trial < trials; ++trial) {
    const CarriedTriple m(random, GetParam());
    const SideRow row =
        side_tangent_acceleration_row(m.arm_i, m.arm_j, GetParam(), m.v_i(), m.v_j(), m.v_k());
    const auto place = [&](double t) { return slide(m.p_i(t), m.p_j(t), m.p_k(t)); };
    EXPECT_NEAR(m.pulled_back(row), second_difference(place, second_step), second_tolerance);
  }
}

TEST_P(SideAt, TangentRowIsAlsoTheRateOfAnOpeningCornersSlide) {
  // Off the line to first order: the convective term counts.
  RandomNumbers random(8);
  for (int trial = 0; trial < trials; ++trial) {
    CarriedTriple m(random, GetParam());
    m.b.c[1] += 0.5 * perp(m.arm_j - m.arm_i);
    const SideRow row =
        side_tangent_acceleration_row(m.arm_i, m.arm_j, GetParam(), m.v_i(), m.v_j(), m.v_k());
    const auto place = [&](double t) { return slide(m.p_i(t), m.p_j(t), m.p_k(t)); };
    EXPECT_NEAR(m.pulled_back(row), second_difference(place, second_step), second_tolerance);
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
