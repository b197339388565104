// What a scene text means: defaults, units, names, the two languages.
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

TEST(Parse, ACubeAloneTakesAllDefaults) {
  const Scene scene = parse_scene("[[cube]]\nposition = [1, 2]\n", "s.toml");
  EXPECT_EQ(scene.title, "");
  EXPECT_EQ(scene.gravity, Vec2(0.0, -9.81));
  EXPECT_EQ(scene.duration, 5.0);
  ASSERT_EQ(scene.cubes.size(), 1U);
  const SceneCube& cube = scene.cubes[0];
  EXPECT_EQ(cube.name, "cube1");
  EXPECT_EQ(cube.size, Vec2(1.0, 1.0));
  EXPECT_EQ(cube.mass, 1.0);
  EXPECT_EQ(cube.position, Vec2(1.0, 2.0));
  EXPECT_EQ(cube.angle, 0.0);
  EXPECT_EQ(cube.velocity, Vec2(0.0, 0.0));
  EXPECT_EQ(cube.spin, 0.0);
  EXPECT_EQ(cube.material, Material{});
  EXPECT_FALSE(cube.color.has_value());
}

const char* const full_toml = R"(
version = 1
title = "Ein Stapel Würfel"
gravity = [0, -1.5]
duration = 0
[material]
friction = 0.25
restitution = 1
[[plane]]
name = "slope"
point = [0, -3]
normal = [3, 4]
friction = 0.5
[[fixed]]
name = "table"
size = [2, 0.2]
position = [3, 1]
angle_deg = 90
restitution = 0.5
[[cube]]
name = "a"
size = [0.5, 2]
density = 3
position = [0, 10]
angle = 0.1
velocity = [1, -2]
spin = 4
friction = 0
restitution = 0.75
color = "#12aBfF"
[[cube]]
size = 2
mass = 7
position = [8, 10]
color = "reddish purple"
[[pair]]
bodies = ["a", "table"]
friction = 0.125
)";

const char* const full_json = R"({
  "version": 1, "title": "Ein Stapel W\u00fcrfel", "gravity": [0, -1.5], "duration": 0,
  "material": {"friction": 0.25, "restitution": 1},
  "plane": [{"name": "slope", "point": [0, -3], "normal": [3, 4], "friction": 0.5}],
  "fixed": [{"name": "table", "size": [2, 0.2], "position": [3, 1], "angle_deg": 90, "restitution": 0.5}],
  "cube": [{"name": "a", "size": [0.5, 2], "density": 3, "position": [0, 10], "angle": 0.1,
            "velocity": [1, -2], "spin": 4, "friction": 0, "restitution": 0.75, "color": "#12aBfF"},
           {"size": 2, "mass": 7, "position": [8, 10], "color": "reddish purple"}],
  "pair": [{"bodies": ["a", "table"], "friction": 0.125}]})";

TEST(Parse, EveryKeyReachesTheScene) {
  const Scene scene = parse_scene(full_toml, "s.toml");
  EXPECT_EQ(scene.title, "Ein Stapel Würfel");
  EXPECT_EQ(scene.gravity, Vec2(0.0, -1.5));
  EXPECT_EQ(scene.duration, 0.0);
  EXPECT_EQ(scene.material, (Material{0.25, 1.0}));
  ASSERT_EQ(scene.planes.size(), 1U);
  EXPECT_EQ(scene.planes[0].name, "slope");
  EXPECT_EQ(scene.planes[0].point, Vec2(0.0, -3.0));
  EXPECT_EQ(scene.planes[0].normal, Vec2(0.6, 0.8));
  EXPECT_EQ(scene.planes[0].material, (Material{0.5, 1.0}));
  ASSERT_EQ(scene.fixed.size(), 1U);
  EXPECT_EQ(scene.fixed[0].size, Vec2(2.0, 0.2));
  EXPECT_EQ(scene.fixed[0].position, Vec2(3.0, 1.0));
  EXPECT_EQ(scene.fixed[0].angle, 0.5 * std::numbers::pi);
  EXPECT_EQ(scene.fixed[0].material, (Material{0.25, 0.5}));
  ASSERT_EQ(scene.cubes.size(), 2U);
  const SceneCube& a = scene.cubes[0];
  EXPECT_EQ(a.size, Vec2(0.5, 2.0));
  EXPECT_EQ(a.mass, 3.0);
  EXPECT_EQ(a.position, Vec2(0.0, 10.0));
  EXPECT_EQ(a.angle, 0.1);
  EXPECT_EQ(a.velocity, Vec2(1.0, -2.0));
  EXPECT_EQ(a.spin, 4.0);
  EXPECT_EQ(a.material, (Material{0.0, 0.75}));
  EXPECT_EQ(*a.color, (std::array<std::uint8_t, 3>{0x12, 0xab, 0xff}));
  const SceneCube& b = scene.cubes[1];
  EXPECT_EQ(b.name, "cube2");
  EXPECT_EQ(b.size, Vec2(2.0, 2.0));
  EXPECT_EQ(b.mass, 7.0);
  EXPECT_EQ(*b.color, (std::array<std::uint8_t, 3>{204, 121, 167}));
  ASSERT_EQ(scene.pairs.size(), 1U);
  EXPECT_EQ(scene.pairs[0].bodies, (std::array<std::string, 2>{"a", "table"}));
  EXPECT_EQ(scene.pairs[0].friction, 0.125);
  EXPECT_FALSE(scene.pairs[0].restitution.has_value());
}

