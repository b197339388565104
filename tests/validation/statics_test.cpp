// Accelerations, forces and verdicts of the reference cases against exact answers.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/support/reference_case.h"

namespace wuerfel::test {
namespace {

constexpr double acceleration_tolerance = 1e-9;  // of g
constexpr double force_tolerance = 1e-8;         // of the total weight

struct Way {
  Formulation formulation;
  QpMethod solver;
};

class Statics : public testing::TestWithParam<std::tuple<std::string, Way>> {};

double force_at(const Check& check, const nlohmann::json& expected) {
  const Vec2 point(expected["point"][0].get<double>(), expected["point"][1].get<double>());
  const Vec2 normal(expected["normal"][0].get<double>(), expected["normal"][1].get<double>());
  double sum = 0.0;
  for (const ContactForce& c : check.contacts) {
    if ((c.point - point).norm() > 1e-6) continue;
    const bool same =
        c.on == expected["on"] && c.from == expected["from"] && c.normal.dot(normal) > 0.999;
    const bool mirrored =
        c.on == expected["from"] && c.from == expected["on"] && c.normal.dot(normal) < -0.999;
    if (same || mirrored) sum += c.force;
  }
  return sum;
}

TEST_P(Statics, AgreesWithTheExactAnswer) {
  const ReferenceCase reference = read_reference_case(std::get<0>(GetParam()));
  const MotionSettings settings{.formulation = std::get<1>(GetParam()).formulation,
                                .solver = std::get<1>(GetParam()).solver};
  const Check answer = check(reference.scene, settings);
  const double g = reference.scene.gravity.norm();
  // Rods of the light cubes carry the heavy ones: rounding of those forces alone accelerates a
  // light point by more than what counts as standing. Both verdicts that are open then are honest.
  const bool rods_drown =
      settings.formulation == Formulation::points && reference.name.starts_with("massratio");
  for (const auto& expected : reference.data["expected"]) {
    const std::string type = expected["type"];
    if (type == "classification") {
      if (rods_drown && answer.verdict == Verdict::undecided) continue;
      const bool rest = expected["value"] == "rest";
      EXPECT_EQ(answer.verdict == Verdict::stands, rest) << to_string(answer.verdict);
      EXPECT_NE(answer.verdict, Verdict::undecided);
    } else if (type == "acceleration") {
      const Twist& a =
          answer.accelerations[static_cast<std::size_t>(reference.cube(expected["body"]))];
      EXPECT_NEAR(a.linear.x(), expected["value"]["ax"].get<double>(), acceleration_tolerance * g);
      EXPECT_NEAR(a.linear.y(), expected["value"]["ay"].get<double>(), acceleration_tolerance * g);
      EXPECT_NEAR(a.angular, expected["value"]["alpha"].get<double>(), acceleration_tolerance * g);
    } else if (type == "contact_force") {
      EXPECT_NEAR(force_at(answer, expected), expected["value"].get<double>(),
                  force_tolerance * reference.weight())
          << expected["id"];
    } else if (type == "objective") {
      const double value = expected["value"];
      EXPECT_NEAR(answer.objective, value, 1e-9 * std::max(1.0, std::abs(value)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Reference,
    Statics,
    testing::Combine(testing::ValuesIn(reference_case_names("qp_geometry")),
                     testing::Values(Way{Formulation::rigid, QpMethod::automatic},
                                     Way{Formulation::rigid, QpMethod::newton},
                                     Way{Formulation::rigid, QpMethod::interior_point},
                                     Way{Formulation::rigid, QpMethod::ipopt},
                                     Way{Formulation::points, QpMethod::automatic},
                                     Way{Formulation::points, QpMethod::ipopt})),
    [](const auto& test) {
      const Way& way = std::get<1>(test.param);
      return test_name(std::get<0>(test.param) + "-" + std::string(to_string(way.formulation)) + "-"
                       + std::string(to_string(way.solver)));
    });

}  // namespace
}  // namespace wuerfel::test
