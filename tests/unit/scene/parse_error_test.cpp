// Every kind of bad input, with the exact message: where, what is wrong, what would be right.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

std::string with_cube(const std::string& line) { return toml_error(cube_text + line + "\n"); }

TEST(ParseError, UnknownKeyComesWithASuggestion) {
  EXPECT_EQ(toml_error("version = 1\n[[cube]]\npostion = [0, 1]\n"),
            "s.toml:3:1: cube[1]: unknown key \"postion\"; did you mean \"position\"?");
  EXPECT_EQ(json_error(R"({"version": 1, "cubes": []})"),
            "s.json: unknown key \"cubes\"; did you mean \"cube\"?");
}

TEST(ParseError, UnknownKeyWithoutLikenessListsTheKnownOnes) {
  EXPECT_EQ(
      toml_error("qqqqqq = 3\n" + std::string(cube_text)),
      "s.toml:1:1: unknown key \"qqqqqq\"; known: version, title, gravity, duration, material, "
      "plane, fixed, cube, tower, wall, pyramid, pile, pair, point, rod, pin, chain, truss");
}

TEST(ParseError, UnknownKeysOfAllTablesAreRefused) {
  EXPECT_EQ(toml_error("[material]\nfrition = 1\n" + std::string(cube_text)),
            "s.toml:2:1: material: unknown key \"frition\"; did you mean \"friction\"?");
  EXPECT_EQ(toml_error("[[plane]]\nnormale = [0, 1]\n" + std::string(cube_text)),
            "s.toml:2:1: plane[1]: unknown key \"normale\"; did you mean \"normal\"?");
  EXPECT_EQ(toml_error("[[pile]]\nseeds = 3\n"),
            "s.toml:2:1: pile[1]: unknown key \"seeds\"; did you mean \"seed\"?");
}

TEST(ParseError, WrongTypesAreNamed) {
  EXPECT_EQ(with_cube("size = \"big\""),
            "s.toml:3:8: cube[1].size: must be a number, not text (\"big\")");
  EXPECT_EQ(with_cube("size = [1, 2, 3]"),
            "s.toml:3:8: cube[1].size: must be a number or two numbers [width, height], not an "
            "array of 3");
  EXPECT_EQ(with_cube("size = [1, \"x\"]"),
            "s.toml:3:12: cube[1].size[2]: must be a number, not text (\"x\")");
  EXPECT_EQ(with_cube("velocity = 3"),
            "s.toml:3:12: cube[1].velocity: must be two numbers [x, y], not 3");
  EXPECT_EQ(with_cube("name = 5"), "s.toml:3:8: cube[1].name: must be a text, not 5");
  EXPECT_EQ(with_cube("spin = true"), "s.toml:3:8: cube[1].spin: must be a number, not true");
  EXPECT_EQ(with_cube("spin = 1979-05-27"),
            "s.toml:3:8: cube[1].spin: must be a number, not a date or time");
  EXPECT_EQ(json_error(R"({"cube": [{"position": [0, 1], "mass": null}]})"),
            "s.json: cube[1].mass: must be a number, not null");
  EXPECT_EQ(toml_error("[[tower]]\ncount = 2.5\nbase = [0, 0]\n"),
            "s.toml:2:9: tower[1].count: must be a whole number, not 2.5");
}

TEST(ParseError, TablesAreNotTakenForValuesNorValuesForTables) {
  EXPECT_EQ(toml_error("[cube]\nposition = [0, 1]\n"),
            "s.toml:1:2: cube: must be an array of tables ([[cube]] in TOML), not a table");
  EXPECT_EQ(toml_error("cube = [3]\n"), "s.toml:1:9: cube[1]: must be a table, not 3");
  EXPECT_EQ(toml_error("material = 3\n" + std::string(cube_text)),
            "s.toml:1:12: material: must be a table, not 3");
  EXPECT_EQ(json_error("null"), "s.json: a scene must be a table, not null");
}

