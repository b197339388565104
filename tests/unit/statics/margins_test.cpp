// Margins against closed forms, and how they scale.
#include "core/statics/margins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/statics/carried.h"
#include "tests/support/reference_case.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

constexpr double exact = 1e-9;          // relative
constexpr double exact_length = 1e-12;  // m

Margins margins(const Scene& scene, const MarginRequest& request = {true, true, true, false, {}}) {
  return find_margins(still(scene), {}, request);
}

LoadRange shift_of_top(const Scene& scene) {
  const int top = static_cast<int>(scene.cubes.size()) - 1;
  return margins(scene, {false, false, true, false, {top}}).bodies.front().shift;
}

LoadRange load_on_top(const Scene& scene) {
  const auto height = [](const SceneCube& c) { return c.position.y(); };
  const int top =
      static_cast<int>(std::ranges::max_element(scene.cubes, {}, height) - scene.cubes.begin());
  return margins(scene, {false, true, false, false, {top}}).bodies.front().load;
}

TEST(Margins, ABlockMayBeTiltedByItsWidthOverItsHeight) {
  for (const Vec2& size : {Vec2(1.0, 1.0), Vec2(0.3, 2.0), Vec2(5.0, 0.7)}) {
    const Scene block = on_floor({sized_cube("a", {0.0, 0.5 * size.y()}, size)});
    const double slim = size.x() / size.y();
    const LoadRange tilt = tilt_range(still(block), Sliding::none);
    EXPECT_NEAR(tilt.high, slim, exact * slim);
    EXPECT_NEAR(tilt.low, -slim, exact * slim);
    for (const double mu : {0.1, 0.6, 3.0, 20.0}) {
      const double most = std::min(mu, slim);
      EXPECT_NEAR(tilt_range(still(with_friction(block, mu)), Sliding::given).high, most,
                  exact * most);
    }
    EXPECT_EQ(tilt_range(still(block), Sliding::given).high, 0.0);
  }
}

TEST(Margins, ATowerMayBeTiltedByOneOverItsHeight) {
  for (const int n : {1, 2, 5, 10, 100}) {
    const LoadRange tilt = tilt_range(still(on_floor(leaning_tower(n, 0.0))), Sliding::none);
    EXPECT_NEAR(tilt.high, 1.0 / n, exact / n) << n;
    EXPECT_NEAR(tilt.low, -1.0 / n, exact / n) << n;
  }
}

TEST(Margins, TheTopOfAHarmonicStackMayShiftByHalfOfWhatItIsShortBy) {
  for (const double eps : {1e-2, 1e-4, 1e-6}) {
    const LoadRange shift = shift_of_top(harmonic(10, -eps));
    EXPECT_NEAR(shift.high, 0.5 * eps, exact_length) << eps;
    EXPECT_NEAR(shift.low, -0.5, exact_length);
  }
}

TEST(Margins, ALoadOnAHarmonicStackTipsTheInterfaceThatIsFirst) {
  for (const double eps : {1e-2, 1e-4, 1e-6}) {
    const int n = 10;
    const Scene scene = harmonic(n, -eps);
    const auto x = [&](int cube) {
      return static_cast<long double>(scene.cubes[cube].position.x());
    };
    const long double top = x(n - 1);
    long double least = std::numeric_limits<long double>::infinity();
    long double sum = 0.0L;
    for (int i = 1; i <= n; ++i) {  // i cubes above an edge
      sum += x(n - i);
      const long double edge = i == n ? 0.0L : x(n - i - 1) + 0.5L;
      if (top > edge) least = std::min(least, i * 9.81L * (edge - sum / i) / (top - edge));
    }
    const LoadRange load = load_on_top(scene);
    EXPECT_NEAR(load.high, static_cast<double>(least), exact * static_cast<double>(least)) << eps;
    EXPECT_NEAR(load.low, -g, exact * g);  // lifts the top block off
  }
}

