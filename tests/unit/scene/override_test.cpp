// `--set KEY=VALUE`.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

const char* const text = R"(
[material]
friction = 0.5
[[cube]]
name = "a"
position = [0, 1]
[[cube]]
name = "box.c"
position = [3, 1]
[[cube]]
position = [6, 1]
[[tower]]
count = 2
base = [9, 0]
)";

Scene with(const std::vector<std::string>& overrides) {
  return parse_scene(text, "s.toml", overrides);
}
std::string error(const std::string& override) { return toml_error(text, {override}); }

TEST(Override, SetsKeysOfTheDocument) {
  const Scene scene = with({"gravity=[0,-1]", "duration=2", "title=\"x y\""});
  EXPECT_EQ(scene.gravity, Vec2(0.0, -1.0));
  EXPECT_EQ(scene.duration, 2.0);
  EXPECT_EQ(scene.title, "x y");
}

TEST(Override, SetsKeysOfTables) {
  EXPECT_EQ(with({"material.friction=0.25"}).cubes[0].material.friction, 0.25);
  EXPECT_EQ(with({"material.restitution=1"}).cubes[0].material, (Material{0.5, 1.0}));
  EXPECT_EQ(parse_scene("[[cube]]\nposition = [0, 1]\n", "s.toml", {"material.friction=3"})
                .material.friction,
            3.0)
      << "the table need not have been there";
}

TEST(Override, FindsBodiesByNameThenByDefaultNameThenByNumber) {
  EXPECT_EQ(cube_named(with({"cube.a.angle=0.1"}), "a").angle, 0.1);
  EXPECT_EQ(cube_named(with({"cube.box.c.angle=0.1"}), "box.c").angle, 0.1);
  EXPECT_EQ(cube_named(with({"cube.cube3.angle=0.1"}), "cube3").angle, 0.1);
  EXPECT_EQ(cube_named(with({"cube.3.angle=0.1"}), "cube3").angle, 0.1);
  EXPECT_EQ(with({"tower.1.count=8"}).cubes.size(), 11U);
  EXPECT_EQ(with({"tower.tower1.count=8"}).cubes.size(), 11U);
}

TEST(Override, ANameThatIsANumberGoesFirst) {
  const Scene scene =
      parse_scene("[[cube]]\nposition = [0, 1]\n[[cube]]\nname = \"1\"\nposition = [3, 1]\n",
                  "s.toml", {"cube.1.mass=5"});
  EXPECT_EQ(cube_named(scene, "1").mass, 5.0);
  EXPECT_EQ(cube_named(scene, "cube1").mass, 1.0);
}

TEST(Override, PlainWordsNeedNoQuotes) {
  EXPECT_EQ(*cube_named(with({"cube.a.color=#ff0000"}), "a").color,
            (std::array<std::uint8_t, 3>{255, 0, 0}));
  EXPECT_EQ(*cube_named(with({"cube.a.color=sky blue"}), "a").color,
            (std::array<std::uint8_t, 3>{86, 180, 233}));
  EXPECT_EQ(with({"title=Ein Stapel Würfel"}).title, "Ein Stapel Würfel");
}

TEST(Override, TheLastOneCounts) {
  EXPECT_EQ(with({"duration=2", " duration = 3 "}).duration, 3.0);
}

TEST(Override, WorksOnJsonToo) {
  const std::string json = R"({"cube": [{"name": "a", "position": [0, 1]}]})";
  EXPECT_EQ(parse_scene(json, "-", {"cube.a.position=[5, 6]"}).cubes[0].position, Vec2(5.0, 6.0));
}

TEST(Override, ErrorsNameTheOverride) {
  EXPECT_EQ(error("cube.a.mass=-1"),
            "--set cube.a.mass=-1: cube[1].mass: must be greater than 0; it is -1");
  EXPECT_EQ(
      error("cube.a.position=[0, \"x\"]"),
      "--set cube.a.position=[0, \"x\"]: cube[1].position[2]: must be a number, not text (\"x\")");
  EXPECT_EQ(error("cube.a.angel=1"),
            "--set cube.a.angel=1: cube[1]: unknown key \"angel\"; did you mean \"angle\"?");
  EXPECT_EQ(error("graviti=1"),
            "--set graviti=1: unknown key \"graviti\"; did you mean \"gravity\"?");
  EXPECT_EQ(error("cube.a.on=floor"),
            "--set cube.a.on=floor: cube[1].on: cannot be given together with position");
  EXPECT_EQ(error("gravity=1e999"),
            "--set gravity=1e999: the value is not valid TOML: Error while parsing floating-point: "
            "'1e999' could not be interpreted as a value");
}

TEST(Override, KeysThatLeadNowhereAreRefused) {
  EXPECT_EQ(error("cube.bax.c.mass=1"),
            "--set cube.bax.c.mass=1: there is no cube \"bax.c\"; did you mean \"box.c\"?");
  EXPECT_EQ(error("tower.2.count=1"),
            "--set tower.2.count=1: there is no tower \"2\"; known: tower1");
  EXPECT_EQ(error("cube.0.mass=1"),
            "--set cube.0.mass=1: there is no cube \"0\"; known: a, box.c, cube3");
  EXPECT_EQ(error("wall.1.rows=1"), "--set wall.1.rows=1: the scene has no [[wall]]");
  EXPECT_EQ(error("cube.mass=1"),
            "--set cube.mass=1: cube is an array of 3; name the element, as in cube.1.mass");
  EXPECT_EQ(error("wal.x=1"), "--set wal.x=1: unknown key \"wal\"; did you mean \"wall\"?");
}

TEST(Override, MustBeKeyAndValueOnOneLine) {
  EXPECT_EQ(error("gravity"), "--set gravity: must be KEY=VALUE");
  EXPECT_EQ(error("=3"), "--set =3: must be KEY=VALUE");
  EXPECT_EQ(error(".a=3"), "--set .a=3: the key has an empty part");
  EXPECT_EQ(error("cube.a.=3"), "--set cube.a.=3: the key has an empty part");
  EXPECT_EQ(error("duration=2\n[[cube]]"),
            "--set duration=2\\x0a[[cube]]: the value must be on one line");
  EXPECT_EQ(error("title=\xff"), "--set title=\xff: not UTF-8 text; save it in that encoding");
  EXPECT_EQ(error("gravity=" + std::string(20, '[')),
            "--set gravity=" + std::string(20, '[') + ": nested too deeply: more than 16 levels");
}

}  // namespace
}  // namespace wuerfel::test
