// Moreau's impact law against exact answers: velocities after all contacts hit at once, impulses
// and energy lost.
#include <gtest/gtest.h>

#include "core/time/simulation.h"
#include "tests/support/reference_case.h"

namespace wuerfel::test {
namespace {

constexpr double velocity_tolerance = 1e-9;

class Impact : public testing::TestWithParam<std::string> {};

TEST_P(Impact, VelocitiesAfterwardsAreExact) {
  const ReferenceCase reference = read_reference_case(GetParam());
  const Simulation simulation(reference.scene, {});
  for (const auto& expected : reference.data["expected"]) {
    const auto& value = expected["value"];
    if (expected["type"] == "post_impact_velocity") {
      const BodyState& s =
          simulation.states()[static_cast<std::size_t>(reference.cube(expected["body"]))];
      EXPECT_NEAR(s.velocity.x(), value["vx"].get<double>(), velocity_tolerance);
      EXPECT_NEAR(s.velocity.y(), value["vy"].get<double>(), velocity_tolerance);
      EXPECT_NEAR(s.spin, value["omega"].get<double>(), velocity_tolerance);
    } else if (expected["id"] == "kinetic_energy_lost") {
      EXPECT_NEAR(simulation.audit().impact_loss, value.get<double>(), velocity_tolerance);
    }
  }
}

TEST_P(Impact, EventsCarryUniqueImpulses) {
  const ReferenceCase reference = read_reference_case(GetParam());
  const Simulation simulation(reference.scene, {});
  for (const auto& expected : reference.data["expected"]) {
    if (expected["type"] != "contact_impulse" || !expected["unique"].get<bool>()) continue;
    const Vec2 point(expected["point"][0].get<double>(), expected["point"][1].get<double>());
    double impulse = 0.0;
    for (const Event& event : simulation.events()) {
      const bool same = event.on == expected["on"] && event.from == expected["from"];
      const bool mirrored = event.on == expected["from"] && event.from == expected["on"];
      if ((same || mirrored) && (event.point - point).norm() < 1e-6) impulse += event.impulse;
    }
    EXPECT_NEAR(impulse, expected["value"].get<double>(), velocity_tolerance) << expected["id"];
  }
}

INSTANTIATE_TEST_SUITE_P(Reference,
                         Impact,
                         testing::ValuesIn(reference_case_names("impact")),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace wuerfel::test
