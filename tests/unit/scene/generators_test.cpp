// Towers, walls, pyramids and piles.
#include <string>

#include <gtest/gtest.h>

#include "core/geometry/box.h"
#include "core/scene/counter_random.h"
#include "core/scene/overlap.h"
#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

/// Gaps between touching bodies: rounding of places of a few metres. A misplaced body gives 1e-2
/// and more.
constexpr double touching = 1e-14;

double gap(const SceneCube& a, const SceneCube& b) {
  return separation(make_box(a.position, a.angle, a.size), make_box(b.position, b.angle, b.size));
}

/// Pairs of cubes that touch.
int touching_pairs(const Scene& scene) {
  int pairs = 0;
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.cubes.size(); ++j) {
      const double between = gap(scene.cubes[i], scene.cubes[j]);
      EXPECT_GT(between, -touching) << scene.cubes[i].name << " " << scene.cubes[j].name;
      if (between < touching) ++pairs;
    }
  }
  return pairs;
}

TEST(Tower, CubesStandOnEachOtherFromTheBase) {
  const Scene scene =
      parse_scene("[[tower]]\ncount = 4\nbase = [4, 0.5]\nsize = [0.3, 0.7]\nmass = 2\n", "s.toml");
  ASSERT_EQ(scene.cubes.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const SceneCube& cube = cube_named(scene, "tower1_" + std::to_string(i + 1));
    EXPECT_EQ(cube.position.x(), 4.0);
    EXPECT_NEAR(cube.position.y(), 0.5 + 0.7 * (i + 0.5), 1e-15);
    EXPECT_EQ(cube.mass, 2.0);
  }
  EXPECT_EQ(touching_pairs(scene), 3);
}

TEST(Tower, LeanShiftsEachCubeAgainstTheOneBelow) {
  const Scene scene =
      parse_scene("[[tower]]\nname = \"t\"\ncount = 3\nbase = [1, 0]\nlean = -0.25\n", "s.toml");
  EXPECT_EQ(cube_named(scene, "t_1").position, Vec2(1.0, 0.5));
  EXPECT_EQ(cube_named(scene, "t_2").position, Vec2(0.75, 1.5));
  EXPECT_EQ(cube_named(scene, "t_3").position, Vec2(0.5, 2.5));
}

TEST(Tower, SurfaceAndColourGoToEveryCube) {
  const Scene scene = parse_scene(
      "[[tower]]\ncount = 2\nbase = [0, 0]\ndensity = 3\nsize = 2\nfriction = 0.5\ncolor = "
      "\"#010203\"\n",
      "s.toml");
  for (const SceneCube& cube : scene.cubes) {
    EXPECT_EQ(cube.mass, 12.0);
    EXPECT_EQ(cube.material.friction, 0.5);
    EXPECT_EQ(*cube.color, (std::array<std::uint8_t, 3>{1, 2, 3}));
  }
}

TEST(Wall, RunningBondHasHalfCubesOfHalfTheMassAtTheEndsOfEverySecondRow) {
  const Scene scene = parse_scene(
      "[[wall]]\nrows = 3\ncolumns = 4\nbase = [0, 0]\nsize = [1, 0.5]\nmass = 3\n", "s.toml");
  ASSERT_EQ(scene.cubes.size(), 4U + 5U + 4U);
  const SceneCube& left = cube_named(scene, "wall1_5");
  EXPECT_EQ(left.size, Vec2(0.5, 0.5));
  EXPECT_EQ(left.mass, 1.5);
  EXPECT_EQ(left.position, Vec2(-1.75, 0.75));
  const SceneCube& full = cube_named(scene, "wall1_6");
  EXPECT_EQ(full.size, Vec2(1.0, 0.5));
  EXPECT_EQ(full.mass, 3.0);
  EXPECT_EQ(full.position, Vec2(-1.0, 0.75));
  EXPECT_EQ(cube_named(scene, "wall1_9").position, Vec2(1.75, 0.75));
  EXPECT_EQ(cube_named(scene, "wall1_10").position, Vec2(-1.5, 1.25));
  double mass = 0.0;
  for (const SceneCube& cube : scene.cubes) {
    mass += cube.mass;
  }
  EXPECT_EQ(mass, 3.0 * 4.0 * 3.0) << "every row weighs the same";
  // Within rows 3 + 4 + 3; between rows each of the 5 lies on its 2 or 1 of 4, twice; 2 * 3 corner
  // contacts less.
  EXPECT_EQ(touching_pairs(scene), 10 + 16);
}

TEST(Wall, StackBondIsAGrid) {
  const Scene scene = parse_scene(
      "[[wall]]\nrows = 3\ncolumns = 4\nbase = [2, 1]\nbond = \"stack\"\ndensity = 2\n", "s.toml");
  ASSERT_EQ(scene.cubes.size(), 12U);
  EXPECT_EQ(cube_named(scene, "wall1_1").position, Vec2(0.5, 1.5));
  EXPECT_EQ(cube_named(scene, "wall1_12").position, Vec2(3.5, 3.5));
  for (const SceneCube& cube : scene.cubes) {
    EXPECT_EQ(cube.mass, 2.0);
  }
}

TEST(Wall, HalfCubesOfADensityHaveHalfTheMass) {
  const Scene scene =
      parse_scene("[[wall]]\nrows = 2\ncolumns = 1\nbase = [0, 0]\ndensity = 2\n", "s.toml");
  ASSERT_EQ(scene.cubes.size(), 3U);
  EXPECT_EQ(cube_named(scene, "wall1_1").mass, 2.0);
  EXPECT_EQ(cube_named(scene, "wall1_2").mass, 1.0);
  EXPECT_EQ(cube_named(scene, "wall1_3").mass, 1.0);
}

