// Answers that rounding, the order of cubes and where wishes of other forces end must not decide.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "core/geometry/trig.h"
#include "core/statics/margins.h"
#include "core/statics/ranges.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

constexpr double rounded = 1e-9;  // N

Margins margins_and_moves(const Scene& scene) { return find_margins(still(scene), {}); }

/// Of the contact that two cubes of the only island have nearest to a place.
LoadRange range_at(const StillScene& still, int a, int b, const Vec2& place) {
  const ForceRanges ranges = find_ranges(still);
  const std::vector<Contact>& contacts = still.found.islands.front().island.contacts;
  LoadRange range = no_load;
  double nearest = unbounded;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact& c = contacts[k];
    const double away = (c.point - place).norm();
    if (std::minmax(c.on, c.from) != std::minmax(a, b) || away > nearest) continue;
    nearest = away;
    range = ranges.contacts[k];
  }
  return range;
}

// Bricks flush with one another, the last of which may be carried by its neighbour's corner.
TEST(ForceRanges, HaveAWidthWhereOnlyFewOtherForcesShowIt) {
  Scene scene = on_floor({sized_cube("b0", {1.0, 0.25}, {2.0, 0.5}),
                          sized_cube("b1", {3.0, 0.25}, {2.0, 0.5}),
                          sized_cube("b2", {4.5, 0.25}, {1.0, 0.5}), cube("b3", {0.5, 1.0}),
                          sized_cube("b4", {2.4848600551726343, 1.0}, {2.9697201103452686, 1.0})});
  set_friction(0.645135951308721, scene);
  for (const int smooth : {0, 1, 4})
    scene.cubes[smooth].material.friction = 0.0;
  for (const int rough : {2, 3})
    scene.cubes[rough].material.friction = 0.5;
  scene.cubes[0].mass = 1.2807645467134943;
  scene.cubes[4].mass = 0.13945872841953294;
  const LoadRange range = range_at(still(scene), 0, 4, {2.0, 0.5});
  EXPECT_NEAR(range.low, 0.0, rounded);
  EXPECT_NEAR(range.high, 1.0313253994822307, rounded);
}

// A cube moves below one that falls by itself, which is no concern of its.
TEST(Moves, DoNotDependOnTheOrderOfCubes) {
  std::vector<SceneCube> cubes{cube("low", {0.0, 0.5}),
                               sized_cube("falls", {-1.2, 1.5}, {0.6, 1.0})};
  for (const int low : {0, 1}) {
    Scene scene = on_floor(cubes);
    set_friction(0.1, scene);
    const LoadRange move = margins_and_moves(scene).bodies[low].move;
    EXPECT_EQ(move.low, -unbounded) << low;
    EXPECT_EQ(move.high, unbounded) << low;
    std::ranges::reverse(cubes);
  }
}

}  // namespace
}  // namespace wuerfel::test
