// That nothing can stand is proven by a motion; mirror images and the ends of the range of friction.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/support/reference_case.h"
#include "tests/validation/friction_checks.h"

namespace wuerfel::test {
namespace {

/// The velocity of a body's point in a virtual motion.
Vec2 velocity_in(const Scene& scene,
                 const std::vector<Twist>& motion,
                 const std::string& body,
                 const Vec2& point,
                 const std::vector<Vec2>& centres) {
  const SceneCube* c = find_cube(scene, body);
  if (c == nullptr) return Vec2::Zero();
  const auto i = c - scene.cubes.data();
  return motion[i].linear + motion[i].angular * perp(point - centres[i]);
}

// No admissible force has negative power along it: J_n a >= mu |J_t a|; that of the weight is > 0.
void expect_proof_of_fall(const Scene& scene, const Check& answer) {
  ASSERT_EQ(answer.certificate.size(), scene.cubes.size());
  double power = 0.0;
  double size = 0.0;
  std::vector<Vec2> centres;
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    centres.push_back(scene.cubes[i].position);
    power += scene.cubes[i].mass * scene.gravity.dot(answer.certificate[i].linear);
    size = std::max(size, answer.certificate[i].linear.norm());
  }
  EXPECT_GT(power, 0.0);
  for (const ContactForce& c : answer.contacts) {
    const double mu = std::sqrt(mu_of(scene, c.on) * mu_of(scene, c.from));
    const Vec2 u = velocity_in(scene, answer.certificate, c.on, c.point, centres)
                   - velocity_in(scene, answer.certificate, c.from, c.point, centres);
    EXPECT_GE(c.normal.dot(u) - mu * std::abs(perp(c.normal).dot(u)), -1e-7 * size);
  }
}

TEST(FrictionCertificate, ProvesThatThereIsNoEquilibrium) {
  for (const std::string name : {"friction_incline_slip", "friction_ladder_slides", "friction_tip",
                                 "friction_bridge_falls", "friction_slide_not_tip"}) {
    SCOPED_TRACE(name);
    const Scene scene = read_reference_case(name).scene;
    expect_proof_of_fall(scene, check_as(scene));
  }
}

/// Cubes upon one another on a slope, with the axes turned instead of the slope.
Scene random_stack(std::mt19937& dice) {
  const auto between = [&dice](double low, double high) {
    return low + (high - low) * static_cast<double>(dice()) / 4294967296.0;
  };
  std::vector<SceneCube> cubes;
  double height = 0.0;
  double x = 0.0;
  const int count = 1 + static_cast<int>(dice() % 6);
  for (int i = 0; i < count; ++i) {
    const Vec2 size(between(0.5, 2.0), between(0.3, 1.5));
    x += between(-0.3, 0.3);
    cubes.push_back(sized_cube("c" + std::to_string(i), Vec2(x, height + 0.5 * size.y()), size));
    cubes.back().mass = std::exp(between(-2.0, 2.0));
    height += size.y();
  }
  Scene scene = with_friction(on_floor(std::move(cubes)), std::exp(between(-3.0, 1.0)));
  const double slope = between(-0.5, 0.5);
  scene.gravity = g * Vec2(std::sin(slope), -std::cos(slope));
  return scene;
}

TEST(FrictionCertificate, EveryVerdictIsProven) {
  std::mt19937 dice(7);
  std::array<int, 2> of_kind{};
  for (int k = 0; k < 300; ++k) {
    SCOPED_TRACE(k);
    const Scene scene = random_stack(dice);
    const Check answer = check_as(scene);
    const bool stands = answer.verdict == Verdict::stands;
    EXPECT_NE(answer.verdict, Verdict::undecided);
    EXPECT_LE(answer.kkt_residual, 1e-10);
    const double largest = largest_force(scene, answer);
    expect_balance(scene, answer, largest);
    expect_cones(scene, answer, largest);
    if (!stands) expect_proof_of_fall(scene, answer);
    ++of_kind[stands ? 1 : 0];
  }
  EXPECT_GT(of_kind[0], 50);
  EXPECT_GT(of_kind[1], 50);
}

double force_of(const Check& answer,
                const Vec2& point,
                const Vec2& direction,
                const std::string& on) {
  double sum = 0.0;
  for (const ContactForce& c : answer.contacts) {
    const double sign = c.on == on ? 1.0 : c.from == on ? -1.0 : 0.0;
    if ((c.point - point).norm() < 1e-9)
      sum += sign * (c.force * c.normal + c.tangential * perp(c.normal)).dot(direction);
  }
  return sum;
}

TEST(FrictionSymmetry, MirrorImagesHaveMirroredAnswers) {
  for (const std::string& name : reference_case_names("friction")) {
    const ReferenceCase reference = read_reference_case(name);
    const Check one = check_as(reference.scene);
    const Check other = check_as(mirrored(reference.scene));
    EXPECT_EQ(one.verdict, other.verdict) << name;
    EXPECT_EQ(one.facts->fall_also_possible, other.facts->fall_also_possible) << name;
    double largest = g;
    for (const Twist& a : one.accelerations)
      largest = std::max({largest, a.linear.norm(), std::abs(a.angular)});
    for (std::size_t i = 0; i < one.accelerations.size(); ++i) {
      const Twist& a = one.accelerations[i];
      const Twist& b = other.accelerations[i];
      EXPECT_NEAR(a.linear.x(), -b.linear.x(), 1e-11 * largest) << name;
      EXPECT_NEAR(a.linear.y(), b.linear.y(), 1e-11 * largest) << name;
      EXPECT_NEAR(a.angular, -b.angular, 1e-11 * largest) << name;
    }
    for (const ContactForce& c : one.contacts) {
      if (find_cube(reference.scene, c.on) == nullptr) continue;
      const Vec2 there(-c.point.x(), c.point.y());
      for (const Vec2& along : {Vec2(1.0, 0.0), Vec2(0.0, 1.0)}) {
        const double sign = along.x() != 0.0 ? -1.0 : 1.0;
        EXPECT_NEAR(force_of(one, c.point, along, c.on), sign * force_of(other, there, along, c.on),
                    balance_tolerance * largest * 10.0)
            << name;
      }
    }
  }
}

TEST(FrictionLimits, HardlyAnyIsNone) {
  for (const std::string name :
       {"friction_incline_slip", "friction_ladder_slides", "friction_tip", "friction_groove_range",
        "hyper_wall_5x4", "pz_n4_falls_1em2", "random_stack_03", "incline_rectangle_moving"}) {
    const ReferenceCase reference = read_reference_case(name);
    const Check none = check_as(with_friction(reference.scene, 0.0));
    const Check little = check_as(with_friction(reference.scene, 1e-12));
    EXPECT_EQ(none.verdict, little.verdict) << name;
    EXPECT_FALSE(none.facts.has_value());
    EXPECT_TRUE(little.facts.has_value());
    for (std::size_t i = 0; i < none.accelerations.size(); ++i) {
      const Twist& a = none.accelerations[i];
      const Twist& b = little.accelerations[i];
      EXPECT_LE((a.linear - b.linear).norm(), tolerance * g) << name;
      EXPECT_NEAR(a.angular, b.angular, tolerance * g) << name;
    }
    ASSERT_EQ(none.contacts.size(), little.contacts.size());
    for (std::size_t k = 0; k < none.contacts.size(); ++k) {
      EXPECT_NEAR(none.contacts[k].force, little.contacts[k].force,
                  balance_tolerance * reference.weight())
          << name;
    }
  }
}

TEST(FrictionLimits, AnyAmountIsSolved) {
  for (const std::string name :
       {"friction_incline_slip", "friction_ladder_slides", "friction_groove_range",
        "friction_bridge_falls", "hyper_wall_5x4"}) {
    const ReferenceCase reference = read_reference_case(name);
    const Check answer = check_as(with_friction(reference.scene, 1e6));
    EXPECT_EQ(answer.verdict, Verdict::stands) << name;
    EXPECT_LE(answer.kkt_residual, 1e-10) << name;
    expect_balance(reference.scene, answer, reference.weight());
  }
  // Tips, and does not slip: about the corner, as with the friction of the case.
  const ReferenceCase tip = read_reference_case("friction_tip");
  const Check answer = check_as(with_friction(tip.scene, 1e6));
  EXPECT_EQ(answer.verdict, Verdict::falls);
  const double alpha = answer.accelerations[0].angular;
  EXPECT_NEAR(alpha, check_as(tip.scene).accelerations[0].angular, tolerance * g);
}

}  // namespace
}  // namespace wuerfel::test
