// Ranges of forces: as many as have a width as there are forces that are not the only ones possible.
#include "core/statics/ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "tests/support/reference_case.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

constexpr double exact_share = 1e-9;  // of the weight

class Ranges : public testing::TestWithParam<std::string> {};

TEST_P(Ranges, HaveAWidthWhereAForceIsNotTheOnlyOne) {
  const ReferenceCase reference = read_reference_case(GetParam());
  const StillScene still = stopped_scene(reference.scene, {});
  const ForceRanges ranges = find_ranges(still, {{}, false});
  const double weight = reference.weight();
  std::size_t k = 0;
  for (const IslandForces& of : still.found.islands) {
    for (std::size_t i = 0; i < of.island.contacts.size(); ++i, ++k) {
      const LoadRange& range = ranges.contacts[k];
      ASSERT_FALSE(is_empty(range)) << k;
      EXPECT_EQ(range.high - range.low <= exact_share * weight, of.forces.unique[i] != 0) << k;
      EXPECT_GE(of.forces.force[i], range.low - exact_share * weight) << k;
      EXPECT_LE(of.forces.force[i], range.high + exact_share * weight) << k;
    }
  }
  EXPECT_EQ(k, ranges.contacts.size());
}

INSTANTIATE_TEST_SUITE_P(
    Reference,
    Ranges,
    testing::ValuesIn(reference_case_names("qp_geometry",
                                           {"hyper_", "pz_n", "pz_triangle", "pz_diamond",
                                            "harmonic_N5_minus1em2", "harmonic_N5_minus1em4",
                                            "harmonic_N5_plus1em2", "tower_5"})),
    [](const auto& test) { return test_name(test.param); });

TEST(ForceRanges, HaveTheDegreesOfTheReferenceCases) {
  const std::map<std::string, int> degrees{{"pz_n3_overhang1_exact", 0},  {"pz_n4_stands_1em2", 2},
                                           {"pz_n5_stands_1em2", 2},      {"hyper_beam_3tips", 1},
                                           {"hyper_beam_5tips_rider", 3}, {"hyper_wall_3x3", 6},
                                           {"hyper_wall_5x4", 20},        {"hyper_vgroove", 1}};
  for (const auto& [name, degree] : degrees) {
    const StillScene still = stopped_scene(read_reference_case(name).scene, {});
    EXPECT_EQ(find_ranges(still).degree, degree) << name;
  }
}

TEST(ForceRanges, OfABeamOnThreeTips) {
  const ReferenceCase beam = read_reference_case("hyper_beam_3tips");
  const ForceRanges ranges = find_ranges(stopped_scene(beam.scene, {}));
  const double weight = beam.weight();
  ASSERT_EQ(ranges.interfaces.size(), 3U);
  for (const Interface& tip : ranges.interfaces) {
    const bool middle = std::abs(tip.middle.x()) < 1e-9;
    EXPECT_NEAR(tip.force_range.low, 0.0, exact_share * weight);
    EXPECT_NEAR(tip.force_range.high, middle ? weight : 0.5 * weight, exact_share * weight);
    EXPECT_FALSE(tip.eccentricity);  // a corner has no length
  }
}

TEST(ForceRanges, OfAFaceHaveAResultantAndACenter) {
  const ForceRanges ranges = find_ranges(stopped_scene(on_floor(leaning_tower(3, 0.25)), {}));
  ASSERT_EQ(ranges.interfaces.size(), 3U);
  EXPECT_EQ(ranges.degree, 0);
  for (const Interface& face : ranges.interfaces) {
    ASSERT_TRUE(face.center && face.eccentricity);
    const double height = face.center->y();
    const double above = 3.0 - height;
    EXPECT_NEAR(face.force, above * g, exact_share * g);
    // The centre of what is above: cubes `height` .. 2 at 0.25 times their number.
    EXPECT_NEAR(face.center->x(), 0.25 * 0.5 * (height + 2.0), 1e-12);
    EXPECT_NEAR(face.eccentricity.value(),
                std::abs(face.center->x() - face.middle.x()) / (0.5 * face.length), 1e-12);
    EXPECT_EQ(face.center_range.low, face.center_range.high);
  }
}

TEST(ForceRanges, OfABlockOnAWideTableWithFriction) {
  const Scene scene = with_friction(on_floor({cube("a", {0.0, 0.5})}), 0.5);
  const ForceRanges ranges = find_ranges(stopped_scene(scene, {}));
  ASSERT_EQ(ranges.interfaces.size(), 1U);
  const Interface& face = ranges.interfaces.front();
  // Flush sides have one tangential force, whatever its corners take of it.
  EXPECT_NEAR(face.force_range.low, g, exact_share * g);
  EXPECT_NEAR(face.force_range.high, g, exact_share * g);
  EXPECT_NEAR(face.center_range.low, 0.0, exact_share);
  EXPECT_NEAR(face.center_range.high, 0.0, exact_share);
  EXPECT_EQ(ranges.degree, 0);
  const StillScene still = stopped_scene(scene, {});
  for (const char unique : still.found.islands.front().forces.unique)
    EXPECT_NE(unique, 0);
}