// [Paterson, Zwick 2009]: a diamond of m needs 2^m - m^2 - 1 weights on its top, but no less than
// what lifts the top itself.
//    +---+
//    | c |        The middle of c is over the end of what bears it, but for rounding.
//    +---+---+
//    |   b   |
//    +--+----+-+
//       |  a  |
TEST(Loads, OverTheEndOfASupportHaveNoLimit) {
  Scene scene = on_floor({sized_cube("a", {1.1482562027345393, 0.5877159350269974},
                                     {1.2965124054690784, 1.1754318700539947}),
                          sized_cube("b", {1.0, 1.6754318700539947}, {2.0, 1.0}),
                          sized_cube("c", {0.5, 2.4254318700539947}, {1.0, 0.5})});
  set_friction(0.6, scene);
  scene.cubes[0].material.friction = 0.5500903186325748;
  scene.cubes[1].mass = 7.270497344737642;
  scene.cubes[2].material.friction = 0.0;
  EXPECT_EQ(load_on_top(scene).high, unbounded);
}

TEST(Margins, DiamondsNeedTheLoadOfPatersonAndZwick) {
  const auto weights = [](int m) {
    const ReferenceCase diamond = read_reference_case("pz_diamond" + std::to_string(m));
    return load_on_top(diamond.scene).low / (g * diamond.scene.cubes.front().mass);
  };
  EXPECT_NEAR(weights(2), -1.0, exact);
  EXPECT_NEAR(weights(3), -1.0, exact);
  EXPECT_NEAR(weights(4), -1.0, exact);
  EXPECT_NEAR(weights(5), 6.0, 6.0 * exact);
}

TEST(Margins, AWallWithFrictionMayBeTiltedByElevenOverTwentyOne) {
  const LoadRange tilt =
      tilt_range(still(shipped_scene("wall", {"material.friction=0.6"})), Sliding::given);
  EXPECT_NEAR(tilt.high, 11.0 / 21.0, exact);
  EXPECT_NEAR(tilt.low, -11.0 / 21.0, exact);
}

// Bricks wedge one another as hard as they like between the wall and what stands on the floor. Lifted, each takes along what
// rubs on it: lifts are whole weights.
TEST(Margins, OfCubesThatWedgeOneAnotherAreThoseOfTheScene) {
  const std::array bricks{Vec2(0.25, 2.0), Vec2(2.25, 0.5), Vec2(2.75, 1.0), Vec2(3.75, 1.0),
                          Vec2(0.0, 1.0),  Vec2(1.0, 0.5),  Vec2(1.5, 0.5),  Vec2(2.0, 0.5)};
  const std::array masses{1.0, 4.0, 1.0, 1.0, 4.0, 1.0, 1.0, 2.0};
  const std::array lifts{15.0, 8.0, 2.0, 1.0, 8.0, 4.0, 3.0, 2.0};  // weights of a kilogram
  std::vector<SceneCube> cubes;
  for (std::size_t k = 0; k < bricks.size(); ++k) {
    const Vec2 centre(bricks[k].x() + 0.5 * bricks[k].y(), k < 4 ? 0.5 : 1.5);
    cubes.push_back(sized_cube("b" + std::to_string(k), centre, {bricks[k].y(), 1.0}));
    cubes.back().mass = masses[k];
  }
  Scene scene = on_floor(std::move(cubes));
  scene.planes.push_back({"wall", Vec2::Zero(), Vec2::UnitX(), {}});
  const Margins found = margins(with_friction(scene, 1.0));
  ASSERT_EQ(found.bodies.size(), lifts.size());
  for (std::size_t k = 0; k < lifts.size(); ++k) {
    EXPECT_NEAR(-found.bodies[k].load.low, g * lifts[k], exact * g * lifts[k]) << k;
    EXPECT_EQ(found.bodies[k].load.high, unbounded) << k;
    EXPECT_EQ(found.bodies[k].shift.low, -unbounded) << k;
    EXPECT_EQ(found.bodies[k].shift.high, unbounded) << k;
  }
  EXPECT_LE(found.error, exact);
}

TEST(Margins, AKnifeEdgeHasNone) {
  const ReferenceCase wall = read_reference_case("hyper_wall_3x3");
  const Margins found = margins(wall.scene);
  ASSERT_TRUE(found.smallest);
  EXPECT_EQ(*found.smallest, 0.0);
  const LoadRange shift = shift_of_top(wall.scene);
  EXPECT_EQ(std::min(-shift.low, shift.high), 0.0);
  EXPECT_NEAR(shift.high - shift.low, 0.5, exact_length);
}

