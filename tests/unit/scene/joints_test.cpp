// Points, rods and pins of a scene: places, defaults, and what cannot be joined.
#include <gtest/gtest.h>

#include "core/scene/overlap.h"
#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

const std::string two_bodies =
    "cube = [{name = \"a\", size = [2, 1], position = [0, 5]}, {name = \"b.c\", position = [4, "
    "5]}]\n"
    "point = [{name = \"p\", position = [0, 2], mass = 3}]\n"
    "plane = [{name = \"floor\"}]\n";

Scene scene_with(const std::string& more) { return parse_scene(two_bodies + more, "s.toml"); }
std::string error_with(const std::string& more) { return toml_error(two_bodies + more); }

TEST(Joints, PlacesAreThoseOfThePart) {
  const Scene scene = scene_with(
      "rod = [{from = \"a.ne\", to = \"b.c\"}, {from = \"a.s\", to = [0.0, 3.0]},"
      "{from = {body = \"a\", at = [0.5, 0.25]}, to = \"p\"}, {from = \"b.c.w\", to = \"a\"}]\n");
  ASSERT_EQ(scene.rods.size(), 4U);
  EXPECT_EQ(scene.rods[0].name, "rod1");
  EXPECT_EQ(scene.rods[0].from.at, Vec2(1.0, 0.5));
  EXPECT_EQ(scene.rods[0].to.at, Vec2(0.0, 0.0));
  EXPECT_EQ(scene.rods[0].to.body, "b.c") << "a name with a dot is a name first";
  EXPECT_EQ(scene.rods[1].to.body, "");
  EXPECT_DOUBLE_EQ(scene.rods[1].length, 1.5);
  EXPECT_EQ(scene.rods[2].from.at, Vec2(0.5, 0.25));
  EXPECT_EQ(scene.rods[3].from.at, Vec2(-0.5, 0.0));
}

TEST(Joints, PointsHaveDefaultsAndAreBodies) {
  const Scene scene = parse_scene("[[point]]\nposition = [1, 2]\n", "s.toml");
  ASSERT_EQ(scene.points.size(), 1U);
  EXPECT_EQ(scene.points[0].name, "point1");
  EXPECT_EQ(scene.points[0].mass, 1.0);
  EXPECT_EQ(moving_name(scene, 0), "point1");
}

TEST(Joints, ComeBackFromTheNormalisedForm) {
  const Scene scene = scene_with(
      "rod = [{from = \"a.ne\", to = \"b.c\", name = \"r\"}, {from = \"p\", to = [0.1, 0.3]}]\n"
      "pin = [{from = \"b.c.se\", to = [4.5, 4.5]}, {from = \"p\", to = [0.0, 2.0], collide = "
      "true}]\n");
  const std::string json = normalised_scene(scene);
  EXPECT_EQ(parse_scene(json, "normalised"), scene);
  EXPECT_EQ(normalised_scene(parse_scene(json, "normalised")), json);
}

TEST(Joints, AreOverriddenByName) {
  const Scene scene = parse_scene(two_bodies + "rod = [{name = \"r\", from = \"a\", to = \"p\"}]\n",
                                  "s.toml", {"rod.r.to=[0.0, 9.0]", "point.p.mass=7"});
  EXPECT_DOUBLE_EQ(scene.rods[0].length, 4.0);
  EXPECT_EQ(scene.points[0].mass, 7.0);
}

TEST(Joints, ErrorsNameThePlaceAndSuggest) {
  EXPECT_EQ(error_with("rod = [{from = \"aa\", to = \"p\"}]\n"),
            "s.toml:4:16: rod[1].from: there is no body \"aa\"; known: a, b.c, floor, p");
  EXPECT_EQ(error_with("rod = [{from = \"a.no\", to = \"p\"}]\n"),
            "s.toml:4:16: rod[1].from: \"a\" has no part \"no\"; did you mean \"ne\"?");
  EXPECT_EQ(error_with("rod = [{from = \"p.ne\", to = \"a\"}]\n"),
            "s.toml:4:16: rod[1].from: \"p\" is a point, which has no parts");
  EXPECT_EQ(
      error_with("rod = [{from = \"floor\", to = \"a\"}]\n"),
      "s.toml:4:16: rod[1].from: \"floor\" is a plane; name a place [x, y] of the world instead");
  EXPECT_EQ(error_with("rod = [{from = 3, to = \"a\"}]\n"),
            "s.toml:4:16: rod[1].from: must be \"BODY\", \"BODY.PART\", { body = .., at = [x, y] } "
            "or [x, y], not "
            "3");
  EXPECT_EQ(error_with("rod = [{to = \"a\"}]\n"), "s.toml:4:8: rod[1]: needs from");
}