TEST(ParseError, NumbersMustBeFinite) {
  EXPECT_EQ(with_cube("angle = nan"),
            "s.toml:3:9: cube[1].angle: must be a finite number, not nan");
  EXPECT_EQ(with_cube("velocity = [0, -inf]"),
            "s.toml:3:16: cube[1].velocity[2]: must be a finite number, not -inf");
  EXPECT_EQ(with_cube("mass = 1e999"),
            "s.toml:3:13: not valid TOML: Error while parsing floating-point: '1e999' could not be "
            "interpreted as a value");
  EXPECT_EQ(json_error("{\"cube\": [{\"position\": [0, 1],\n \"mass\": 1e999}]}"),
            "s.json:2:14: not valid JSON: number overflow parsing '1e999'");
  EXPECT_EQ(json_error(R"({"gravity": [0, NaN]})").substr(0, 30), "s.json:1:17: not valid JSON: s");
}

TEST(ParseError, SizesAndMassesMustBePositive) {
  EXPECT_EQ(with_cube("size = -1"), "s.toml:3:8: cube[1].size: must be greater than 0; it is -1");
  EXPECT_EQ(with_cube("size = [1, 0]"),
            "s.toml:3:12: cube[1].size[2]: must be greater than 0; it is 0");
  EXPECT_EQ(with_cube("mass = 0"), "s.toml:3:8: cube[1].mass: must be greater than 0; it is 0");
  EXPECT_EQ(with_cube("density = -2.5"),
            "s.toml:3:11: cube[1].density: must be greater than 0; it is -2.5");
  EXPECT_EQ(json_error(R"({"version":1,"cube":[{"size":-1,"mass":1,"position":[0,1]}]})"),
            "s.json: cube[1].size: must be greater than 0; it is -1");
}

TEST(ParseError, ValuesStayWithinTheirRange) {
  EXPECT_EQ(with_cube("friction = -0.1"),
            "s.toml:3:12: cube[1].friction: must not be negative; it is -0.1");
  EXPECT_EQ(with_cube("friction = inf"),
            "s.toml:3:12: cube[1].friction: must be a finite number, not inf");
  EXPECT_EQ(toml_error("[material]\nfriction = nan\n" + std::string(cube_text)),
            "s.toml:2:12: material.friction: must be a finite number, not nan");
  EXPECT_EQ(with_cube("restitution = nan"),
            "s.toml:3:15: cube[1].restitution: must be a finite number, not nan");
  EXPECT_EQ(with_cube("restitution = 1.5"),
            "s.toml:3:15: cube[1].restitution: must be between 0 and 1; it is 1.5");
  EXPECT_EQ(toml_error("[material]\nrestitution = -1\n" + std::string(cube_text)),
            "s.toml:2:15: material.restitution: must not be negative; it is -1");
  EXPECT_EQ(toml_error("duration = -1\n" + std::string(cube_text)),
            "s.toml:1:12: duration: must not be negative; it is -1");
  EXPECT_EQ(toml_error("version = 2\n" + std::string(cube_text)),
            "s.toml:1:11: version: must be 1; it is 2");
  EXPECT_EQ(with_cube("mass = 1e40"),
            "s.toml:3:8: cube[1].mass: must be between 1e-30 and 1e+30; it is 1e+40");
}

TEST(ParseError, WhatIsComputedStaysWithinItsRangeToo) {
  EXPECT_EQ(
      with_cube("size = 1e10\ndensity = 1e20"),
      "s.toml:1:1: cube[1]: \"cube1\" would have position [0, 1], angle 0 and mass 1e+40, out "
      "of range");
}

