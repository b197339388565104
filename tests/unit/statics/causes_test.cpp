// First causes, mechanisms, and fixes that stand while 99.9 % of them falls.
#include "core/statics/causes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/statics/carried.h"
#include "core/statics/fixes.h"
#include "core/statics/margins.h"
#include "tests/support/reference_case.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

TEST(Causes, OfAHarmonicStackAreAllInterfacesAtOnce) {
  const double eps = 1e-3;
  const StillScene scene = still(harmonic(5, eps));
  const Causes found = find_causes(scene);
  ASSERT_EQ(found.causes.size(), 5U);
  for (std::size_t k = 0; k < found.causes.size(); ++k) {
    const Cause& cause = found.causes[k];
    EXPECT_EQ(cause.part.cubes.size(), k + 1);
    EXPECT_EQ(cause.failure, FailureMode::tips);
    EXPECT_EQ(cause.sense, 1);
    ASSERT_TRUE(cause.outside && cause.corner);
    EXPECT_NEAR(*cause.outside, 0.5 * eps, 1e-12);
    const double below = 5.0 - static_cast<double>(k + 1);
    EXPECT_NEAR(cause.corner->y(), below, 1e-12);
    EXPECT_EQ(scene.system.body(cause.on.front()).name,
              below == 0.0 ? "table" : "b" + std::to_string(4 - static_cast<int>(k) - 1));
  }
  EXPECT_TRUE(found.mechanism.empty());
}

TEST(Causes, NameTheSmallestPartFirst) {
  const Causes found = find_causes(still(shipped_scene("fig1_stack")));
  ASSERT_FALSE(found.causes.empty());
  EXPECT_EQ(found.causes.front().part.cubes.size(), 3U);
  EXPECT_NEAR(*found.causes.front().outside, 0.35 / 3.0, 1e-9);
}

TEST(Causes, OfAFallingDiamondAreAMechanism) {
  const StillScene scene = still(read_reference_case("pz_diamond5").scene);
  ASSERT_EQ(scene.verdict, Verdict::falls);
  const Causes found = find_causes(scene);
  EXPECT_TRUE(found.causes.empty());
  ASSERT_GT(found.mechanism.size(), 1U);
  double work = 0.0;
  for (const MovingPart& part : found.mechanism)
    work += part.work_share;
  EXPECT_NEAR(work, 1.0, 1e-9);
}

// Weights do work along the motion, and no contact closes: that is the proof.
TEST(Causes, HaveACertificate) {
  for (const std::string name : {"harmonic_N5_plus1em2", "pz_n4_falls_1em2", "pz_diamond5",
                                 "random_stack_02", "incline_square"}) {
    const StillScene scene = still(read_reference_case(name).scene);
    if (scene.verdict != Verdict::falls) continue;
    const Causes found = find_causes(scene);
    EXPECT_GT(found.certificate.power, 0.0) << name;
    EXPECT_GT(found.certificate.worst_closing, -1e-9) << name;
  }
}

TEST(Causes, OfASceneThatStandsAreNone) {
  EXPECT_TRUE(find_causes(still(shipped_scene("wall"))).causes.empty());
  EXPECT_FALSE(first_cause(still(shipped_scene("wall"))));
}

TEST(Causes, WhatNothingCarriesDropsAndWhatNothingHoldsSlides) {
  const std::optional<Cause> drops = first_cause(still(on_floor({cube("a", {0.0, 3.0})})));
  ASSERT_TRUE(drops);
  EXPECT_EQ(drops->failure, FailureMode::drops);
  const std::optional<Cause> slides =
      first_cause(still(read_reference_case("incline_square").scene));
  ASSERT_TRUE(slides);
  EXPECT_EQ(slides->failure, FailureMode::slides);
  EXPECT_FALSE(slides->corner);
}

// The motion that proves it leaves the wall as well as it goes down.
TEST(Causes, WhatTouchesAWallSlidesDown) {
  for (const double side : {1.0, -1.0}) {
    Scene scene = on_floor({cube("a", {0.5 * side, 3.0})});
    scene.planes.push_back({"wall", Vec2::Zero(), Vec2(side, 0.0), {}});
    const std::optional<Cause> slides = first_cause(still(with_friction(scene, 0.5)));
    ASSERT_TRUE(slides);
    EXPECT_EQ(slides->failure, FailureMode::slides);
    EXPECT_EQ(slides->sense, 0);
  }
}

TEST(Causes, WhatTheSlopeDoesNotHoldSlidesDownThere) {
  for (const double side : {1.0, -1.0}) {
    const Vec2 normal(0.6 * side, 0.8);
    Scene scene;
    scene.cubes = {cube("a", 0.5 * normal, -side * std::asin(0.6))};
    scene.planes = {{"slope", Vec2::Zero(), normal, {}}};
    const std::optional<Cause> slides = first_cause(still(with_friction(scene, 0.7)));
    ASSERT_TRUE(slides);
    EXPECT_EQ(slides->failure, FailureMode::slides);
    EXPECT_EQ(slides->sense, side > 0.0 ? 1 : -1);
  }
}

// Turned by 0.7 rad with gravity: rounding leaves forces of 1e-19 N between sides that touch.
TEST(Causes, WhatFallsInTouchIsNotCarried) {
  const Vec2 along{std::cos(0.7), std::sin(0.7)};
  Scene scene;
  scene.gravity = g * Vec2(along.y(), -along.x());
  for (int i = 0; i < 3; ++i) {
    scene.cubes.push_back(
        cube("b" + std::to_string(i), (1.8 + 1.3 * i) * along + 5.0 * Vec2(-along.y(), along.x())));
    scene.cubes.back().size = {1.3, 0.5};
    scene.cubes.back().angle = 0.7;
  }
  const Causes found = find_causes(still(scene));
  ASSERT_EQ(found.causes.size(), 3U);
  for (const Cause& cause : found.causes)
    EXPECT_EQ(cause.failure, FailureMode::drops) << cause.on.size();
}