TEST(Joints, APlaceThatIsABodyAndAPartOfAnotherIsRefused) {
  EXPECT_EQ(
      toml_error("cube = [{name = \"a\", position = [0, 5]}, {name = \"a.n\", position = [4, 5]}]\n"
                 "rod = [{from = \"a.n\", to = [0.0, 9.0]}]\n"),
      "s.toml:2:16: rod[1].from: \"a.n\" is a body of that name and a part of \"a\" as well; "
      "write { body = \"a.n\", at = [0, 0] } or { body = \"a\", at = [0, 0.5] }");
}

TEST(Joints, APlaceInAFrameTellsABodyFromAPart) {
  const std::string head =
      "cube = [{name = \"a\", position = [0, 5]}, {name = \"a.n\", position = [4, 5]},"
      "{name = \"p.n\", position = [8, 5]}]\npoint = [{name = \"p\", position = [0, 2]}]\n";
  const Scene scene = parse_scene(
      head + "rod = [{from = {body = \"a.n\", at = [0, 0]}, to = \"p\"}, {from = {body = \"a\", at = [0, 0.5]}, to = \"p.n\"}]\n",
      "s.toml");
  EXPECT_EQ(scene.rods[0].from.body, "a.n");
  EXPECT_EQ(scene.rods[1].from.body, "a");
  EXPECT_EQ(scene.rods[1].to.body, "p.n") << "a point has no parts";
}

TEST(Joints, WhatCannotBeJoinedIsRefused) {
  EXPECT_EQ(error_with("rod = [{from = \"a.ne\", to = \"a.sw\"}]\n"),
            "s.toml:4:8: rod[1]: \"rod1\" joins two places of one body, which keep their distance "
            "anyway");
  EXPECT_EQ(error_with("rod = [{from = [0, 0], to = [1, 1]}]\n"),
            "s.toml:4:8: rod[1]: \"rod1\" joins two places that cannot move");
  EXPECT_EQ(error_with("rod = [{from = \"p\", to = [0, 2]}]\n"),
            "s.toml:4:8: rod[1]: \"rod1\" has no length, for its places coincide; use a [[pin]]");
  EXPECT_EQ(error_with("rod = [{from = \"p\", to = [0, 3], length = 1.5}]\n"),
            "s.toml:4:43: rod[1].length: must be the distance of the two places at the start, 1 m; "
            "it is 1.5 m");
  EXPECT_EQ(error_with("pin = [{from = \"p\", to = [0.3, 2.4]}]\n"),
            "s.toml:4:8: pin[1]: the places of \"pin1\" must coincide; they are 0.5 m apart: [0, "
            "2] and [0.3, 2.4]");
  EXPECT_EQ(error_with("rod = [{name = \"r\", from = \"p\", to = [0, 3]}, {name = \"r\", from = "
                       "\"p\", to = [0, 3]}]\n"),
            "s.toml:4:55: rod[2]: the name \"r\" is taken by another rod or pin");
}

TEST(Joints, LengthsStayWithinBounds) {
  EXPECT_EQ(error_with("rod = [{from = \"p\", to = [0, 1e13]}]\n"),
            "s.toml:4:8: rod[1]: \"rod1\" would be 9999999999998 m long, out of range");
}

TEST(Joints, PointsMayNotEnterBodies) {
  EXPECT_EQ(error_with("[[fixed]]\nname = \"f\"\nsize = 1\nposition = [0, 2.25]\n"),
            "s.toml:4:1: fixed[1]: the point \"p\" lies 0.25 m inside of \"f\"; move them apart");
  EXPECT_EQ(toml_error("plane = [{}]\npoint = [{position = [0, -1]}]\n"),
            "s.toml:2:10: point[1]: the point \"point1\" lies 1 m inside of \"plane1\"; move them "
            "apart");
  EXPECT_EQ(toml_error("[[point]]\nposition = [0, 0]\nmass = -1\n"),
            "s.toml:3:8: point[1].mass: must be greater than 0; it is -1");
  EXPECT_EQ(toml_error("[[point]]\nname = \"p\"\nposition = [0, 0]\n[[cube]]\non = \"p\"\n"),
            "s.toml:5:6: cube[1].on: \"p\" is a point, on which nothing can stand");
}

TEST(Joints, PinnedBodiesMayOverlap) {
  const std::string hinge =
      "cube = [{name = \"a\", position = [0, 0]}, {name = \"b\", position = [0.8, 0]}]\n";
  const std::string pin =
      "pin = [{from = {body = \"a\", at = [0.4, 0]}, to = {body = \"b\", at = [-0.4, 0]}";
  EXPECT_FALSE(find_overlap(parse_scene(hinge + pin + "}]\n", "s.toml")).has_value());
  EXPECT_EQ(toml_error(hinge + pin + ", collide = true}]\n"),
            "s.toml:1:42: cube[2]: \"b\" and \"a\" overlap by 0.2 m; move them apart, or let one "
            "stand on the other with "
            "`on`");
}

}  // namespace
}  // namespace wuerfel::test