TEST(ParseError, MassesThatDoublesCannotHoldTogetherAreRefused) {
  const std::string light = "[[cube]]\nname = \"l\"\nposition = [0, 1]\nmass = 1e-4\n";
  EXPECT_EQ(
      toml_error("[[tower]]\ncount = 2\nbase = [5, 0]\nmass = 1e14\n" + light),
      "s.toml:8:8: cube[1]: \"l\" has 0.0001 kg and \"tower1_1\" 1e+14 kg, out of range of each "
      "other: more than 1e+16 to one cannot be computed with 16 digits; bring them closer, or "
      "make a [[fixed]] box of the heavy one");
  EXPECT_EQ(parse_scene("[[tower]]\ncount = 2\nbase = [5, 0]\nmass = 1e11\n" + light, "s.toml")
                .cubes.size(),
            3U);
}

TEST(ParseError, BodiesThatDoublesCannotHoldWhereTheyAreAreRefused) {
  EXPECT_EQ(toml_error("[[cube]]\nname = \"s\"\nsize = 1e-12\nposition = [0, 1e9]\n"),
            "s.toml:1:1: cube[1]: \"s\", 1e-12 m wide, would have position [0, 1000000000], out of "
            "range: so far out "
            "its corners are where its centre is; place it nearer to the origin or make it larger");
  EXPECT_EQ(parse_scene("[[cube]]\nsize = 1e-6\nposition = [0, 1e9]\n", "s.toml").cubes.size(), 1U);
}

TEST(ParseError, DoubledNamesAreRefused) {
  EXPECT_EQ(toml_error("[[cube]]\nname = \"a\"\nposition = [0, 1]\n"
                       "[[cube]]\nname = \"a\"\nposition = [3, 1]\n"),
            "s.toml:5:8: cube[2]: the name \"a\" is taken by cube[1]");
  EXPECT_EQ(toml_error("[[plane]]\nname = \"tower1_2\"\n[[tower]]\ncount = 2\nbase = [0, 0]\n"),
            "s.toml:3:1: tower[1]: the name \"tower1_2\" is taken by plane[1]");
}

TEST(ParseError, ANameGivenToAnotherBodyBlocksTheDefaultName) {
  EXPECT_EQ(toml_error("[[cube]]\nname = \"cube2\"\nposition = [0, 1]\n"
                       "[[cube]]\nposition = [3, 1]\n"),
            "s.toml:4:1: cube[2]: the name \"cube2\" is taken by cube[1]");
}

TEST(ParseError, NamesAndTitlesFitOnALine) {
  EXPECT_EQ(with_cube("name = \"\""), "s.toml:3:8: cube[1].name: must not be empty");
  EXPECT_EQ(with_cube("name = \"" + std::string(101, 'x') + "\""),
            "s.toml:3:8: cube[1].name: has 101 characters; at most 100 are allowed");
  EXPECT_EQ(toml_error("title = \"a\\nb\"\n" + std::string(cube_text)),
            "s.toml:1:9: title: must not hold line breaks or other control characters");
  EXPECT_EQ(json_error(R"({"title": "\u0000", "cube": [{"position": [0, 1]}]})"),
            "s.json: title: must not hold line breaks or other control characters");
}

TEST(ParseError, MessagesAreOneLineWhateverTheyQuote) {
  EXPECT_EQ(with_cube("size = \"a\\nb\\u001b[2J\""),
            "s.toml:3:8: cube[1].size: must be a number, not text (\"a\\x0ab\\x1b[2J\")");
}

TEST(ParseError, ASceneNeedsCubes) {
  EXPECT_EQ(toml_error("# nothing\n"),
            "s.toml:1:1: a scene needs cube or tower or wall or pyramid or pile or point or chain "
            "or truss");
  EXPECT_EQ(toml_error("[[plane]]\n[[fixed]]\nposition = [0, 0]\n"),
            "s.toml:1:1: a scene needs cube or tower or wall or pyramid or pile or point or chain "
            "or truss");
  EXPECT_EQ(json_error(R"({"version": 1, "cube": []})"),
            "s.json: the scene has no cubes; add a [[cube]] or a generator such as [[tower]]");
}

TEST(ParseError, ANormalHasADirection) {
  EXPECT_EQ(toml_error("[[plane]]\nnormal = [0, 0]\n" + std::string(cube_text)),
            "s.toml:2:10: plane[1].normal: must not be zero");
}