TEST(Causes, WhatHangsOnARodSwings) {
  Scene scene = parse_scene(
      "version = 1\n[[cube]]\nname = \"a\"\nposition = [1.0, 0.0]\n"
      "[[rod]]\nfrom = \"a\"\nto = [0.0, 0.0]\n",
      "pendulum");
  const std::optional<Cause> swings = first_cause(still(scene));
  ASSERT_TRUE(swings);
  EXPECT_EQ(swings->failure, FailureMode::swings);
  EXPECT_GT(find_causes(still(scene)).certificate.power, 0.0);
  scene = parse_scene(
      "version = 1\n[[cube]]\nname = \"a\"\nposition = [0.0, -2.0]\n"
      "[[point]]\nname = \"p\"\nposition = [0.0, -4.0]\n"
      "[[rod]]\nfrom = \"a.n\"\nto = [0.0, 0.0]\n[[rod]]\nfrom = \"a.s\"\nto = \"p\"\n",
      "hangs");
  EXPECT_EQ(still(scene).verdict, Verdict::stands);
  EXPECT_FALSE(first_cause(still(scene)));
  const Margins margins = find_margins(still(scene), {});
  ASSERT_EQ(margins.bodies.size(), 2U);
  EXPECT_TRUE(is_empty(margins.bodies[1].shift));  // a point has no room to shift in
  EXPECT_NEAR(margins.bodies[0].shift.high - margins.bodies[0].shift.low, 0.0, 1e-12);
}

void expect_fixes_are_the_smallest(const Scene& scene, std::size_t at_least) {
  const StillScene falling = still(scene);
  ASSERT_EQ(falling.verdict, Verdict::falls);
  const std::vector<Fix> fixes = find_fixes(falling, {}, find_causes(falling));
  EXPECT_GE(fixes.size(), at_least);
  constexpr double nearly = 0.999;
  for (const Fix& fix : fixes) {
    EXPECT_EQ(fix.verified, Verdict::stands);
    if (fix.kind == Fix::Kind::move) {
      const CarriedGroup group = carried_group(falling, fix.cube).value();
      EXPECT_EQ(move(falling, {}, group, fix.distance).verdict, Verdict::stands);
      EXPECT_NE(move(falling, {}, group, nearly * fix.distance).verdict, Verdict::stands)
          << fix.cube << " by " << fix.distance;
    } else {
      EXPECT_EQ(verdict_with_force(falling, fix.cube, fix.point, fix.force), Verdict::stands);
      EXPECT_NE(verdict_with_force(falling, fix.cube, fix.point, nearly * fix.force),
                Verdict::stands)
          << fix.cube << " with " << fix.force.norm();
    }
  }
}

TEST(Fixes, StandAndAThousandthLessFalls) {
  expect_fixes_are_the_smallest(harmonic(5, 1e-2), 2);
  expect_fixes_are_the_smallest(harmonic(5, 1e-3), 2);
  expect_fixes_are_the_smallest(harmonic(10, 1e-4), 1);
  expect_fixes_are_the_smallest(shipped_scene("fig1_stack"), 4);
  expect_fixes_are_the_smallest(shipped_scene("overhang_falls"), 2);
  expect_fixes_are_the_smallest(shipped_scene("demo"), 2);
  expect_fixes_are_the_smallest(shipped_scene("incline_friction"), 1);
  expect_fixes_are_the_smallest(read_reference_case("pz_n4_falls_1em2").scene, 1);
  expect_fixes_are_the_smallest(read_reference_case("pz_diamond5").scene, 1);
  expect_fixes_are_the_smallest(read_reference_case("seesaw_tips").scene, 0);
}

// The top overhangs by 0.55 of its length: 50 mm less, or a force at an end.
TEST(Fixes, OfOneBlockAreKnown) {
  const Scene scene = on_floor({cube("base", {0.0, 0.5}), cube("top", {0.55, 1.5})});
  const StillScene falling = still(scene);
  const std::vector<Fix> fixes = find_fixes(falling, {}, find_causes(falling));
  ASSERT_EQ(fixes.size(), 2U);
  EXPECT_EQ(fixes[0].kind, Fix::Kind::move);
  EXPECT_NEAR(fixes[0].distance, -0.05, 1e-9);
  EXPECT_NEAR(fixes[1].force.y(), g * 0.05 / 0.55, 1e-9 * g);
  EXPECT_NEAR(fixes[1].point.x(), 1.05, 1e-12);
  EXPECT_NEAR(fixes[1].point.y(), 1.0, 1e-12);  // it pushes from below
}

// The same force at any corner holds what slides.
TEST(Fixes, PushAtTheUpperCornerBehindWhatSlides) {
  for (const double way : {-1.0, 1.0}) {
    Scene scene = on_floor({cube("a", {3.0, 0.5})});
    scene.gravity = g * Vec2(0.3 * way, -1.0);
    scene.cubes[0].size = {2.0, 1.0};
    const StillScene sliding = still(scene);
    const std::vector<Fix> fixes = find_fixes(sliding, {}, find_causes(sliding));
    ASSERT_EQ(fixes.size(), 1U);
    EXPECT_NEAR((fixes[0].point - Vec2(3.0 + way, 1.0)).norm(), 0.0, 1e-12)
        << fixes[0].point.transpose();
  }
}

}  // namespace
}  // namespace wuerfel::test
