// Forces of rods and pins at an instant: trusses of the reference as scenes, and closed forms.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/check.h"
#include "core/scene/scene_parser.h"
#include "tests/support/reference_case.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

Check check_text(const std::string& text, const MotionSettings& settings = {}) {
  return check(parse_scene(text, "s.toml"), settings);
}

MotionSettings in(Formulation formulation) { return {.formulation = formulation}; }

std::string point_name(std::size_t k) { return "p" + std::to_string(k); }

/// A truss of the reference. What holds only one direction is a rod to a fixed place, and a load is the weight of one
/// more point: hanging below where it pulls down, on a frictionless slope of 45 degrees where it pulls to the right.
Scene truss_scene(const nlohmann::json& data) {
  Scene scene;
  std::vector<Vec2> p;
  for (std::size_t k = 0; k < data["points"].size(); ++k) {
    p.emplace_back(data["points"][k][0].get<double>(), data["points"][k][1].get<double>());
    scene.points.push_back({point_name(k), data["masses"][k], p.back(), Vec2::Zero(), {}});
  }
  const auto place = [](int k) {
    return ScenePlace{point_name(static_cast<std::size_t>(k)), Vec2::Zero()};
  };
  for (const auto& rod : data["rods"]) {
    const int i = rod[0];
    const int j = rod[1];
    scene.rods.push_back({"r", place(i), place(j), (p[i] - p[j]).norm()});
  }
  for (const auto& pin : data["pins"]) {
    const int k = pin[0];
    const Vec2 along = pin[1] == "x" ? Vec2::UnitX() : Vec2::UnitY();
    scene.rods.push_back({"support", place(k), {"", p[k] - along}, 1.0});
  }
  if (!data["floor_points"].empty())
    scene.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY(), {}});
  for (const auto& [k, load] : data["loads"].items()) {
    const int number = std::stoi(k);
    const Vec2 pull(load[0].get<double>(), load[1].get<double>());
    const Vec2 at = p[number] + 0.25 * pull.normalized();
    const std::string name = "load" + k;
    scene.points.push_back({name, pull.norm() / g, at, Vec2::Zero(), {}});
    scene.rods.push_back({name, place(number), {name, Vec2::Zero()}, 0.25});
    if (pull.x() <= 0.0) continue;
    const Vec2 down = 0.1 * Vec2(-1.0, -1.0).normalized();
    scene.fixed.push_back({"slope", {0.2, 0.2}, at + down, -0.25 * std::numbers::pi, {}});
  }
  return scene;
}

class TrussScene : public testing::TestWithParam<std::string> {};