TEST(ParseError, AlternativesExcludeEachOther) {
  EXPECT_EQ(with_cube("mass = 1\ndensity = 2"),
            "s.toml:4:1: cube[1].density: cannot be given together with mass");
  EXPECT_EQ(with_cube("angle_deg = 1\nangle = 2"),
            "s.toml:4:1: cube[1].angle: cannot be given together with angle_deg");
  EXPECT_EQ(with_cube("on = \"floor\""),
            "s.toml:3:1: cube[1].on: cannot be given together with position");
  EXPECT_EQ(toml_error("[[cube]]\non = \"floor\"\nangle = 1\n"),
            "s.toml:3:1: cube[1].angle: cannot be given together with on");
  EXPECT_EQ(with_cube("offset = 1"), "s.toml:3:1: cube[1].offset: is of use only together with on");
}

TEST(ParseError, OneOfTheAlternativesMustBeThere) {
  EXPECT_EQ(toml_error("\n[[cube]]\nname = \"a\"\n"), "s.toml:2:1: cube[1]: needs position or on");
  EXPECT_EQ(toml_error("[[wall]]\nrows = 1\ncolumns = 1\n"),
            "s.toml:1:1: wall[1]: needs base or on");
  EXPECT_EQ(toml_error("[[tower]]\nbase = [0, 0]\n"), "s.toml:1:1: tower[1]: needs count");
  EXPECT_EQ(toml_error(std::string(cube_text) + "[[pair]]\nbodies = [\"cube1\", \"cube2\"]\n"),
            "s.toml:3:1: pair[1]: needs friction or restitution");
}

TEST(ParseError, UnknownBodiesComeWithASuggestion) {
  EXPECT_EQ(toml_error("[[plane]]\nname = \"floor\"\n[[cube]]\non = \"flor\"\n"),
            "s.toml:4:6: cube[1].on: there is no body \"flor\"; did you mean \"floor\"?");
  EXPECT_EQ(toml_error(std::string(cube_text)
                       + "[[pair]]\nbodies = [\"cube1\", \"moon\"]\nfriction = 1\n"),
            "s.toml:4:10: pair[1].bodies: there is no body \"moon\"; known: cube1");
}

TEST(ParseError, CyclesOfOnAreNamed) {
  EXPECT_EQ(
      toml_error("[[cube]]\non = \"cube2\"\n[[cube]]\non = \"cube3\"\n[[cube]]\non = \"cube1\"\n"),
      "s.toml:6:6: cube[3].on: goes round in a circle: \"cube1\" on \"cube2\" on \"cube3\" on "
      "\"cube1\"");
  EXPECT_EQ(toml_error("[[cube]]\nname = \"a\"\non = \"b\"\n[[cube]]\nname = \"b\"\non = \"b\"\n"),
            "s.toml:6:6: cube[2].on: goes round in a circle: \"b\" on \"b\"");
  EXPECT_EQ(toml_error("[[tower]]\ncount = 2\non = \"tower1_2\"\n"),
            "s.toml:3:6: tower[1].on: goes round in a circle: \"tower1\" on \"tower1\"");
}

TEST(ParseError, PilesCarryNothing) {
  EXPECT_EQ(toml_error("[[pile]]\ncount = 1\nregion = [0, 0, 3, 3]\n[[cube]]\non = \"pile1_1\"\n"),
            "s.toml:5:6: cube[1].on: \"pile1_1\" is in a pile, which is scattered last and cannot "
            "carry anything");
}

TEST(ParseError, PairsAreOfTwoBodiesAndGivenOnce) {
  const std::string bodies = "[[plane]]\n" + std::string(cube_text);
  EXPECT_EQ(toml_error(bodies + "[[pair]]\nbodies = [\"cube1\", \"cube1\"]\nfriction = 1\n"),
            "s.toml:5:10: pair[1].bodies: must be two different bodies");
  EXPECT_EQ(toml_error(bodies
                       + "[[pair]]\nbodies = [\"cube1\", \"plane1\"]\nfriction = 1\n"
                         "[[pair]]\nbodies = [\"plane1\", \"cube1\"]\nfriction = 1\n"),
            "s.toml:8:10: pair[2].bodies: the pair \"plane1\", \"cube1\" is given twice");
}

