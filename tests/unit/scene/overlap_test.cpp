// Which bodies overlap, and how deeply.
#include "core/scene/overlap.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/geometry/box.h"
#include "core/scene/counter_random.h"

namespace wuerfel::test {
namespace {

SceneCube cube_at(double x, double y, double angle = 0.0, const Vec2& size = {1.0, 1.0}) {
  SceneCube cube;
  cube.position = {x, y};
  cube.angle = angle;
  cube.size = size;
  return cube;
}

Scene pair_of(const SceneCube& a, const SceneCube& b) {
  Scene scene;
  scene.cubes = {a, b};
  return scene;
}

TEST(Overlap, UpToABillionthOfTheSmallerSideIsTouching) {
  EXPECT_FALSE(find_overlap(pair_of(cube_at(0, 0), cube_at(0, 1.0))).has_value());
  EXPECT_FALSE(find_overlap(pair_of(cube_at(0, 0), cube_at(0, 1.0 - 0.9e-9))).has_value());
  const auto overlap = find_overlap(pair_of(cube_at(0, 0), cube_at(0, 1.0 - 1.1e-9)));
  ASSERT_TRUE(overlap.has_value());
  EXPECT_NEAR(overlap->depth, 1.1e-9, 1e-15);
}

TEST(Overlap, TheSmallerSideOfBothCounts) {
  const SceneCube thin = cube_at(0, 0.5 + 0.0005 - 0.5e-9, 0.0, {2.0, 0.001});
  EXPECT_TRUE(find_overlap(pair_of(cube_at(0, 0), thin)).has_value())
      << "5e-10 is 5e-7 of its thickness";
}

TEST(Overlap, DepthIsTheShortestWayOut) {
  const auto overlap = find_overlap(pair_of(cube_at(0, 0), cube_at(0.25, 0.6)));
  ASSERT_TRUE(overlap.has_value());
  EXPECT_NEAR(overlap->depth, 0.4, 1e-15);
}

TEST(Overlap, CornersIntoTurnedSidesAreFound) {
  // The diamond's half diagonal is sqrt(1/2): its corner touches the square at a distance of 0.5 +
  // that.
  const double diagonal = std::sqrt(0.5);
  const double quarter = std::atan(1.0);
  EXPECT_FALSE(
      find_overlap(pair_of(cube_at(0, 0), cube_at(0.3, 0.5 + diagonal, quarter))).has_value());
  const auto overlap = find_overlap(pair_of(cube_at(0, 0), cube_at(0.3, 0.4 + diagonal, quarter)));
  ASSERT_TRUE(overlap.has_value());
  EXPECT_NEAR(overlap->depth, 0.1, 1e-15);
  // Bounds overlap, the bodies do not: two diamonds side by side.
  EXPECT_FALSE(
      find_overlap(pair_of(cube_at(0, 0, quarter), cube_at(0.75, 0.75, quarter))).has_value());
}

TEST(Overlap, CrossedBarsOverlapThoughNoCornerIsInside) {
  const auto overlap =
      find_overlap(pair_of(cube_at(0, 0, 0.0, {4.0, 0.5}), cube_at(0, 0, 0.0, {0.5, 4.0})));
  ASSERT_TRUE(overlap.has_value());
  EXPECT_NEAR(overlap->depth, 2.25, 1e-15);
}

TEST(Overlap, PlanesAndFixedBoxesCountAgainstCubesOnly) {
  Scene scene;
  scene.cubes = {cube_at(0, 0.5)};
  scene.planes.resize(2);
  scene.planes[0].name = "floor";
  scene.planes[1].name = "wall";
  scene.planes[1].normal = {1.0, 0.0};
  scene.planes[1].point = {-0.5, 0.0};
  scene.fixed.resize(2);
  scene.fixed[0].position = {5.0, 0.0};
  scene.fixed[1].position = {5.5, 0.0};
  EXPECT_FALSE(find_overlap(scene).has_value());

  scene.cubes.push_back(cube_at(4.4, 0.8));
  auto overlap = find_overlap(scene);
  ASSERT_TRUE(overlap.has_value());
  EXPECT_EQ(overlap->first, (BodyRef{BodyKind::fixed, 0}));
  EXPECT_EQ(overlap->second, (BodyRef{BodyKind::cube, 1}));
  EXPECT_NEAR(overlap->depth, 0.2, 1e-15);

  scene.cubes[1] = cube_at(-0.25, 3.0);
  scene.cubes[1].name = "crate";
  overlap = find_overlap(scene);
  ASSERT_TRUE(overlap.has_value());
  EXPECT_EQ(overlap_message(scene, *overlap), "\"crate\" and \"wall\" overlap by 0.25 m");
}

TEST(Overlap, TheSweepFindsOneWheneverAnyPairOverlaps) {
  int overlapping = 0;
  for (std::uint64_t trial = 0; trial < 400; ++trial) {
    Scene scene;
    std::uint64_t number = 0;
    const auto next = [&] { return random_unit(trial, number++); };
    for (int i = 0; i < 12; ++i) {
      scene.cubes.push_back(
          cube_at(8.0 * next(), 8.0 * next(), 6.0 * next(), {0.1 + next(), 0.1 + next()}));
    }
    double deepest = 0.0;
    for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
      for (std::size_t j = i + 1; j < scene.cubes.size(); ++j) {
        const SceneCube& a = scene.cubes[i];
        const SceneCube& b = scene.cubes[j];
        deepest = std::max(deepest, -separation(make_box(a.position, a.angle, a.size),
                                                make_box(b.position, b.angle, b.size)));
      }
    }
    const auto overlap = find_overlap(scene);
    EXPECT_EQ(overlap.has_value(), deepest > 1e-9) << trial;
    if (overlap) {
      ++overlapping;
      EXPECT_LE(overlap->depth, deepest);
    }
  }
  EXPECT_GT(overlapping, 100);
  EXPECT_LT(overlapping, 390) << "both outcomes must occur";
}

TEST(Overlap, TenThousandTouchingCubesTakeFarLessThanASecond) {
  Scene scene;
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 100; ++column) {
      scene.cubes.push_back(cube_at(column, row));
    }
  }
  EXPECT_FALSE(find_overlap(scene).has_value());
}

TEST(Overlap, AHeapInOnePlaceIsFoundAtOnce) {
  Scene scene;
  scene.cubes.assign(200'000, cube_at(0, 0));
  EXPECT_TRUE(find_overlap(scene).has_value());
}

}  // namespace
}  // namespace wuerfel::test