TEST(Pyramid, EachRowIsOneShorterAndCentred) {
  const Scene scene = parse_scene("[[pyramid]]\nrows = 5\nbase = [1, 0]\n", "s.toml");
  ASSERT_EQ(scene.cubes.size(), 15U);
  EXPECT_EQ(cube_named(scene, "pyramid1_1").position, Vec2(-1.0, 0.5));
  EXPECT_EQ(cube_named(scene, "pyramid1_5").position, Vec2(3.0, 0.5));
  EXPECT_EQ(cube_named(scene, "pyramid1_6").position, Vec2(-0.5, 1.5));
  EXPECT_EQ(cube_named(scene, "pyramid1_15").position, Vec2(1.0, 4.5));
  EXPECT_EQ(touching_pairs(scene), 4 + 3 + 2 + 1 + 2 * (4 + 3 + 2 + 1));
}

TEST(Generators, AreNumberedAndOrderedByKind) {
  const Scene scene = parse_scene(
      "[[pyramid]]\nrows = 1\nbase = [9, 0]\n[[wall]]\nrows = 1\ncolumns = 1\nbase = [6, 0]\n"
      "[[tower]]\ncount = 1\nbase = [0, 0]\n[[tower]]\ncount = 1\nbase = [3, 0]\n"
      "[[cube]]\nposition = [-3, 0]\n",
      "s.toml");
  std::string names;
  for (const SceneCube& cube : scene.cubes) {
    names += cube.name + " ";
  }
  EXPECT_EQ(names, "cube1 tower1_1 tower2_1 wall1_1 pyramid1_1 ");
}

TEST(Pile, CubesLieApartWithinTheRegion) {
  const Scene scene = parse_scene(
      "[[plane]]\n[[fixed]]\nsize = [1, 3]\nposition = [2, 1.5]\nangle = 0.2\n[[cube]]\nposition = "
      "[4, 0.5]\n"
      "[[pile]]\ncount = 40\nregion = [0, -1, 5, 6]\nsize = [0.5, 0.3]\nmass = 2\n"
      "[[pile]]\nname = \"more\"\ncount = 10\nregion = [0, 0, 5, 6]\nsize = 0.4\nseed = 5\n",
      "s.toml");
  ASSERT_EQ(scene.cubes.size(), 51U);
  EXPECT_FALSE(find_overlap(scene).has_value());
  bool turned = false;
  for (int i = 1; i <= 40; ++i) {
    const SceneCube& cube = cube_named(scene, "pile1_" + std::to_string(i));
    EXPECT_EQ(cube.mass, 2.0);
    const Box box = make_box(cube.position, cube.angle, cube.size);
    for (int k = 0; k < 4; ++k) {
      EXPECT_GE(box.corner(k).minCoeff(), 0.0) << "above the floor and right of the region's edge";
      EXPECT_LE(box.corner(k).x(), 5.0 + touching);
      EXPECT_LE(box.corner(k).y(), 6.0 + touching);
    }
    turned = turned || (cube.angle > 1.0 && cube.angle < 2.0);
  }
  EXPECT_TRUE(turned);
}

TEST(Pile, KeepsAHundredthOfItsSideClear) {
  const Scene scene = parse_scene("[[pile]]\ncount = 60\nregion = [0, 0, 12, 12]\n", "s.toml");
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.cubes.size(); ++j) {
      EXPECT_GE(gap(scene.cubes[i], scene.cubes[j]), 0.01 - touching);
    }
  }
}

TEST(Pile, TheSeedDecides) {
  const auto pile = [](const std::string& seed) {
    return parse_scene("[[pile]]\ncount = 5\nregion = [0, 0, 9, 9]\nseed = " + seed + "\n",
                       "s.toml");
  };
  EXPECT_EQ(pile("3"), pile("3"));
  EXPECT_NE(pile("3"), pile("4"));
  EXPECT_EQ(parse_scene("[[pile]]\ncount = 5\nregion = [0, 0, 9, 9]\n", "s.toml"), pile("1"))
      << "default";
}

TEST(Pile, IsTheSameOnEveryMachine) {
  const Scene scene =
      parse_scene("[[pile]]\ncount = 1\nregion = [0, 0, 9, 9]\nseed = 1234567\n", "s.toml");
  // First three numbers of the sequence: angle, place across, place up.
  EXPECT_EQ(scene.cubes[0].angle, 3.14159265358979323846 * random_unit(1234567, 0));
}

TEST(CounterRandom, FollowsThePublishedSplitMix64Sequence) {
  EXPECT_EQ(random_bits(1234567, 0), 6457827717110365317U);
  EXPECT_EQ(random_bits(1234567, 1), 3203168211198807973U);
  EXPECT_EQ(random_bits(1234567, 2), 9817491932198370423U);
  EXPECT_EQ(random_bits(1234567, 3), 4593380528125082431U);
  EXPECT_EQ(random_bits(1234567, 4), 16408922859458223821U);
}

TEST(CounterRandom, UnitNumbersFillTheUnitInterval) {
  double sum = 0.0;
  double least = 1.0;
  double most = 0.0;
  const int count = 100'000;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double x = random_unit(7, i);
    sum += x;
    least = std::min(least, x);
    most = std::max(most, x);
  }
  EXPECT_NEAR(sum / count, 0.5, 0.004) << "four standard deviations of the mean";
  EXPECT_LT(least, 1e-3);
  EXPECT_GT(most, 1.0 - 1e-3);
  EXPECT_LT(most, 1.0);
}

}  // namespace
}  // namespace wuerfel::test