TEST(ParseError, ColoursAndBondsAreKnownOnes) {
  EXPECT_EQ(with_cube("color = \"vermilion\""),
            "s.toml:3:9: cube[1].color: must be \"#rrggbb\" or the name of a colour, not text "
            "(\"vermilion\"); did you mean \"vermillion\"?");
  EXPECT_EQ(with_cube("color = \"#12345\"").substr(0, 73),
            "s.toml:3:9: cube[1].color: must be \"#rrggbb\" or the name of a colour, not");
  EXPECT_EQ(toml_error("[[wall]]\nrows = 2\ncolumns = 2\nbase = [0, 0]\nbond = \"english\"\n"),
            "s.toml:5:8: wall[1].bond: must be \"running\" or \"stack\", not text (\"english\")");
}

TEST(ParseError, OverlapsNameBothBodiesAndTheDepth) {
  EXPECT_EQ(toml_error("[[cube]]\nname = \"a\"\nposition = [0, 1]\n"
                       "[[cube]]\nname = \"b\"\nposition = [0.25, 1.5]\n"),
            "s.toml:4:1: cube[2]: \"b\" and \"a\" overlap by 0.5 m; move them apart, or let one "
            "stand on the other with `on`");
  EXPECT_EQ(toml_error("[[plane]]\n[[cube]]\nposition = [0, 0.4]\n"),
            "s.toml:2:1: cube[1]: \"cube1\" and \"plane1\" overlap by 0.1 m; move them apart, or "
            "let one stand on the other with `on`");
  EXPECT_EQ(toml_error(std::string(cube_text) + "[[fixed]]\nposition = [0.9, 1]\n"),
            "s.toml:3:1: fixed[1]: \"cube1\" and \"fixed1\" overlap by 0.1 m; move them apart, or "
            "let one stand on the other with `on`");
  EXPECT_EQ(json_error(R"({"cube": [{"position": [0, 1]}, {"position": [0.25, 1]}]})"),
            "s.json: cube[2]: \"cube2\" and \"cube1\" overlap by 0.75 m; move them apart, or let "
            "one stand on the other with `on`");
}

TEST(ParseError, AbsurdCountsAreRefused) {
  EXPECT_EQ(toml_error("[[tower]]\ncount = 300000\nbase = [0, 0]\n"),
            "s.toml:2:9: tower[1].count: must be between 1 and 200000; it is 300000");
  EXPECT_EQ(toml_error("[[wall]]\nrows = 200000\ncolumns = 200000\nbase = [0, 0]\n"),
            "s.toml: the scene has 40000200000 cubes, points and fixed boxes; at most 200000 are "
            "allowed");
  EXPECT_EQ(toml_error("[[tower]]\ncount = 0\nbase = [0, 0]\n"),
            "s.toml:2:9: tower[1].count: must be greater than 0; it is 0");
}

TEST(ParseError, PilesThatDoNotFitSayHowFarTheyCame) {
  const std::string error = toml_error("[[pile]]\ncount = 50\nregion = [0, 0, 3, 3]\n");
  EXPECT_EQ(error.substr(0, 26), "s.toml:3:10: pile[1]: only");
  EXPECT_NE(
      error.find(
          "of 50 cubes found a place clear of all others; enlarge the region or ask for fewer"),
      std::string::npos)
      << error;
  EXPECT_EQ(
      toml_error("[[pile]]\ncount = 5\nregion = [0, 0, -3, 3]\n"),
      "s.toml:3:10: pile[1].region: must be [xmin, ymin, xmax, ymax] with xmin < xmax and ymin "
      "< ymax");
}

}  // namespace
}  // namespace wuerfel::test