TEST(Parse, JsonWithTheSameKeysIsTheSameScene) {
  const Scene from_toml = parse_scene(full_toml, "s.toml");
  EXPECT_EQ(parse_scene(full_json, "s.json"), from_toml);
  EXPECT_EQ(parse_scene(full_json, "standard input"), from_toml) << "told by the first character";
  EXPECT_EQ(parse_scene(" \n\t" + std::string(full_json), "-"), from_toml);
  EXPECT_EQ(parse_scene("\xef\xbb\xbf" + std::string(full_json), "-"), from_toml)
      << "byte order mark";
  EXPECT_EQ(parse_scene("\xef\xbb\xbf" + std::string(full_toml), "-"), from_toml);
}

TEST(Parse, ATomlSceneMayBeginWithABracket) {
  EXPECT_EQ(parse_scene("[[cube]]\nposition = [0, 1]\n", "-").cubes.size(), 1U);
}

TEST(Parse, WholeNumbersMayBeWrittenWithAPoint) {
  EXPECT_EQ(parse_scene(R"({"tower": [{"count": 3.0, "base": [0, 0]}]})", "-").cubes.size(), 3U);
}

TEST(Parse, UnnamedBodiesAreNumberedWithinTheirKind) {
  const Scene scene = parse_scene(
      "[[plane]]\n[[plane]]\nnormal = [1, 0]\npoint = [-9, 0]\n[[fixed]]\nposition = [5, 5]\n"
      "[[cube]]\nname = \"first\"\nposition = [0, 1]\n[[cube]]\nposition = [2, 1]\n",
      "s.toml");
  EXPECT_EQ(scene.planes[0].name, "plane1");
  EXPECT_EQ(scene.planes[1].name, "plane2");
  EXPECT_EQ(scene.fixed[0].name, "fixed1");
  EXPECT_EQ(scene.cubes[0].name, "first");
  EXPECT_EQ(scene.cubes[1].name, "cube2");
}

TEST(Parse, NormalsOfAnyLengthBecomeUnitVectors) {
  for (const char* normal : {"[0, 1e-12]", "[0, 3]", "[0, 1e15]"}) {
    const Scene scene = parse_scene(
        "[[plane]]\nnormal = " + std::string(normal) + "\n[[cube]]\nposition = [0, 1]\n", "s.toml");
    EXPECT_EQ(scene.planes[0].normal, Vec2(0.0, 1.0)) << normal;
  }
}

TEST(Parse, DegreesOfWholeQuartersGiveTheNearestAngle) {
  const auto angle = [](const std::string& degrees) {
    return parse_scene("[[cube]]\nposition = [0, 1]\nangle_deg = " + degrees + "\n", "s.toml")
        .cubes[0]
        .angle;
  };
  EXPECT_EQ(angle("90"), 0.5 * std::numbers::pi);
  EXPECT_EQ(angle("-45"), -0.25 * std::numbers::pi);
  EXPECT_EQ(angle("180"), std::numbers::pi);
}

TEST(Parse, EveryColourOfThePaletteIsKnown) {
  for (const char* name : {"black", "orange", "sky blue", "bluish green", "yellow", "blue",
                           "vermillion", "reddish purple"}) {
    EXPECT_EQ(toml_error("[[cube]]\nposition = [0, 1]\ncolor = \"" + std::string(name) + "\"\n"),
              "no error");
  }
}

}  // namespace
}  // namespace wuerfel::test