/// A bar of 3 m by 0.2 m that leans against a rough wall, `angle` above the floor.
Scene ladder(double angle, double mu) {
  const Vec2 centre(1.5 * std::cos(angle) + 0.1 * std::sin(angle),
                    1.5 * std::sin(angle) + 0.1 * std::cos(angle));
  Scene scene = on_floor({sized_cube("bar", centre, {3.0, 0.2}, -angle)});
  scene.planes.push_back({"wall", Vec2::Zero(), Vec2::UnitX(), {}});
  return with_friction(scene, mu);
}

// T at the wall is free between its edges and what the floor holds: N a + T b = W c about the foot.
TEST(ForceRanges, OfALadderOnARoughWallAreThoseByHand) {
  int compared = 0;
  for (const double angle : {0.7, 0.9, 1.0471975511965976, 1.2}) {
    for (const double mu : {0.45, 0.5, 0.8}) {
      const StillScene still = stopped_scene(ladder(angle, mu), {});
      const double a = 3.0 * std::sin(angle);
      const double b = 3.0 * std::cos(angle);
      const double c = 1.5 * std::cos(angle) - 0.1 * std::sin(angle);
      const double low = g * c / (a + mu * b);
      // The floor holds N <= mu (W - T).
      const double of_floor = mu * (g - g * c / b) / (1.0 - mu * a / b);
      const bool floor_holds_all = 1.0 - mu * a / b <= 0.0;
      const double of_edge = a > mu * b ? g * c / (a - mu * b) : 1e9;
      const double high = floor_holds_all ? of_edge : std::min(of_edge, of_floor);
      if (low > high - 1e-3) continue;  // it slips
      ++compared;
      const ForceRanges ranges = find_ranges(still, {});
      ASSERT_EQ(ranges.interfaces.size(), 2U);
      const Interface& wall = ranges.interfaces[ranges.interfaces[0].normal.x() > 0.5 ? 0 : 1];
      EXPECT_NEAR(wall.force_range.low, low, 1e-8 * g) << angle << ' ' << mu;
      EXPECT_NEAR(wall.force_range.high, high, 1e-8 * g) << angle << ' ' << mu;
      EXPECT_EQ(ranges.degree, 1);
      for (const char unique : still.found.islands.front().forces.unique)
        EXPECT_EQ(unique, 0) << angle << ' ' << mu;
    }
  }
  EXPECT_GE(compared, 6);
}

// In a hyperstatic wall the center of pressure may run over a part of a face.
TEST(ForceRanges, TheCenterOfPressureHasARange) {
  const ForceRanges ranges =
      find_ranges(stopped_scene(read_reference_case("hyper_wall_3x3").scene, {}));
  int wide = 0;
  for (const Interface& face : ranges.interfaces) {
    if (is_empty(face.center_range)) {  // cubes beside one another
      EXPECT_LE(face.force_range.high, 1e-9);
      continue;
    }
    EXPECT_GE(face.center_range.low, -0.5 * face.length - 1e-9);
    EXPECT_LE(face.center_range.high, 0.5 * face.length + 1e-9);
    wide += face.center_range.high - face.center_range.low > 1e-6 ? 1 : 0;
  }
  EXPECT_GT(wide, 0);
}

TEST(ForceRanges, HaveTheSameBitsForAnyNumberOfThreads) {
  const Scene scene = parse_scene(
      "plane = [{name = \"floor\"}]\nwall = [{on = \"floor\", rows = 5, columns = 5, size = [1, "
      "0.6]}]\n",
      "s.toml");
  const StillScene still = stopped_scene(scene, {});
  double share = 0.0;
  RangeRequest request;
  request.progress = [&](double done) {
    EXPECT_GE(done, share);
    share = done;
  };
  const ForceRanges alone = find_ranges(still, request);
  EXPECT_GT(share, 0.5);
  EXPECT_LE(share, 1.0);
  const ForceRanges together = find_ranges(still, {.threads = 3});
  EXPECT_EQ(together.degree, alone.degree);
  ASSERT_GT(alone.contacts.size(), 64U);
  ASSERT_EQ(together.contacts.size(), alone.contacts.size());
  for (std::size_t k = 0; k < alone.contacts.size(); ++k) {
    EXPECT_EQ(together.contacts[k].low, alone.contacts[k].low);
    EXPECT_EQ(together.contacts[k].high, alone.contacts[k].high);
  }
  ASSERT_EQ(together.interfaces.size(), alone.interfaces.size());
  for (std::size_t k = 0; k < alone.interfaces.size(); ++k) {
    EXPECT_EQ(together.interfaces[k].force_range.high, alone.interfaces[k].force_range.high);
    EXPECT_EQ(together.interfaces[k].center_range.low, alone.interfaces[k].center_range.low);
  }
}

