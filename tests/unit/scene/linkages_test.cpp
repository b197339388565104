// Chains and trusses: places, names, joints, and what cannot be laid.
#include <cmath>

#include <gtest/gtest.h>

#include "core/scene/chain.h"
#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

constexpr double laid = 1e-14;

Scene scene_of(const std::string& text) { return parse_scene(text, "s.toml"); }

TEST(Chain, OfPointsHangsLooseFromItsFirstPlace) {
  const Scene scene =
      scene_of("[[chain]]\ncount = 4\nfrom = [1, 2]\nto = [1, 0]\nloose = true\nmass = 0.5\n");
  ASSERT_EQ(scene.points.size(), 4U);
  ASSERT_EQ(scene.rods.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(scene.points[i].name, "chain1_" + std::to_string(i + 1));
    EXPECT_NEAR((scene.points[i].position - Vec2(1.0, 1.5 - 0.5 * i)).norm(), 0.0, laid);
    EXPECT_EQ(scene.points[i].mass, 0.5);
    EXPECT_NEAR(scene.rods[i].length, 0.5, laid);
  }
  EXPECT_EQ(scene.rods[0].name, "chain1_rod1");
  EXPECT_EQ(scene.rods[0].from.body, "");
  EXPECT_EQ(scene.rods[3].from.body, "chain1_3");
  EXPECT_EQ(scene.rods[3].to.body, "chain1_4");
}

TEST(Chain, LongerThanItsDistanceSagsAlongAnArcWithEqualRods) {
  const Scene scene = scene_of(
      "[[chain]]\nname = \"c\"\ncount = 7\nfrom = [0, 1]\nto = [2, 1]\nlength = 3\n"
      "[[chain]]\nname = \"up\"\ncount = 1\nfrom = [2, 5]\nto = [0, 5]\nlength = 2.5\n");
  ASSERT_EQ(scene.rods.size(), 10U);
  for (int i = 0; i < 8; ++i)
    EXPECT_NEAR(scene.rods[i].length, 0.375, laid);
  EXPECT_NEAR(scene.points[3].position.x(), 1.0, laid);
  EXPECT_LT(scene.points[3].position.y(), 0.2);
  // Three points of it and all others lie on one circle.
  const Vec2 low = scene.points[3].position;
  const double sag = 1.0 - low.y();
  const double radius = 0.5 * (1.0 + sag * sag) / sag;
  for (int i = 0; i < 7; ++i)
    EXPECT_NEAR((scene.points[i].position - low - Vec2(0.0, radius)).norm(), radius, 1e-13);
  // Two rods of 1.25 m over 2 m: a triangle, below whichever way it is written.
  EXPECT_NEAR((scene.points[7].position - Vec2(1.0, 4.25)).norm(), 0.0, laid);
}

TEST(Chain, OfCubesThatFillItsLengthIsPinned) {
  const Scene scene = scene_of(
      "[[chain]]\ncount = 10\nfrom = [0, 0]\nto = [3, 4]\nsize = [0.5, 0.1]\nloose = true\n");
  ASSERT_EQ(scene.cubes.size(), 10U);
  EXPECT_TRUE(scene.rods.empty());
  ASSERT_EQ(scene.pins.size(), 10U);
  EXPECT_EQ(scene.pins[0].name, "chain1_pin1");
  EXPECT_EQ(scene.pins[0].from.body, "");
  EXPECT_EQ(scene.pins[1].from.at, Vec2(0.25, 0.0));
  EXPECT_EQ(scene.pins[1].to.at, Vec2(-0.25, 0.0));
  EXPECT_NEAR((scene.cubes[9].position - Vec2(2.85, 3.8)).norm(), 0.0, laid);
  EXPECT_NEAR(scene.cubes[9].angle, std::atan2(4.0, 3.0), laid);
}

TEST(Chain, OfCubesThatLeaveRoomHasRodsBetweenTheirEnds) {
  const Scene scene = scene_of(
      "[[fixed]]\nname = \"f\"\nsize = 1\nposition = [-0.5, 0]\n"
      "[[chain]]\ncount = 2\nfrom = \"f.e\"\nto = [1.6, 0]\nsize = [0.5, 0.2]\nlength = 2.0\n"
      "density = 3\ncolor = \"blue\"\n");
  ASSERT_EQ(scene.cubes.size(), 2U);
  ASSERT_EQ(scene.rods.size(), 3U);
  for (const SceneRod& rod : scene.rods)
    EXPECT_NEAR(rod.length, 1.0 / 3.0, 1e-13);
  EXPECT_EQ(scene.rods[0].from.body, "f");
  EXPECT_EQ(scene.rods[2].to.body, "");
  EXPECT_DOUBLE_EQ(scene.cubes[0].mass, 0.3);
  EXPECT_TRUE(scene.cubes[1].color.has_value());
}

