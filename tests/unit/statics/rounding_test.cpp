// Answers that rounding, the order of cubes and where wishes of other forces end must not decide.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "core/check.h"
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

//     +-+
//  -----------     Light beams between heavy blocks: what rounding leaves of forces moves them most. Tangential forces are none, in
//   +-------+      cones however thin, also where one of many rubs.
//      +-+
class LightBeams : public testing::TestWithParam<std::array<double, 5>> {};

TEST_P(LightBeams, AreSureToStandWhateverTheFriction) {
  Scene scene = on_floor({cube("b0", {0.5, 0.5}), sized_cube("b1", {0.5, 1.25}, {3.0, 0.5}),
                          sized_cube("b2", {0.6, 1.75}, {3.0, 0.5}),
                          sized_cube("b3", {0.7, 2.15}, {2.0, 0.3}), cube("b4", {0.7, 2.8})});
  for (std::size_t i = 0; i < scene.cubes.size(); ++i)
    scene.cubes[i].mass = GetParam()[i];
  for (const double mu : {1e-12, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.3, 9.6, 1e5}) {
    for (const double of_one : {mu, 7e-12, 1e-9}) {
      set_friction(mu, scene);
      scene.cubes[2].material.friction = of_one;
      const Check found = check(scene, {});
      EXPECT_EQ(found.verdict, Verdict::stands) << mu << ' ' << of_one;
      EXPECT_TRUE(found.facts->equilibrium_exists);
      EXPECT_LE(found.kkt_residual, 1e-14) << mu << ' ' << of_one;
      EXPECT_TRUE(std::ranges::all_of(found.contacts, &ContactForce::unique))
          << mu << ' ' << of_one;
    }
  }
}
// The latter bear ten million times the weight of a grain.
INSTANTIATE_TEST_SUITE_P(Masses,
                         LightBeams,
                         testing::Values(std::array{0.2, 0.006, 1.0, 0.001, 1.0},
                                         std::array{1.6e-4, 0.013, 1.0, 3.8e-4, 4140.0}));

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

// Directions of gravity and of sides that differ in their last bit are the same.
TEST(Loads, OnSmoothCubesHaveNoLimitWhereverDownIs) {
  for (const double angle : {0.0, 0.3, 0.7, 1.1}) {
    const Vec2 right(cos(angle), sin(angle));
    const Vec2 up = perp(right);
    Scene scene = on_floor({cube("a", 0.5 * up, angle), cube("b", 0.5 * up + right, angle)});
    scene.planes.front().normal = up;
    scene.gravity = -g * up;
    set_friction(0.5, scene);
    for (SceneCube& c : scene.cubes)
      c.material.friction = 0.0;
    for (const BodyMargin& body : margins_and_moves(scene).bodies)
      EXPECT_EQ(body.load.high, unbounded) << angle;
  }
}

// What falls by itself on top is mended by no load below.
TEST(Loads, BelowWhatFallsMendNothing) {
  const double y = 0.9397167767689176;
  const double h = 1.8794335535378353;
  Scene scene = on_floor(
      {sized_cube("b0", {0.8428860763949801, y}, {1.0, h}),
       sized_cube("b1", {2.3607986343981775, y}, {2.035825116006395, h}),
       sized_cube("b2", {3.8787111924013753, y}, {1.0, h}),
       sized_cube("b3", {0.9520421972830266, 2.3260533904710314}, {2.0, 0.8932396738663926}),
       sized_cube("b4", {1.0, 3.272673227404228}, {2.0, 1.0}),
       sized_cube("b5", {2.0019841324458483, 4.1126158182138495},
                  {2.7869351112960126, 0.6798851816192428})});
  set_friction(0.6, scene);
  scene.cubes[1].mass = 0.41687973863229094;
  scene.cubes[5].mass = 0.11636288648562645;
  for (const Scene& seen : {scene, mirrored(scene)}) {
    for (const BodyMargin& body : margins_and_moves(seen).bodies)
      EXPECT_EQ(is_empty(body.load), body.cube != 5) << body.cube << ": " << body.load.low;
  }
}