TEST(Margins, WhatFallsHasTheShiftThatMendsIt) {
  const Scene scene = harmonic(5, 1e-3);
  EXPECT_NEAR(shift_of_top(scene).high, -5e-4 * 5.0,
              exact_length);  // the deepest interface decides
  EXPECT_LT(*margins(scene).smallest, 0.0);
}

TEST(Margins, WhatFallsFreelyHasNone) {
  const Margins found = margins(on_floor({cube("a", {0.0, 3.0})}));
  EXPECT_FALSE(found.tilt);
  EXPECT_FALSE(found.smallest);
  EXPECT_TRUE(is_empty(found.bodies.front().shift));
}

TEST(Margins, TheWeakestIsFoundWithoutAskingAll) {
  for (const std::string name : {"overhang_stands", "fig1_stack_stands", "pyramid", "wall"}) {
    const StillScene scene = still(shipped_scene(name));
    const std::optional<Weakest> weakest = find_weakest(scene);
    ASSERT_TRUE(weakest) << name;
    const Margins all = find_margins(scene, {}, {false, false, true, false, {}});
    EXPECT_NEAR(weakest->share, *all.smallest, exact * *all.smallest) << name;
  }
}

// How far a cube can be moved: to the edge of what carries it, or to its neighbour.
TEST(Margins, AMoveEndsAtTheEdgeOrAtTheNeighbour) {
  Scene scene = on_floor(
      {sized_cube("base", {0.0, 0.5}, {4.0, 1.0}), cube("a", {0.0, 1.5}), cube("b", {1.25, 1.5})});
  const auto move = [&](int cube) {
    return margins(scene, {false, false, false, true, {cube}}).bodies.front().move;
  };
  EXPECT_NEAR(move(1).low, -2.0, exact_length);
  EXPECT_NEAR(move(1).high, 0.25, exact_length);
  EXPECT_NEAR(move(2).low, -0.25, exact_length);
  EXPECT_NEAR(move(2).high, 0.75, exact_length);
  EXPECT_EQ(move(0).high, unbounded);
  EXPECT_EQ(move(0).low, -unbounded);
}

Scene moved_with_load(Scene scene, const CarriedGroup& group, double by) {
  for (const int cube : group.cubes)
    scene.cubes[cube].position.x() += by;
  return scene;
}

// Another way to the same end: where the scene stops to stand its weakest weight may not shift at all.
TEST(Margins, AtTheEndOfAMoveTheSceneIsOnAKnifeEdge) {
  constexpr double knife_edge = 1e-12;  // of the side
  Scene beams = on_floor({cube("left", {-1.3, 0.5}), cube("right", {1.1, 0.5}),
                          sized_cube("beam", {0.1, 1.5}, {3.4, 1.0}), cube("on", {0.3, 2.5}),
                          sized_cube("upper", {0.2, 3.2}, {1.9, 0.4}), cube("top", {0.6, 3.9})});
  for (const Scene& scene : {beams, harmonic(6, -1e-3), shipped_scene("fig1_stack_stands")}) {
    const StillScene from = still(scene);
    int ends = 0;
    for (const BodyMargin& body : margins(scene, {false, false, false, true, {}}).bodies) {
      EXPECT_LE(body.move.error, 1e-12) << body.cube;
      for (const double s : {body.move.low, body.move.high}) {
        if (!std::isfinite(s)) continue;
        const StillScene there = still(moved_with_load(scene, *carried_group(from, body.cube), s));
        if (there.verdict != Verdict::stands) continue;
        const std::optional<Weakest> weakest = find_weakest(there);
        ASSERT_TRUE(weakest);
        if (weakest->share > 1e-6) continue;  // it met a neighbour, or left its face
        EXPECT_NEAR(weakest->share, 0.0, knife_edge) << body.cube << " at " << s;
        ++ends;
      }
    }
    EXPECT_GT(ends, 5);
  }
}