TEST(Chain, MayHangFromALinkOfAnEarlierOneAndComesBackFromTheNormalisedForm) {
  const std::string first = "[[chain]]\ncount = 3\nfrom = [0, 0]\nto = [1, 0.3]\nlength = 1.7\n";
  const Scene scene = scene_of(first
                               + "[[chain]]\ncount = 2\nfrom = \"chain1_2\"\nto = [0.5, -3]\n"
                                 "loose = true\nsize = 0.1\n[[truss]]\ncount = 5\nfrom = [3, "
                                 "0]\nto = [7, 1]\n");
  EXPECT_EQ(parse_scene(normalised_scene(scene), "-"), scene);
  EXPECT_EQ(
      toml_error("[[chain]]\ncount = 2\nfrom = \"chain2_1\"\nto = [0, -3]\nloose = true\n" + first),
      "s.toml:3:8: chain[1].from: \"chain2_1\" has no place yet when \"chain1\" is laid: "
      "chains are laid one after the other, piles scattered last");
}

TEST(Chain, KeysAreOverridden) {
  const Scene scene =
      parse_scene("[[chain]]\ncount = 4\nfrom = [1, 2]\nto = [1, 0]\nloose = true\n", "s.toml",
                  {"chain.chain1.count=9", "chain.1.mass=2"});
  EXPECT_EQ(scene.points.size(), 9U);
  EXPECT_EQ(scene.points[8].mass, 2.0);
}

TEST(Chain, WhatCannotBeLaidIsRefused) {
  const auto error = [](const std::string& more) {
    return toml_error("[[chain]]\ncount = 4\nfrom = [0, 0]\nto = [2, 0]\n" + more);
  };
  EXPECT_EQ(error(""),
            "s.toml:4:6: chain[1].to: \"chain1\" would be taut between two places that cannot "
            "move; give it a length above 2 m, or loose = true");
  EXPECT_EQ(error("length = 1.5\n"),
            "s.toml:5:10: chain[1].length: must be at least the distance of its ends, 2 m; it is "
            "1.5 m");
  EXPECT_EQ(error("length = 3\nsize = [0.8, 0.1]\n"),
            "s.toml:6:8: chain[1].size: 4 links of 0.8 m are longer than the chain, 3 m");
  EXPECT_EQ(error("loose = true\ncolor = \"blue\"\n"),
            "s.toml:6:1: chain[1].color: is of use only together with size");
  EXPECT_EQ(toml_error("[[chain]]\ncount = 1\nfrom = [0, 0]\nto = \"p\"\n"),
            "s.toml:4:6: chain[1].to: there is no body \"p\"; known: chain1_1");
  EXPECT_EQ(toml_error("[[chain]]\ncount = 2\nfrom = [0, 0]\nto = [0, 0]\nloose = true\n"),
            "s.toml:4:6: chain[1].to: must be another place than `from`");
  EXPECT_EQ(
      toml_error("[[chain]]\ncount = 2\nfrom = [0, 0]\nto = [0, 2]\nloose = true\nsize = "
                 "0.5\n[[cube]]\non = \"chain1_1\"\n"),
      "s.toml:8:6: cube[1].on: \"chain1_1\" is in a chain, which is laid when all that stands "
      "has its place");
}

TEST(CornersOnArc, CloseTheChordForUnequalSegmentsToo) {
  const std::vector<double> segments = {0.2, 1.0, 0.2, 1.0, 0.2};
  for (const double distance : {2.599999999, 2.0, 0.5}) {
    const std::vector<Vec2> corners = corners_on_arc(segments, distance);
    ASSERT_EQ(corners.size(), 6U);
    EXPECT_NEAR((corners.back() - Vec2(distance, 0.0)).norm(), 0.0, 1e-14);
    for (int k = 0; k < 5; ++k)
      EXPECT_NEAR((corners[k + 1] - corners[k]).norm(), segments[k], 1e-15);
  }
  EXPECT_TRUE(corners_on_arc({0.1, 1.0, 0.1}, 0.9).empty()) << "the long one needs more than half";
}

