// Figure 7: the points have the mass, the centre and the inertia of the uniform rectangle.
#include "core/model/mass_distribution.h"

#include <algorithm>
#include <span>

#include <gtest/gtest.h>

#include "tests/support/reference_case.h"

namespace wuerfel::test {
namespace {

void expect_points(std::span<const PointMass> points, const nlohmann::json& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (const auto& row : expected) {
    const Vec2 arm(row[0].get<double>(), row[1].get<double>());
    const auto found = std::ranges::find_if(
        points, [&](const PointMass& p) { return (p.arm - arm).norm() < 1e-15; });
    ASSERT_NE(found, points.end());
    EXPECT_NEAR(found->mass, row[2].get<double>(), 1e-15 * 12.0);
  }
}

void expect_moments(std::span<const PointMass> points, double mass, double inertia) {
  double sum = 0.0;
  double turning = 0.0;
  Vec2 centre = Vec2::Zero();
  for (const PointMass& p : points) {
    sum += p.mass;
    centre += p.mass * p.arm;
    turning += p.mass * p.arm.squaredNorm();
  }
  EXPECT_NEAR(sum, mass, 1e-14 * mass);
  EXPECT_NEAR(centre.norm(), 0.0, 1e-14 * mass);
  EXPECT_NEAR(turning, inertia, 1e-14 * inertia);
}

class MassDistribution : public testing::TestWithParam<std::string> {};

TEST_P(MassDistribution, IsTheReference) {
  const ReferenceCase reference = read_reference_case(GetParam());
  const SceneCube& cube = reference.scene.cubes[0];
  const auto points = mass_distribution(cube.size, cube.mass);
  for (const auto& expected : reference.data["expected"]) {
    if (expected["id"] == "five_points") expect_points(points, expected["value"]);
    if (expected["id"] == "inertia")
      expect_moments(points, cube.mass, expected["value"].get<double>());
  }
}

INSTANTIATE_TEST_SUITE_P(Reference,
                         MassDistribution,
                         testing::ValuesIn(reference_case_names("check", {"mass_points"})),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace wuerfel::test