// Posts below a beam: to their neighbour, and out from under it.
TEST(Margins, AMoveEndsWhereAFaceIsLeft) {
  const std::vector<BodyMargin> found =
      margins(shipped_scene("fig1_stack_stands"), {false, false, false, true, {0, 1}}).bodies;
  EXPECT_NEAR(found[0].move.low, -0.35, exact_length);
  EXPECT_NEAR(found[0].move.high, 0.2, exact_length);
  EXPECT_NEAR(found[1].move.low, -0.2, exact_length);
  EXPECT_NEAR(found[1].move.high, 0.8, exact_length);
}

// The centre of what is above a face stays above it.
TEST(Margins, MovesOfALeaningTowerHaveAClosedForm) {
  const Scene scene = on_floor(leaning_tower(4, 0.1));
  const std::vector<BodyMargin> found = margins(scene, {false, false, false, true, {}}).bodies;
  for (int i = 0; i < 4; ++i) {
    const double reach = 0.5;  // of a face from its middle
    // The cube with i below it carries 3 - i: the centre of those above each face below.
    double low = -unbounded;
    double high = unbounded;
    for (int below = 0; below < i; ++below) {
      const int carried = 4 - 1 - below;                  // cubes above the face
      const double centre = 0.1 * (below + 1 + 3) / 2.0;  // their centre, from the lowest's
      const double times = static_cast<double>(carried) / (4 - i);
      const bool own = below + 1 == i;
      const double left = own ? 0.1 * below - reach : 0.1 * (below + 1) - reach;
      const double right = 0.1 * below + reach;
      low = std::max(low, times * (left - centre));
      high = std::min(high, times * (right - centre));
    }
    if (i == 0) continue;
    EXPECT_NEAR(found[i].move.low, low, exact_length) << i;
    EXPECT_NEAR(found[i].move.high, high, exact_length) << i;
  }
}

struct Scaled {
  LoadRange tilt, shift, load;
};

Scaled all_of(const Scene& scene, int cube) {
  const Margins found = margins(scene, {false, true, true, false, {cube}});
  return {tilt_range(still(scene), Sliding::none), found.bodies.front().shift,
          found.bodies.front().load};
}

void expect_same(const LoadRange& a, const LoadRange& b, double times = 1.0) {
  ASSERT_EQ(is_empty(a), is_empty(b));
  for (const auto end : {&LoadRange::low, &LoadRange::high}) {
    if (!std::isfinite(a.*end)) {
      EXPECT_EQ(a.*end, b.*end);
      continue;
    }
    EXPECT_NEAR(a.*end * times, b.*end, exact * times * (1.0 + std::abs(a.*end)));
  }
}

class MarginScaling : public testing::TestWithParam<std::string> {};

TEST_P(MarginScaling, MirrorsMassesAndLengths) {
  const Scene scene = read_reference_case(GetParam()).scene;
  for (int cube = 0; cube < static_cast<int>(scene.cubes.size()); cube += 2) {
    const Scaled as_is = all_of(scene, cube);
    const Scaled mirror = all_of(mirrored(scene), cube);
    expect_same({-mirror.tilt.high, -mirror.tilt.low}, as_is.tilt);
    expect_same({-mirror.shift.high, -mirror.shift.low}, as_is.shift);
    expect_same(mirror.load, as_is.load);
    const Scaled heavy = all_of(heavier(scene, 2.0), cube);
    expect_same(as_is.tilt, heavy.tilt);
    expect_same(as_is.shift, heavy.shift);
    expect_same(as_is.load, heavy.load, 2.0);
    const Scaled large = all_of(longer(scene, 10.0), cube);
    expect_same(as_is.tilt, large.tilt);
    expect_same(as_is.shift, large.shift, 10.0);
    expect_same(as_is.load, large.load);
  }
}

INSTANTIATE_TEST_SUITE_P(Reference,
                         MarginScaling,
                         testing::Values("harmonic_N5_minus1em4",
                                         "harmonic_N5_plus1em2",
                                         "pz_triangle3_floor",
                                         "tower_unequal_masses",
                                         "hyper_beam_clipped",
                                         "random_stack_02",
                                         "random_stack_05",
                                         "massratio_tower10"),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace wuerfel::test