const std::string truss = "[[truss]]\ncount = 4\nfrom = [0, 1]\nto = [8, 1]\nheight = 1.5\n";

const SceneRod& rod_named(const Scene& scene, const std::string& name) {
  for (const SceneRod& rod : scene.rods)
    if (rod.name == name) return rod;
  throw std::out_of_range(name);
}

std::string ends(const Scene& scene, const std::string& name) {
  const SceneRod& rod = rod_named(scene, name);
  return rod.from.body + " " + rod.to.body;
}

TEST(Truss, HasJustAsManyRodsAsItNeeds) {
  for (const char* kind : {"pratt", "howe", "warren"}) {
    for (const char* count : {"2", "3", "7", "8"}) {
      const Scene scene = parse_scene(
          truss, "s.toml",
          {std::string("truss.1.kind=\"") + kind + "\"", std::string("truss.1.count=") + count});
      EXPECT_EQ(scene.rods.size() + 2 * scene.pins.size(), 2 * scene.points.size())
          << kind << count;
    }
  }
}

TEST(Truss, OfPrattHasDiagonalsThatFallTowardsTheMiddle) {
  const Scene scene = scene_of(truss);
  EXPECT_EQ(ends(scene, "truss1_bottom4"), "truss1_b3 truss1_b4");
  EXPECT_EQ(ends(scene, "truss1_top2"), "truss1_t2 truss1_t3");
  EXPECT_EQ(ends(scene, "truss1_post2"), "truss1_b2 truss1_t2");
  EXPECT_EQ(ends(scene, "truss1_diagonal1"), "truss1_b0 truss1_t1");
  EXPECT_EQ(ends(scene, "truss1_diagonal2"), "truss1_t1 truss1_b2");
  EXPECT_EQ(ends(scene, "truss1_diagonal3"), "truss1_b2 truss1_t3");
  EXPECT_EQ(ends(scene, "truss1_diagonal4"), "truss1_t3 truss1_b4");
  EXPECT_EQ(scene.points[5].name, "truss1_t1");
  EXPECT_EQ(scene.points[5].position, Vec2(2.0, 2.5));
  EXPECT_EQ(scene.pins[0].name, "truss1_left");
  EXPECT_EQ(rod_named(scene, "truss1_right").to.at, Vec2(8.0, -0.5));
}

TEST(Truss, OfHoweAndWarrenAreOthers) {
  const Scene howe = scene_of(truss + "kind = \"howe\"\nsupports = \"pins\"\n");
  EXPECT_EQ(ends(howe, "truss1_diagonal2"), "truss1_b1 truss1_t2");
  EXPECT_EQ(ends(howe, "truss1_diagonal3"), "truss1_t2 truss1_b3");
  EXPECT_EQ(howe.pins.size(), 2U);
  const Scene warren = scene_of(truss + "kind = \"warren\"\nsupports = \"none\"\nname = \"w\"\n");
  EXPECT_EQ(ends(warren, "w_diagonal8"), "w_t4 w_b4");
  EXPECT_EQ(warren.points[5].position, Vec2(1.0, 2.5));
  EXPECT_TRUE(warren.pins.empty());
}

TEST(Truss, ErrorsNameThePlace) {
  EXPECT_EQ(
      toml_error(truss + "kind = \"prat\"\n"),
      "s.toml:6:8: truss[1].kind: must be \"pratt\", \"howe\" or \"warren\", not text (\"prat\")");
  EXPECT_EQ(toml_error("[[truss]]\ncount = 1\nfrom = [0, 0]\nto = [1, 0]\n"),
            "s.toml:2:9: truss[1].count: must be between 2 and 50000; it is 1");
  EXPECT_EQ(toml_error("[[truss]]\ncount = 3\nfrom = [1, 0]\nto = [1, 0]\n"),
            "s.toml:4:6: truss[1].to: must be another place than `from`");
  EXPECT_EQ(toml_error(truss
                       + "[[rod]]\nname = \"truss1_top1\"\nfrom = \"truss1_t1\"\nto = [0, "
                         "9]\n"),
            "s.toml:1:1: truss[1]: the name \"truss1_top1\" is taken by another rod or pin");
}

}  // namespace
}  // namespace wuerfel::test
