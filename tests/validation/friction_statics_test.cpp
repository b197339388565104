// Verdicts, facts, accelerations and forces with friction against exact answers and symmetries.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/check.h"
#include "core/time/simulation.h"
#include "tests/support/reference_case.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

constexpr double tolerance = 1e-9;        // of g
constexpr double force_tolerance = 1e-8;  // of the total weight
constexpr double g = 9.81;

Check check_as(const Scene& scene, Formulation formulation = Formulation::rigid) {
  MotionSettings settings;
  settings.formulation = formulation;
  return check(scene, settings);
}

void set_friction(double mu, Scene& scene) {
  for (SceneCube& c : scene.cubes)
    c.material.friction = mu;
  for (ScenePlane& p : scene.planes)
    p.material.friction = mu;
  for (SceneFixed& f : scene.fixed)
    f.material.friction = mu;
}

Scene with_friction(Scene scene, double mu) {
  set_friction(mu, scene);
  return scene;
}

const SceneCube* find_cube(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.cubes, name, &SceneCube::name);
  return found == scene.cubes.end() ? nullptr : &*found;
}

// Newton's law of every cube under the forces that are reported, from the JSON's contract alone.
void expect_balance(const Scene& scene, const Check& answer, double largest) {
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    const SceneCube& cube = scene.cubes[i];
    const double inertia = cube.mass * cube.size.squaredNorm() / 12.0;
    Vec2 force = cube.mass * (answer.accelerations[i].linear - scene.gravity);
    double torque = inertia * answer.accelerations[i].angular;
    for (const ContactForce& c : answer.contacts) {
      const double sign = c.on == cube.name ? 1.0 : c.from == cube.name ? -1.0 : 0.0;
      const Vec2 push = sign * (c.force * c.normal + c.tangential * perp(c.normal));
      const Vec2 r = c.point - cube.position;
      force -= push;
      torque -= det(r, push);
    }
    EXPECT_LE(force.norm(), force_tolerance * largest) << cube.name;
    EXPECT_LE(std::abs(torque), force_tolerance * largest) << cube.name;
  }
}

double mu_of(const Scene& scene, const std::string& name) {
  if (const SceneCube* c = find_cube(scene, name)) return c->material.friction;
  for (const ScenePlane& p : scene.planes)
    if (p.name == name) return p.material.friction;
  for (const SceneFixed& f : scene.fixed)
    if (f.name == name) return f.material.friction;
  ADD_FAILURE() << name;
  return 0.0;
}

void expect_cones(const Scene& scene, const Check& answer, double largest) {
  for (const ContactForce& c : answer.contacts) {
    const double mu = std::sqrt(mu_of(scene, c.on) * mu_of(scene, c.from));
    EXPECT_GE(c.force, 0.0);
    EXPECT_LE(std::abs(c.tangential), mu * c.force + 1e-9 * largest);
  }
}

double largest_force(const Scene& scene, const Check& answer) {
  double largest = 0.0;
  for (const SceneCube& c : scene.cubes)
    largest += c.mass * g;
  for (const ContactForce& c : answer.contacts)
    largest = std::max(largest, c.force);
  return largest;
}

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
  const double bound = force_tolerance * weight;
  const auto& all = answer.contacts;
  if (id == "normal_force_total" || id == "normal_force") {
    EXPECT_NEAR(sum_of(answer, &ContactForce::force), value,
                force_tolerance * std::max(weight, value));
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

Scene mirrored(Scene scene) {
  scene.gravity.x() *= -1.0;
  for (SceneCube& c : scene.cubes) {
    c.position.x() *= -1.0;
    c.velocity.x() *= -1.0;
    c.angle *= -1.0;
    c.spin *= -1.0;
  }
  for (SceneFixed& f : scene.fixed) {
    f.position.x() *= -1.0;
    f.angle *= -1.0;
  }
  for (ScenePlane& p : scene.planes) {
    p.point.x() *= -1.0;
    p.normal.x() *= -1.0;
  }
  return scene;
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
                    force_tolerance * largest * 10.0)
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
    for (std::size_t k = 0; k < none.contacts.size(); ++k)
      EXPECT_NEAR(none.contacts[k].force, little.contacts[k].force,
                  force_tolerance * reference.weight())
          << name;
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
  SnapshotRequest request;
  request.forces = true;
  const Snapshot snapshot = simulation.snapshot(request);
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
