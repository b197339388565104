// Verdicts, facts, accelerations and forces with friction against exact answers and symmetries.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/check.h"
#include "core/time/simulation.h"
#include "tests/support/reference_case.h"
#include "tests/validation/friction_checks.h"

namespace wuerfel::test {
namespace {

double sum_of(const Check& answer, double ContactForce::*part) {
  double sum = 0.0;
  for (const ContactForce& c : answer.contacts)
    sum += c.*part;
  return sum;
}

/// The force at the contact that is lowest, or highest.
double force_at_end(const Check& answer, bool lowest) {
  const auto by_height = [](const ContactForce& a, const ContactForce& b) {
    return a.point.y() < b.point.y();
  };
  const auto [low, high] = std::ranges::minmax_element(answer.contacts, by_height);
  return lowest ? low->force : high->force;
}

void expect_fact(const std::string& id, double value, const Check& answer) {
  ASSERT_TRUE(answer.facts.has_value());
  const bool expected = value != 0.0;
  if (id == "equilibrium_exists") {
    EXPECT_EQ(answer.facts->equilibrium_exists, expected);
    EXPECT_EQ(answer.verdict, expected ? Verdict::stands : Verdict::falls);
    EXPECT_EQ(answer.certificate.empty(), expected);
  }
  if (id == "motion_exists") {
    EXPECT_EQ(answer.facts->fall_also_possible, expected);
  }
}

void expect_force(const std::string& id, double value, const Check& answer, double weight) {
  const double bound = balance_tolerance * weight;
  const auto& all = answer.contacts;
  if (id == "normal_force_total" || id == "normal_force") {
    EXPECT_NEAR(sum_of(answer, &ContactForce::force), value,
                balance_tolerance * std::max(weight, value));
  }
  if (id == "friction_force_total" || id == "tangential_force_uphill") {
    EXPECT_NEAR(std::abs(sum_of(answer, &ContactForce::tangential)), value, bound);
  }
  if (id == "normal_force_lower_corner") {
    EXPECT_NEAR(force_at_end(answer, true), value, bound);
  }
  if (id == "normal_force_upper_corner") {
    EXPECT_NEAR(force_at_end(answer, false), value, bound);
  }
  if (id.starts_with("canonical_")) {
    for (const ContactForce& c : all) {
      const double part = id == "canonical_normal" ? c.force : std::abs(c.tangential);
      EXPECT_NEAR(part, value, bound) << c.from;
      EXPECT_FALSE(c.unique);
    }
  }
}

void expect_motion(const std::string& id, double value, const Check& answer) {
  const Twist& a = answer.accelerations.front();
  if (id == "slope_acceleration") {
    EXPECT_NEAR(a.linear.norm(), value, tolerance * g);
  }
  if (id == "angular_acceleration") {
    EXPECT_NEAR(a.angular, value, tolerance * g);
  }
}

void expect_accelerations(const nlohmann::json& value, const Twist& a) {
  const double x = value.at("ax");
  const double y = value.at("ay");
  const double alpha = value.at("alpha");
  const double bound = tolerance * std::max({g, std::abs(x), std::abs(y), std::abs(alpha)});
  EXPECT_NEAR(a.linear.x(), x, bound);
  EXPECT_NEAR(a.linear.y(), y, bound);
  EXPECT_NEAR(a.angular, alpha, bound);
}

class FrictionStatics : public testing::TestWithParam<std::tuple<std::string, Formulation>> {};

TEST_P(FrictionStatics, AgreesWithTheExactAnswer) {
  const ReferenceCase reference = read_reference_case(std::get<0>(GetParam()));
  const Check answer = check_as(reference.scene, std::get<1>(GetParam()));
  const double largest = largest_force(reference.scene, answer);
  EXPECT_LE(answer.kkt_residual, 1e-10);
  expect_balance(reference.scene, answer, largest);
  expect_cones(reference.scene, answer, largest);
  for (const auto& expected : reference.data["expected"]) {
    const std::string id = expected["id"];
    SCOPED_TRACE(id);
    if (expected["type"] == "classification") {
      const bool rest = expected["value"] == "rest";
      EXPECT_EQ(answer.verdict, rest ? Verdict::stands : Verdict::falls);
    } else if (expected["type"] == "acceleration") {
      expect_accelerations(expected["value"],
                           answer.accelerations[reference.cube(expected["body"])]);
    } else if (expected["value"].is_number()) {
      expect_fact(id, expected["value"], answer);
      expect_force(id, expected["value"], answer, reference.weight());
      expect_motion(id, expected["value"], answer);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Reference,
                         FrictionStatics,
                         testing::Combine(testing::ValuesIn(reference_case_names("friction")),
                                          testing::Values(Formulation::rigid, Formulation::points)),
                         [](const auto& of) {
                           const bool rigid = std::get<1>(of.param) == Formulation::rigid;
                           return test_name(std::get<0>(of.param)) + (rigid ? "_rigid" : "_points");
                         });

/// The coefficient above which a case stands; 0 where it has none.
double critical_friction(const ReferenceCase& reference) {
  for (const auto& expected : reference.data["expected"]) {
    const std::string id = expected["id"];
    if (id == "mu_critical" || id == "mu_required_to_stick") return expected["value"];
  }
  return 0.0;
}

TEST(FrictionThresholds, AreSharp) {
  int thresholds = 0;
  for (const std::string& name : reference_case_names("friction")) {
    const ReferenceCase reference = read_reference_case(name);
    const double mu = critical_friction(reference);
    if (mu == 0.0 || name == "friction_painleve_below") continue;
    ++thresholds;
    for (const Formulation formulation : {Formulation::rigid, Formulation::points}) {
      const Check below = check_as(with_friction(reference.scene, mu * (1.0 - 1e-6)), formulation);
      const Check above = check_as(with_friction(reference.scene, mu * (1.0 + 1e-6)), formulation);
      EXPECT_EQ(below.verdict, Verdict::falls) << name;
      EXPECT_FALSE(below.certificate.empty()) << name;
      EXPECT_EQ(above.verdict, Verdict::stands) << name;
    }
  }
  EXPECT_GE(thresholds, 7);
}

TEST(FrictionThresholds, BeyondPainleveThereIsNoAcceleration) {
  const ReferenceCase reference = read_reference_case("friction_painleve_below");
  const double mu = critical_friction(reference);
  const Check below = check_as(with_friction(reference.scene, mu * (1.0 - 1e-3)));
  EXPECT_FALSE(below.jams);
  for (const double beyond : {1.0 + 1e-6, 1.0 + 1e-3, 2.0}) {
    const Check answer = check_as(with_friction(reference.scene, mu * beyond));
    EXPECT_EQ(answer.verdict, Verdict::moves);
    EXPECT_TRUE(answer.jams);
  }
}

TEST(FrictionFacts, AreThreeApart) {
  const Scene floor = with_friction(on_floor({cube("a", Vec2(0.0, 0.5))}), 0.5);
  const Check stands = check_as(floor);
  EXPECT_TRUE(stands.facts->equilibrium_exists);
  EXPECT_TRUE(stands.facts->stands_without_friction);
  EXPECT_FALSE(stands.facts->fall_also_possible);
  const Check shaft = check_as(read_reference_case("friction_shaft").scene);
  EXPECT_TRUE(shaft.facts->equilibrium_exists);
  EXPECT_FALSE(shaft.facts->stands_without_friction);
  EXPECT_TRUE(shaft.facts->fall_also_possible);
  for (const double side : {1e-9, 1e-5, 1e5}) {
    Scene grain = with_friction(on_floor({sized_cube("a", {0.0, 0.5 * side}, {side, side})}), 0.4);
    grain.gravity = Vec2(0.2 * -g, -g);
    EXPECT_FALSE(check_as(grain).facts->fall_also_possible) << side;
  }
  const Check held = check_as(read_reference_case("friction_ladder_stands").scene);
  EXPECT_TRUE(held.facts->equilibrium_exists);
  EXPECT_FALSE(held.facts->stands_without_friction);
  EXPECT_FALSE(held.facts->fall_also_possible);
}

TEST(FrictionInMotion, SlidersAreBraked) {
  for (const double v : {2.0, -2.0}) {
    Scene scene = with_friction(on_floor({cube("a", Vec2(0.0, 0.5))}), 0.3);
    scene.cubes[0].velocity.x() = v;
    const Check answer = check_as(scene);
    EXPECT_EQ(answer.verdict, Verdict::moves);
    EXPECT_NEAR(answer.accelerations[0].linear.x(), v > 0.0 ? -0.3 * g : 0.3 * g, 1e-12);
    EXPECT_NEAR(answer.accelerations[0].linear.y(), 0.0, 1e-12);
    expect_balance(scene, answer, g);
  }
}

TEST(FrictionInMotion, ImpactsAtTheStartComeFirst) {
  Scene scene = with_friction(on_floor({cube("a", Vec2(0.0, 0.5))}), 0.3);
  scene.cubes[0].velocity = Vec2(0.1, -1.0);  // friction of the blow takes all of it
  EXPECT_EQ(check_as(scene).verdict, Verdict::stands);
  scene.cubes[0].velocity.x() = 1.0;
  EXPECT_EQ(check_as(scene).verdict, Verdict::moves);
  scene.cubes[0].velocity.x() = 0.1;
  scene.cubes[0].material.restitution = scene.planes[0].material.restitution = 0.5;
  const Check bounced = check_as(scene);
  EXPECT_EQ(bounced.verdict, Verdict::moves);
  EXPECT_NEAR(bounced.accelerations[0].linear.y(), -g, 1e-12);
}

TEST(FrictionSnapshot, ShowsForcesAlongSides) {
  const ReferenceCase reference = read_reference_case("friction_incline_stick");
  Simulation simulation(reference.scene, {});
  const Snapshot snapshot = simulation.snapshot({.forces = true});
  Vec2 sum = Vec2::Zero();
  double along = 0.0;
  for (const SnapshotForce& force : snapshot.forces) {
    sum += force.force;
    if (force.kind == ForceKind::friction) along += force.force.norm();
  }
  EXPECT_LE((sum + reference.scene.cubes[0].mass * reference.scene.gravity).norm(), 1e-8);
  EXPECT_NEAR(along, 11.46058181414358, 1e-8);
}

}  // namespace
}  // namespace wuerfel::test