// The end is where an exact cut says; what rounding left of the motion there went beyond it by 0.3 %.
TEST(ForceRanges, EndAtExactCuts) {
  const double y = 0.8398728502260628;
  Scene scene = on_floor(
      {sized_cube("b0", {0.24489360645922598, 0.1699364251130314},
                  {2.489787212918452, 0.3398728502260628}),
       cube("b2", {0.0, y}), sized_cube("b3", {1.0584720889224286, y}, {0.5316617258402003, 1.0}),
       cube("b4", {-0.18044562627526028, 1.0 + y}), cube("b5", {0.9251785848866991, 1.0 + y}),
       sized_cube("b6", {0.010014971212361723, 2.0 + y}, {1.5, 1.0})});
  scene.gravity = {3.1918698207462852, -9.276209734983846};
  const std::array friction{0.6, 0.6, 0.3, 0.22372388641497387, 0.3, 0.6};
  for (std::size_t k = 0; k < friction.size(); ++k)
    scene.cubes[k].material.friction = friction[k];
  scene.cubes[1].mass = 0.31908875464211783;
  scene.cubes[3].mass = 0.17988426867876245;
  scene.cubes[4].mass = 0.7164237080506081;
  for (const double side : {1.0, -1.0}) {
    const StillScene seen = still(side > 0.0 ? scene : mirrored(scene));
    const LoadRange range = range_at(seen, 0, 1, {-0.5 * side, 0.34});
    EXPECT_NEAR(range.low, 4.2744980464, rounded) << side;
    EXPECT_NEAR(range.high, 11.7315690972, rounded) << side;
  }
}

TEST(Tilts, OfWhatStandsHaveTheUpright) {
  Scene scene = on_floor({sized_cube("b0", {-0.40229123856989357, 0.25}, {1.0, 0.5}),
                          sized_cube("b1", {1.9025057647592498, 0.25}, {2.0, 0.5}),
                          sized_cube("b2", {4.141683615415088, 0.25}, {1.0, 0.5}),
                          sized_cube("b3", {1.0, 1.0}, {2.0, 1.0})});
  set_friction(0.6, scene);
  scene.cubes[1].material.friction = 0.0;
  scene.cubes[2].material.friction = 0.0;
  EXPECT_TRUE(tilt_range(still(scene), Sliding::given).contains(0.0));
}

// A blow leaves the velocities of those that it does not move at 1e-12 of its own: no slip that friction acts against.
TEST(Check, ForcesOnWhatABlowLeavesAtRestAreThoseOfRest) {
  const auto forces = [](double angle) {
    const Vec2 right(cos(angle), sin(angle));
    const auto at = [&](double x, double y) -> Vec2 { return x * right + y * perp(right); };
    Scene scene = on_floor({sized_cube("left", at(-0.75, 0.5), {1.5, 1.0}, angle),
                            sized_cube("right", at(0.75, 0.5), {1.5, 1.0}, angle),
                            sized_cube("struck", at(0.4, 1.25), {1.5, 0.5}, angle),
                            sized_cube("strikes", at(1.35, 1.25), {0.4, 0.5}, angle)});
    scene.planes.front().normal = perp(right);
    scene.planes.push_back({"wall", at(-1.5, 0.0), right, {}});
    scene.gravity = -g * perp(right);
    set_friction(0.3, scene);
    scene.cubes[2].material.friction = 0.0;
    scene.cubes[3].velocity = -0.9 * right;
    std::vector<double> found;
    for (const auto& contact : check(scene, {}).contacts)
      found.push_back(contact.force);
    std::ranges::sort(found);
    return found;
  };
  const std::vector<double> level = forces(0.0);
  const std::vector<double> turned = forces(0.7);
  ASSERT_EQ(level.size(), turned.size());
  for (std::size_t k = 0; k < level.size(); ++k)
    EXPECT_NEAR(level[k], turned[k], rounded) << k;
}

}  // namespace
}  // namespace wuerfel::test
