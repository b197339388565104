// The motion of a group by itself: its states, its rest, and who moves it.
#include "core/time/track.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "tests/support/deepest_overlap.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

TEST(Track, KnowsItsStatesUntilTheyAreForgotten) {
  const Mechanism m(on_floor({cube("a", {0.0, 3.0})}));
  Track track(m.system, {}, policy_of({}));
  track.start(m.state, 0.0, 1e-9, {0}, {});
  while (track.clock() < 0.5)
    track.advance(0.5);
  EXPECT_NEAR(track.at(0.3)[0].position.y(), 3.0 - 0.5 * 9.81 * 0.09, 1e-13);
  EXPECT_EQ(track.at(track.clock())[0].position, track.state()[0].position);
  std::vector<BoundingBox> swept(1, {m.state[0].position, m.state[0].position});
  track.sweep(0.0, swept);
  EXPECT_LE(swept[0].low.y(), track.state()[0].position.y() - 0.7);
  EXPECT_GE(swept[0].high.y(), 3.7);
  track.forget_before(0.4);
  EXPECT_NEAR(track.at(0.45)[0].position.y(), 3.0 - 0.5 * 9.81 * 0.2025, 1e-13);
}

TEST(Track, RestEndsTheClock) {
  const Mechanism m(on_floor({cube("a", {0.0, 0.5})}));
  Track track(m.system, {}, policy_of({}));
  track.start(m.state, 0.0, 1e-9, {0}, {});
  EXPECT_TRUE(track.at_rest());
  track.advance(1.0);
  EXPECT_EQ(track.clock(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(track.at(7.0)[0].position, m.state[0].position);
}

TEST(Track, StepsAllTheTimeWhereThatIsTheChoice) {
  const Mechanism m(on_floor({cube("a", {0.0, 3.0})}));
  const MotionSettings settings{.integrator = Integrator::rattle, .step = 0.02};
  Track track(m.system, settings, policy_of(settings));
  track.start(m.state, 0.0, 1e-9, {0}, {});
  EXPECT_GT(track.stepping().until, 1e300);
  track.advance(1.0);
  EXPECT_LE(track.clock(), 0.02 + 1e-15);
  EXPECT_TRUE(track.loaded_at(0.0).empty());
}

/// 25 cubes in a row that fall on the floor, half a millisecond after one another.
///   +--+      +--+
///   +--+ +--+ +--+ ..
///  ~~~~~~~~~~~~~~~~~~
Scene hail() {
  std::vector<SceneCube> cubes;
  for (int k = 0; k < 25; ++k) {
    const double t = 0.1 + 0.0005 * k;
    cubes.push_back(cube("h" + std::to_string(k), {2.0 * k, 0.5 + 0.5 * 9.81 * t * t}));
  }
  return on_floor(cubes);
}

TEST(Track, IsSteppedWhereEventsCrowdUntilItIsFoundAtRest) {
  const Mechanism m(hail());
  Track track(m.system, {}, policy_of({}));
  track.start(m.state, 0.0, 1e-9, {}, {});
  // 300 / 25 events in a frame of L / V / 20 = 16 ms are what it affords.
  while (track.book().cost.hand_overs == 0 && track.clock() < 0.2)
    track.advance(1.0);
  EXPECT_EQ(track.book().cost.hand_overs, 1);
  EXPECT_EQ(track.book().events.size(), 13U * 3U) << "two impacts and a rest each";
  EXPECT_NEAR(track.clock(), 0.106, 1e-9);
  EXPECT_GT(track.stepping().until, track.clock());
  while (track.clock() < 1.0)
    track.advance(1.0);
  EXPECT_TRUE(track.at_rest());
  EXPECT_LT(track.stepping().until, 0.0);
  for (const BodyState& s : track.state())
    EXPECT_NEAR(s.position.y(), 0.5, 1e-9);
}

TEST(Track, WhatTheUserSaysIsToBeEventsIsNotStepped) {
  const Mechanism m(hail());
  MotionPolicy policy;
  policy.only_events = true;
  Track track(m.system, {}, policy);
  track.start(m.state, 0.0, 1e-9, {}, {});
  while (track.clock() < 1.0)
    track.advance(1.0);
  EXPECT_EQ(track.book().cost.hand_overs, 0);
  EXPECT_TRUE(track.at_rest());
}

TEST(Track, SteppingGoesOnWhereItIsNotOver) {
  const Mechanism m(on_floor({cube("a", {0.0, 3.0})}));
  Track track(m.system, {}, policy_of({}));
  track.start(m.state, 1.0, 0.0, {0}, {1.25, 4});
  EXPECT_EQ(track.stepping().until, 1.25);
  EXPECT_EQ(track.stepping().patience, 4);
  track.start(m.state, 1.0, 0.0, {0}, {0.75, 4});
  EXPECT_LT(track.stepping().until, 0.0) << "that was over";
}

TEST(Track, LargeGroupsThatRubAreSteppedOnlyUnlessTheyRest) {
  std::vector<SceneCube> cubes = tower(13);
  for (SceneCube& c : cubes)
    c.material.friction = 0.5;
  Scene scene = on_floor(cubes);
  scene.planes[0].material.friction = 0.5;
  const Mechanism standing(scene);
  Track track(standing.system, {}, policy_of({}));
  track.start(standing.state, 0.0, 1e-9, {}, {});
  EXPECT_TRUE(track.at_rest());
  for (SceneCube& c : scene.cubes)
    c.velocity = {1.0, 0.0};
  const Mechanism sliding(scene);
  track = Track(sliding.system, {}, policy_of({}));
  track.start(sliding.state, 0.0, 1e-9, {}, {});
  EXPECT_FALSE(track.at_rest());
  EXPECT_GT(track.stepping().until, 0.0);
}

TEST(Track, RestTakesWhatHardlyMoves) {
  // Slower than 1e-4 V; what that was is booked as lost.
  std::vector<SceneCube> cubes = tower(13);
  for (SceneCube& c : cubes) {
    c.material.friction = 0.5;
    c.velocity = {1e-4, 0.0};
  }
  Scene scene = on_floor(cubes);
  scene.planes[0].material.friction = 0.5;
  const Mechanism m(scene);
  Track track(m.system, {}, policy_of({}));
  track.start(m.state, 0.0, 1e-9, {}, {});
  EXPECT_TRUE(track.at_rest());
  double lost = 0.0;
  for (const Loss& loss : track.book().losses)
    lost += loss.energy;
  // The difference of energies of some 830 J.
  EXPECT_NEAR(lost, 13.0 * 0.5e-8, 1e-12);
}

TEST(Track, OfTwoSteppingsTheLongerOneCounts) {
  const Stepping a{1.0, 8};
  const Stepping b{2.0, 4};
  for (const Stepping& both : {later(a, b), later(b, a)}) {
    EXPECT_EQ(both.until, 2.0);
    EXPECT_EQ(both.patience, 8);
  }
}

TEST(Track, GoesOnSteppingWhereClosingContactsWouldPushCubesIntoOthers) {
  // Two rows of cubes without room to speak of, the rows and their ends joined by rods in one line: what closes a gap of
  // 1e-9 between two of them turns others by its root.
  Scene scene = parse_scene(R"(
material = { friction = 0.7, restitution = 1 }
cube = [{ name = "a", position = [0, 1], friction = 0 }, { name = "b", position = [1.000000001, 1] },
        { name = "c", position = [2.000000002, 1] }, { name = "d", position = [3.0000000030000002, 1] },
        { name = "e", position = [0, 2.000000001] },
        { name = "f", position = [1, 2], velocity = [0.3, 1.4], friction = 0.004260480689834373 },
        { name = "g", position = [2.000000002, 2.000000001] },
        { name = "h", position = [3.0000000030000002, 2.000000001] }]
rod = [{ from = "d.se", to = "e.se" }, { from = "h.w", to = "d.sw" }, { from = "a.w", to = "b" }, { from = "b", to = "c.sw" }]
)",
                            "rows.toml");
  const Mechanism m(scene);
  Track track(m.system, {}, policy_of({}));
  track.start(m.state, 0.0, 1e-9, {}, {});
  while (track.clock() < 0.06) {
    track.advance(std::numeric_limits<double>::infinity());
    ASSERT_LE(deepest_overlap(m.system, track.state()), 2e-10) << "at " << track.clock();
  }
}

}  // namespace
}  // namespace wuerfel::test
