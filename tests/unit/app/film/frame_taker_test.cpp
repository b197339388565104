#include "app/film/frame_taker.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"

namespace wuerfel::test {
namespace {

/// A cube that falls half a metre onto a floor that takes all of its velocity, at sqrt(2 h / g).
Scene falling_cube() {
  return parse_scene(
      "version = 1\n[[plane]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [0, 1]\n"
      "[[cube]]\nname = \"a\"\nmass = 2\nposition = [0, 1.0]\n",
      "fall");
}

std::vector<Snapshot> frames(const Scene& scene, const LookBack& back, double end) {
  std::vector<Snapshot> shown;
  Simulation simulation(scene, {});
  const SnapshotRequest request{.joints = true, .unique = true};
  FrameTaker taker(request, request, back);
  const auto instants = with_looks(timetable(end, frame_times(end, {.fps = 50.0}), {}), back);
  for (const TimetableEntry& instant : instants) {
    simulation.advance_to(instant.t);
    if (auto snapshot = taker.take(simulation, simulation.moment(), instant))
      shown.push_back(std::move(*snapshot));
  }
  return shown;
}

TEST(Looks, LieBeforeTheirFrames) {
  const auto instants = with_looks(timetable(0.2, {0.0, 0.1, 0.2}, {}), {0.1});
  EXPECT_EQ(instants.size(), 3U + 2U) << "frames are looks, too";
  EXPECT_NEAR(instants[1].t, 0.05, 1e-15);
  EXPECT_TRUE(instants[1].look);
  EXPECT_FALSE(instants[1].frame);
  EXPECT_EQ(with_looks(timetable(0.2, {0.0, 0.1, 0.2}, {}), {}).size(), 3U);
}

// At the end of a step forces may hang on the last bit of the time.
TEST(Looks, OfOnePictureAreToTheBitThoseOfTheFilm) {
  for (const FrameRate& rate : {FrameRate{60.0, 1.0}, {24.0, 1.0}, {60.0, 0.1}, {29.97, 0.7}}) {
    const LookBack back{rate.speed / rate.fps};
    const auto of_film = with_looks(timetable(1.0, frame_times(1.0, rate), {}), back);
    const auto is_looked_at = [&](double t) {
      const auto there = std::ranges::lower_bound(of_film, t, {}, &TimetableEntry::t);
      return there != of_film.end() && there->t == t && (there->look || there->frame);
    };
    for (const double t : frame_times(1.0, rate)) {
      for (const TimetableEntry& look : with_looks({{.t = t, .frame = true}}, back))
        EXPECT_TRUE(is_looked_at(look.t)) << rate.fps << ' ' << t << ' ' << look.t;
    }
  }
}

TEST(Looks, AtWholeRatesAreTheFramesBefore) {
  const FrameRate rate;
  const auto looks = with_looks(timetable(2.0, frame_times(2.0, rate), {}), {1.0 / rate.fps});
  EXPECT_EQ(looks.size(), 121U + 120U);
}

TEST(Looks, AreNotTakenBeforeFramesOfPosesAlone) {
  auto instants = timetable(0.2, {0.0, 0.1, 0.2}, {});
  instants[1].bare = true;
  const auto looks = with_looks(instants, {0.1});
  EXPECT_EQ(looks.size(), 3U + 1U);
  EXPECT_TRUE(looks[1].look) << "the frame after it looks back";
}

TEST(MarkScales, TakesAllFramesOfShortFilmsAndFortyOfLongOnes) {
  const auto marked = [](long frames) {
    auto instants =
        timetable(1.0, frame_times(1.0, {.fps = static_cast<double>(frames - 1)}), {0.1234});
    mark_scales(instants);
    EXPECT_TRUE(instants.front().scales);
    return std::ranges::count(instants, true, &TimetableEntry::scales);
  };
  EXPECT_EQ(marked(31), 31);
  EXPECT_EQ(marked(79), 79);
  EXPECT_EQ(marked(81), 41);
  EXPECT_EQ(marked(2001), 41);
}

TEST(FrameTaker, ForcesOfRestAreWhatTheyAreAtAnyInstant) {
  Scene scene = falling_cube();
  scene.cubes[0].position.y() = 0.5;
  for (const Snapshot& snapshot : frames(scene, {0.02, 0.15}, 0.2)) {
    ASSERT_EQ(snapshot.joints.size(), 1U);
    EXPECT_NEAR(snapshot.joints[0].force.y(), 2.0 * 9.81, 1e-10);
    EXPECT_NEAR(snapshot.joints[0].point.x(), 0.0, 1e-12);
  }
}

TEST(FrameTaker, WhatDoesNotMoveIsLookedAtOnce) {
  Scene scene = falling_cube();
  scene.cubes[0].position.y() = 0.5;
  Simulation simulation(scene, {});
  FrameTaker taker({.joints = true}, {.joints = true}, {0.02, 0.15});
  const auto instants = with_looks(timetable(1.0, frame_times(1.0, {.fps = 50.0}), {}), {0.02});
  std::vector<SnapshotJoint> first;
  for (const TimetableEntry& instant : instants) {
    simulation.advance_to(instant.t);
    const auto shown = taker.take(simulation, simulation.moment(), instant);
    if (!shown) continue;
    if (first.empty()) first = shown->joints;
    EXPECT_EQ(shown->joints, first);
    EXPECT_EQ(shown->time, instant.t);
  }
  EXPECT_EQ(simulation.look_cost().force_choices, 1);
  EXPECT_EQ(simulation.look_cost().unchanged, 0);
}

TEST(FrameTaker, LoadsGrowWithinAMoment) {
  const LookBack back{0.02, 0.15, 0.15};
  const auto shown = frames(falling_cube(), back, 0.8);
  double before = 0.0;
  for (const Snapshot& snapshot : shown) {
    ASSERT_EQ(snapshot.loads.size(), 1U);
    EXPECT_LT(std::abs(snapshot.loads[0] - before), 0.2 * 2.0 * 9.81) << snapshot.time;
    before = snapshot.loads[0];
  }
  EXPECT_NEAR(before, 2.0 * 9.81, 1e-10);
  EXPECT_LT(shown[17].loads[0], 0.3 * 2.0 * 9.81) << "just after the impact";
}

TEST(FrameTaker, LoadsOfOnePictureAreThoseOfTheFilm) {
  const LookBack back{0.02, 0.15, 0.15};
  const Snapshot of_film = frames(falling_cube(), back, 0.4)[19];
  Simulation simulation(falling_cube(), {});
  FrameTaker taker({.joints = true}, {.joints = true}, back);
  std::vector<TimetableEntry> instants{{.t = of_film.time, .frame = true, .sample = true}};
  std::optional<Snapshot> alone;
  for (const TimetableEntry& instant : with_looks(instants, back)) {
    simulation.advance_to(instant.t);
    alone = taker.take(simulation, simulation.moment(), instant);
  }
  ASSERT_TRUE(alone);
  EXPECT_GT(alone->loads[0], 0.0);
  EXPECT_NEAR(alone->loads[0], of_film.loads[0], 1e-9);
}

TEST(FrameTaker, AnImpactBetweenTwoFramesIsSeen) {
  // It falls 0.5 m in 0.3193 s, to v = 3.132 m/s: an impulse of 6.264 N s in the frame up to 0.32 s.
  const auto shown = frames(falling_cube(), {0.02, 0.15}, 0.6);
  const double impulse = 2.0 * std::sqrt(2.0 * 9.81 * 0.5);
  EXPECT_TRUE(shown[15].joints.empty());
  ASSERT_EQ(shown[16].joints.size(), 1U);
  EXPECT_NEAR(shown[16].joints[0].force.y(), impulse / 0.02, 0.05 * impulse / 0.02);
  EXPECT_NEAR(shown[17].joints[0].force.y(), 2.0 * 9.81, 1e-6) << "then it rests";
}

TEST(FrameTaker, ImpactsLeaveAMarkThatFades) {
  const auto shown = frames(falling_cube(), {0.02, 0.15}, 0.6);
  EXPECT_TRUE(shown[15].impacts.empty());
  ASSERT_FALSE(shown[16].impacts.empty());
  EXPECT_NEAR(shown[16].impacts[0].age, (0.32 - std::sqrt(2.0 * 0.5 / 9.81)) / 0.15, 1e-6);
  EXPECT_GT(shown[20].impacts[0].age, shown[16].impacts[0].age);
  EXPECT_TRUE(shown[25].impacts.empty());
}

}  // namespace
}  // namespace wuerfel::test
