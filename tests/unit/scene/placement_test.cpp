// `on` and `offset`: standing on planes, boxes and each other, touching exactly.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/geometry/box.h"
#include "core/scene/frame.h"
#include "tests/support/parameter_names.h"
#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

/// Rounding of places of a few metres; a factor 2 in a half height would give 1e-1.
constexpr double rounding = 1e-14;

Box box_of(const SceneCube& cube) { return make_box(cube.position, cube.angle, cube.size); }

TEST(Placement, OnTheFloorIsExact) {
  const Scene scene = parse_scene(
      "[[plane]]\nname = \"floor\"\n[[cube]]\nname = \"a\"\nsize = [2, 0.7]\non = "
      "\"floor\"\noffset = 0.3\n",
      "s.toml");
  EXPECT_EQ(scene.cubes[0].position, Vec2(0.3, 0.35));
  EXPECT_EQ(scene.cubes[0].angle, 0.0);
}

class PlacementOnTiltedPlanes : public ::testing::TestWithParam<double> {};

TEST_P(PlacementOnTiltedPlanes, TheCubeTakesTheAngleOfTheFaceAndTouchesWithItsLowestEdge) {
  const double tilt = GetParam();
  const Vec2 normal(-std::sin(tilt), std::cos(tilt));
  const std::string text = "[[plane]]\nname = \"slope\"\npoint = [0.3, -2]\nnormal = ["
                           + std::to_string(7.0 * normal.x()) + ", " + std::to_string(7.0 * normal.y())
                           + "]\n[[cube]]\nname = \"a\"\nsize = [1, 0.4]\non = \"slope\"\noffset = -1.7\n"
                             "[[cube]]\nname = \"b\"\non = \"a\"\noffset = 0.25\n";
  const Scene scene = parse_scene(text, "s.toml");
  const ScenePlane& plane = scene.planes[0];
  const SceneCube a = cube_named(scene, "a");
  EXPECT_NEAR(std::remainder(a.angle - tilt, 2.0 * std::numbers::pi), 0.0, 1e-6)
      << "six digits were written";
  const Box box = box_of(a);
  EXPECT_NEAR(plane.normal.dot(box.corner(0) - plane.point), 0.0, rounding);
  EXPECT_NEAR(plane.normal.dot(box.corner(1) - plane.point), 0.0, rounding);
  const Vec2 tangent(plane.normal.y(), -plane.normal.x());
  EXPECT_NEAR(tangent.dot(a.position - plane.point), -1.7, rounding);

  const SceneCube b = cube_named(scene, "b");
  EXPECT_NEAR(separation(box_of(a), box_of(b)), 0.0, rounding);
}

// Up to a quarter turn the top face of `a` is the one away from the plane.
INSTANTIATE_TEST_SUITE_P(Tilts,
                         PlacementOnTiltedPlanes,
                         ::testing::Values(-0.7, -0.1, 0.0, 0.2, 0.5, 0.75),
                         name_of_number<double>);

TEST(Placement, OnACeilingPlaneTheCubeHangsUpsideDown) {
  const Scene scene = parse_scene(
      "[[plane]]\nname = \"ceiling\"\npoint = [0, 5]\nnormal = [0, -1]\n[[cube]]\non = "
      "\"ceiling\"\n",
      "s.toml");
  EXPECT_NEAR(scene.cubes[0].position.y(), 4.5, rounding);
  EXPECT_NEAR(std::abs(scene.cubes[0].angle), std::numbers::pi, 1e-15);
}

TEST(Placement, OnATurnedBoxTheFaceThatLooksUpMostCarries) {
  for (const double angle : {-2.5, -1.2, -0.3, 0.4, 1.2, 2.0, 3.0}) {
    const Scene scene = parse_scene(
        "[[fixed]]\nname = \"box\"\nsize = [2, 0.6]\nposition = [1, 1]\nangle = "
            + std::to_string(angle) + "\n[[cube]]\nsize = 0.5\non = \"box\"\noffset = 0.1\n",
        "s.toml");
    const SceneFixed& fixed = scene.fixed[0];
    const SceneCube& cube = scene.cubes[0];
    EXPECT_NEAR(separation(make_box(fixed.position, fixed.angle, fixed.size), box_of(cube)), 0.0,
                rounding)
        << angle;
    EXPECT_LE(std::abs(std::remainder(cube.angle, 2.0 * std::numbers::pi)),
              0.25 * std::numbers::pi + 1e-12)
        << angle;
    EXPECT_GT(cube.position.y(), fixed.position.y()) << angle;
    EXPECT_NEAR(std::abs(std::remainder(cube.angle - angle, 0.5 * std::numbers::pi)), 0.0, 1e-14)
        << "along a face";
  }
}

TEST(Placement, OfTwoEquallySteepFacesTheBoxesOwnTopCarries) {
  const Frame frame = frame_on_box({0.0, 0.0}, 0.0, {2.0, 1.0}, 0.25);
  EXPECT_EQ(frame.origin, Vec2(0.25, 0.5));
  EXPECT_EQ(frame.angle, 0.0);
}

TEST(Placement, ChainsMayRunForwardAndThroughGeneratedCubes) {
  const Scene scene = parse_scene(
      "[[cube]]\nname = \"top\"\non = \"tower1_3\"\n"
      "[[tower]]\ncount = 3\non = \"table\"\noffset = 1\nlean = 0.1\n"
      "[[fixed]]\nname = \"table\"\nsize = [4, 1]\non = \"floor\"\n"
      "[[plane]]\nname = \"floor\"\npoint = [0, -1]\n",
      "s.toml");
  EXPECT_EQ(scene.fixed[0].position, Vec2(0.0, -0.5));
  EXPECT_EQ(cube_named(scene, "tower1_1").position, Vec2(1.0, 0.5));
  EXPECT_EQ(cube_named(scene, "tower1_3").position, Vec2(1.2, 2.5));
  EXPECT_EQ(cube_named(scene, "top").position, Vec2(1.2, 3.5));
}

TEST(Placement, GeneratedGroupsTurnWithTheFace) {
  const Scene scene = parse_scene(
      "[[plane]]\nname = \"slope\"\nnormal = [-0.6, 0.8]\n"
      "[[wall]]\nrows = 2\ncolumns = 2\non = \"slope\"\noffset = 5\n",
      "s.toml");
  ASSERT_EQ(scene.cubes.size(), 5U);
  const Vec2 tangent(0.8, 0.6);
  const Vec2 normal(-0.6, 0.8);
  const Vec2 expected = 5.0 * tangent - 0.75 * tangent + 1.5 * normal;
  const SceneCube half = cube_named(scene, "wall1_3");
  EXPECT_NEAR((half.position - expected).norm(), 0.0, rounding);
  EXPECT_NEAR(half.angle, std::atan2(3.0, 4.0), 1e-15);
}

TEST(Placement, LongChainsDoNotRecurse) {
  const int count = 50'000;
  std::string text = "[[plane]]\nname = \"floor\"\n";
  for (int i = 1; i < count; ++i) {
    text += "[[cube]]\non = \"cube" + std::to_string(i + 1) + "\"\n";
  }
  text += "[[cube]]\non = \"floor\"\n";
  const Scene scene = parse_scene(text, "s.toml");
  EXPECT_EQ(scene.cubes[0].position, Vec2(0.0, count - 0.5));
}

}  // namespace
}  // namespace wuerfel::test