TEST_P(TrussScene, ForcesAreThoseOfTheReference) {
  const ReferenceCase reference = read_reference_case(GetParam());
  const nlohmann::json& data = reference.data;
  Scene scene = truss_scene(data);
  if (!data["gravity_on"].get<bool>()) {
    // Pushed by equal forces: the same forces as on a wall under a gravity of the acceleration.
    scene = truss_scene({{"points", data["points"]},
                         {"masses", data["masses"]},
                         {"rods", data["rods"]},
                         {"pins", nlohmann::json::array()},
                         {"floor_points", nlohmann::json::array()},
                         {"loads", nlohmann::json::object()}});
    scene.gravity = {-1.0, 0.0};
    scene.planes.push_back({"wall", Vec2::Zero(), Vec2::UnitX(), {}});
  }
  for (const Formulation formulation : {Formulation::rigid, Formulation::points}) {
    const Check answer = check(scene, in(formulation));
    EXPECT_EQ(answer.verdict, Verdict::stands);
    EXPECT_LE(answer.kkt_residual, 1e-10);
    double weight = 0.0;
    for (const ScenePoint& point : scene.points)
      weight += point.mass * scene.gravity.norm();
    const std::size_t rods = data["rods"].size();
    const std::size_t pins = data["pins"].size();
    for (const auto& expected : data["expected"]) {
      const auto& value = expected["value"];
      for (std::size_t k = 0; expected["type"] == "rod_tensions" && k < rods; ++k) {
        EXPECT_NEAR(answer.rods[k].force, value[k].get<double>(), 1e-8 * weight) << "rod " << k;
        // A truss that is redundant somewhere may be determinate elsewhere; one that is not is so everywhere.
        const bool unique = answer.rods[k].unique || !expected["unique"].get<bool>();
        EXPECT_TRUE(unique) << "rod " << k;
      }
      for (std::size_t k = 0; expected["type"] == "support_forces" && k < value.size(); ++k) {
        const double force =
            k < pins ? -answer.rods[rods + k].force : answer.contacts[k - pins].force;
        EXPECT_NEAR(force, value[k].get<double>(), 1e-8 * weight) << "support " << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Reference,
                         TrussScene,
                         testing::ValuesIn(reference_case_names("rods")),
                         [](const auto& test) { return test_name(test.param); });

TEST(RodForces, OfARedundantSquareAreNotTheOnlyOnes) {
  const Check answer = check(truss_scene(read_reference_case("truss_two_diagonals").data), {});
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_FALSE(answer.rods[k].unique) << k;
  for (std::size_t k = 6; k < answer.rods.size(); ++k)
    EXPECT_TRUE(answer.rods[k].unique) << k;
}

TEST(RodForces, HoldACubeOnAnIncline) {
  const double a = std::atan2(3.0, 4.0);
  Scene scene = parse_scene(
      "plane = [{name = \"slope\", normal = [-0.6, 0.8]}]\n"
      "cube = [{name = \"a\", mass = 5, on = \"slope\"}]\n",
      "s.toml");
  const Vec2 up(0.8, 0.6);
  scene.rods.push_back({"rod", {"a", Vec2::Zero()}, {"", scene.cubes[0].position + 3.0 * up}, 3.0});
  const Check answer = check(scene, {});
  EXPECT_EQ(answer.verdict, Verdict::stands);
  ASSERT_EQ(answer.rods.size(), 1U);
  EXPECT_NEAR(answer.rods[0].force, 5.0 * g * std::sin(a), 1e-9);
  EXPECT_TRUE(answer.rods[0].unique);
}

TEST(RodForces, OfTwoBodiesThatTurnAreCentripetal) {
  const std::string text =
      "gravity = [0, 0]\n"
      "cube = [{name = \"a\", mass = 2, position = [-1.5, 0], velocity = [0, -3]},"
      "        {name = \"b\", mass = 2, position = [1.5, 0], velocity = [0, 3]}]\n"
      "rod = [{from = \"a\", to = \"b\"}]\n";
  for (const Formulation formulation : {Formulation::rigid, Formulation::points}) {
    const Check answer = check_text(text, in(formulation));
    EXPECT_EQ(answer.verdict, Verdict::moves);
    EXPECT_NEAR(answer.rods[0].force, 2.0 * 2.0 * 2.0 * 1.5, 1e-10);
    EXPECT_NEAR(answer.accelerations[0].linear.x(), 6.0, 1e-11);
  }
}

TEST(RodForces, CompressionIsNegative) {
  const Check answer = check_text(
      "point = [{name = \"p\", position = [0, 1], mass = 2}]\n"
      "rod = [{from = \"p\", to = [-1, 0]}, {from = \"p\", to = [1, 0]}]\n");
  EXPECT_EQ(answer.verdict, Verdict::stands);
  for (const RodForce& rod : answer.rods)
    EXPECT_NEAR(rod.force, -g * std::numbers::sqrt2, 1e-10);
}

TEST(PinForces, ActOnTheBodyOfFrom) {
  // A door on one hinge and a rod: moments about the hinge.
  const Check answer = check_text(
      "cube = [{name = \"door\", mass = 3, position = [0.5, 0]}]\n"
      "pin = [{name = \"hinge\", from = \"door.w\", to = [0, 0]}]\n"
      "rod = [{from = \"door.e\", to = [1, 2]}]\n");
  EXPECT_EQ(answer.verdict, Verdict::stands);
  ASSERT_EQ(answer.pins.size(), 1U);
  EXPECT_EQ(answer.pins[0].name, "hinge");
  EXPECT_NEAR(answer.rods[0].force, 1.5 * g, 1e-10);
  EXPECT_NEAR(answer.pins[0].force.x(), 0.0, 1e-10);
  EXPECT_NEAR(answer.pins[0].force.y(), 1.5 * g, 1e-10);
  EXPECT_TRUE(answer.pins[0].unique);
}

TEST(PinForces, BetweenBodiesThatDoNotTouch) {
  // Two halves of a beam pinned together, one end pinned, the other hung on a long rod: the pin at the middle makes it fall.
  // (With both ends pinned the halves, stretched out, could not move at all.)
  const std::string text =
      "cube = [{name = \"a\", size = [2, 1], position = [-0.9, 0]}, {name = \"b\", size = [2, 1], "
      "position = [0.9, 0]}]\n"
      "pin = [{from = {body = \"a\", at = [0.9, 0]}, to = {body = \"b\", at = [-0.9, 0]}},"
      "       {from = {body = \"a\", at = [-0.9, 0]}, to = [-1.8, 0]}]\n"
      "rod = [{from = {body = \"b\", at = [0.9, 0]}, to = [1.8, 10]}]\n";
  const Check answer = check_text(text);
  EXPECT_EQ(answer.verdict, Verdict::falls);
  EXPECT_TRUE(answer.contacts.empty());
  // By symmetry each half is a physical pendulum about its end: alpha = m g d / (I + m d^2).
  const double alpha = g * 0.9 / (5.0 / 12.0 + 0.81);
  EXPECT_NEAR(answer.accelerations[0].angular, -alpha, 1e-10);
  EXPECT_NEAR(answer.accelerations[1].angular, alpha, 1e-10);
}

TEST(RodsAndFriction, ShareTheLoad) {
  // Steeper than friction holds: the rod takes m g (sin a - mu cos a) at least, together with friction by least squares.
  Scene scene = parse_scene(
      "[material]\nfriction = 0.5\n"
      "[[plane]]\nname = \"slope\"\nnormal = [-0.6, 0.8]\n"
      "[[cube]]\nname = \"a\"\nmass = 5\non = \"slope\"\n",
      "s.toml");
  const Vec2 up(0.8, 0.6);
  scene.rods.push_back({"rod", {"a", Vec2::Zero()}, {"", scene.cubes[0].position + 3.0 * up}, 3.0});
  const Check answer = check(scene, {});
  EXPECT_EQ(answer.verdict, Verdict::stands);
  EXPECT_LE(answer.kkt_residual, 1e-9);
  double along = answer.rods[0].force;
  double across = 0.0;
  for (const ContactForce& c : answer.contacts) {
    along += std::abs(c.tangential);
    across += c.force;
    EXPECT_LE(std::abs(c.tangential), 0.5 * c.force * (1.0 + 1e-9));
  }
  EXPECT_NEAR(across, 5.0 * g * 0.8, 1e-8);
  EXPECT_NEAR(along, 5.0 * g * 0.6, 1e-8);
  EXPECT_FALSE(answer.rods[0].unique);
}

TEST(Rods, AreExactInBothFormulations) {
  const std::string text =
      "plane = [{}]\n"
      "cube = [{name = \"a\", position = [0, 0.5]}, {name = \"b\", position = [0.3, 1.5], mass = "
      "2},"
      "        {name = \"c\", position = [3, 4], angle = 0.4, spin = 2, velocity = [1, 0.5], size "
      "= [1, 2]}]\n"
      "rod = [{from = {body = \"b\", at = [0.2, 0.4]}, to = {body = \"c\", at = [-0.3, 0.7]}},"
      "       {from = \"a.ne\", to = [2, 6]}]\n";
  const Check rigid = check_text(text);
  const Check points = check_text(text, in(Formulation::points));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR((rigid.accelerations[k].linear - points.accelerations[k].linear).norm(), 0.0, 1e-9)
        << k;
    EXPECT_NEAR(rigid.accelerations[k].angular, points.accelerations[k].angular, 1e-9) << k;
  }
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(rigid.rods[k].force, points.rods[k].force, 1e-8) << k;
}

}  // namespace
}  // namespace wuerfel::test