TEST(ForceRanges, NeedNoProgramWhereAForceIsTheOnlyOne) {
  for (const std::string name :
       {"hyper_beam_5tips_rider", "pz_n4_stands_1em2", "pz_n4_falls_1em2"}) {
    const StillScene still = stopped_scene(read_reference_case(name).scene, {});
    const ForceRanges skipped = find_ranges(still, {{}, true});
    const ForceRanges asked = find_ranges(still, {{}, false});
    for (std::size_t k = 0; k < asked.contacts.size(); ++k) {
      EXPECT_NEAR(skipped.contacts[k].low, asked.contacts[k].low, 1e-8) << name << k;
      EXPECT_NEAR(skipped.contacts[k].high, asked.contacts[k].high, 1e-8) << name << k;
    }
  }
}

// Near an end a cut is rounding divided by rounding: here one of 0.332 W would have come out, which is more than the
// force that is shown. The ends are those of the same scene elsewhere.
TEST(ForceRanges, HoldTheForceThatIsShown) {
  const auto found_at = [](const std::array<double, 2>& origin, const std::array<double, 4>& x) {
    const Scene scene = parse_scene(
        fmt::format(
            R"({{"version": 1, "material": {{"friction": 0.6}},
                "plane": [{{"name": "floor", "point": [{0}, {1}]}}],
                "cube": [{{"name": "b0", "size": [1.4037996242101214, 0.5], "position": [{2}, {6}],
                           "mass": 0.1514108794937974, "friction": 0}},
                         {{"name": "b1", "size": [1.2206289112237763, 0.5], "position": [{3}, {6}],
                           "mass": 0.13012843578778538}},
                         {{"name": "b2", "size": [2.292112549381156, 1], "position": [{4}, {7}],
                           "mass": 0.1874549935560968}},
                         {{"name": "b3", "position": [{5}, {7}], "friction": 0}}],
                "rod": [{{"from": "b2.ne", "to": "b1.w"}}]}})",
            origin[0], origin[1], x[0], x[1], x[2], x[3], origin[1] + 0.25, origin[1] + 1.0),
        "moved");
    const StillScene still = stopped_scene(scene, {});
    std::vector<LoadRange> found = find_ranges(still).contacts;
    EXPECT_EQ(still.found.islands.size(), 1U);
    const std::vector<double>& shown = still.found.islands.front().forces.force;
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_LE(found[k].low, shown[k]);
      EXPECT_GE(found[k].high, shown[k]);
    }
    std::ranges::sort(found, {}, [](const LoadRange& r) { return std::pair(r.low, r.high); });
    return found;
  };
  const auto here = found_at(
      {0.0, 0.0}, {1.2018998121050607, 3.3862810170801608, 1.646056274690578, 3.292112549381155});
  const auto there = found_at(
      {7.0, -3.0}, {8.201899812105061, 10.38628101708016, 8.646056274690578, 10.292112549381155});
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t k = 0; k < here.size(); ++k)
    EXPECT_NEAR(there[k].low, here[k].low, 1e-8 * g) << k;
}

TEST(ForceRanges, OfWhatFallsFreelyInTouchAreNothing) {
  const double angle = 0.3;
  const Vec2 along(std::cos(angle), std::sin(angle));
  Scene scene;
  for (int k = 0; k < 6; ++k) {
    scene.cubes.push_back(cube("c" + std::to_string(k), (k % 2) * along + (k / 2) * perp(along)));
    scene.cubes.back().angle = angle;
  }
  scene.gravity = -g * perp(along);
  const StillScene still = stopped_scene(with_friction(scene, 0.6), {});
  const ForceRanges ranges = find_ranges(still);
  ASSERT_FALSE(ranges.contacts.empty());
  for (const LoadRange& range : ranges.contacts) {
    EXPECT_NEAR(range.low, 0.0, exact_share * g);
    EXPECT_NEAR(range.high, 0.0, exact_share * g);
  }
}

TEST(LoadRange, HoldsWhatIsKnownToBeInside) {
  EXPECT_EQ(around(2.0, {1.0, 3.0, 0.0}, 1e-9).low, 1.0);
  const LoadRange moved = around(1.0, {1.0 + 1e-10, 3.0, 0.0}, 1e-9);
  EXPECT_EQ(moved.low, 1.0);
  EXPECT_NEAR(moved.error, 1e-10, 1e-15);
  EXPECT_TRUE(is_empty(around(1.0, {1.1, 3.0, 0.0}, 1e-9))) << "is not known";
  EXPECT_TRUE(is_empty(around(1.0, no_load, 1e-9)));
  const LoadRange crossed = around(1.0, {1.0 + 1e-10, 1.0 - 1e-10, 0.0}, 1e-9);
  EXPECT_EQ(crossed.low, 1.0);
  EXPECT_EQ(crossed.high, 1.0);
}

}  // namespace
}  // namespace wuerfel::test
