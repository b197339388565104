// What a look says of causes, mechanisms and forces that are possible: shown_causes.cpp, shown_ranges.cpp.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/statics/ranges.h"
#include "core/time/simulation.h"
#include "tests/support/reference_case.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

const SnapshotRequest everything{.forces = true,
                                 .joints = true,
                                 .unique = true,
                                 .ranges = true,
                                 .causes = true,
                                 .mechanism = true};

TEST(ShownStatics, MarksThePartThatFailsAndHowItMoves) {
  const Scene scene = shipped_scene("fig1_stack");
  const Simulation simulation(scene, {});
  const Snapshot snapshot = simulation.snapshot(everything);
  ASSERT_EQ(snapshot.causes.size(), 1U);
  const SnapshotCause& cause = snapshot.causes.front();
  ASSERT_EQ(cause.part.size(), 3U);
  EXPECT_EQ(snapshot.boxes[cause.part.front()].name, "e");
  ASSERT_TRUE(cause.corner);
  EXPECT_NEAR((*cause.corner - cause.beside).norm(), cause.outside, 1e-12);
  EXPECT_NEAR(cause.outside, 0.35 / 3.0, 1e-12);
  // e, f and g turn as one to the right; the corner of d stays below them.
  ASSERT_EQ(snapshot.mechanism.size(), 3U);
  for (const SnapshotMotion& motion : snapshot.mechanism) {
    const Vec2 arm = snapshot.boxes[motion.box].center - *cause.corner;
    const Vec2 at_corner = motion.way - motion.turn * perp(arm);
    EXPECT_NEAR(at_corner.y(), 0.0, 1e-9);
    EXPECT_NEAR(motion.turn, snapshot.mechanism.front().turn, 1e-9);
    EXPECT_LT(motion.turn, 0.0);
  }
}

TEST(ShownStatics, WhatStandsHasNeitherCauseNorMechanism) {
  const Simulation simulation(shipped_scene("wall"), {});
  const Snapshot snapshot = simulation.snapshot(everything);
  EXPECT_TRUE(snapshot.causes.empty());
  EXPECT_TRUE(snapshot.mechanism.empty());
}

TEST(ShownStatics, ACubeInFlightIsSeenToFly) {
  Scene scene = on_floor({cube("a", {0.0, 5.0})});
  Simulation simulation(scene, {});
  const Snapshot snapshot = simulation.snapshot(everything);
  EXPECT_TRUE(snapshot.causes.empty());
  EXPECT_TRUE(snapshot.mechanism.empty());
}

TEST(ShownStatics, RangesAreThoseOfCheckAndHoldWhatIsShown) {
  const Scene scene = shipped_scene("fig1_stack_stands");
  const Simulation simulation(scene, {});
  const Snapshot snapshot = simulation.snapshot(everything);
  int ranges = 0;
  for (const SnapshotJoint& joint : snapshot.joints) {
    EXPECT_EQ(joint.range.has_value(), !joint.unique);
    if (!joint.range) continue;
    ++ranges;
    EXPECT_LE(joint.range->least, joint.force.norm());
    EXPECT_GE(joint.range->most, joint.force.norm());
  }
  EXPECT_EQ(ranges, 4);
  for (const SnapshotForce& force : snapshot.forces)
    EXPECT_TRUE(force.unique || force.range.has_value());
  const ForceRanges known = find_ranges(stopped_scene(scene, {}));
  for (const Interface& face : known.interfaces) {
    const auto joint = std::ranges::find_if(snapshot.joints, [&](const SnapshotJoint& j) {
      return std::minmax(j.body, j.other) == std::minmax(face.on, face.from);
    });
    if (joint == snapshot.joints.end() || !joint->range) continue;
    EXPECT_DOUBLE_EQ(joint->range->most, face.force_range.high);
  }
}

// A cube squeezed between two walls that rub: the walls may press as hard as they like.
TEST(ShownStatics, RangesWithoutAMostAreShown) {
  Scene scene;
  scene.fixed = {post("left", {-1.0, 1.5}, {1.0, 3.0}), post("right", {1.0, 1.5}, {1.0, 3.0})};
  scene.cubes = {cube("a", {0.0, 1.5})};
  scene.cubes[0].material.friction = 1.0;
  for (SceneFixed& wall : scene.fixed)
    wall.material.friction = 0.25;
  const Snapshot snapshot = Simulation(scene, {}).snapshot(everything);
  ASSERT_EQ(snapshot.joints.size(), 2U);
  for (const SnapshotJoint& joint : snapshot.joints) {
    ASSERT_TRUE(joint.range);
    EXPECT_NEAR(joint.range->least, 9.81, 1e-6);
    EXPECT_TRUE(std::isinf(joint.range->most));
  }
}

// While an island moves only the forces that are shown are known; that it rests again is seen.
TEST(ShownStatics, RangesAreToldWhereNothingMoves) {
  Scene scene = on_floor({cube("a", {-0.8, 0.5}), cube("b", {0.8, 0.5}),
                          sized_cube("beam", {0.0, 1.5}, {3.0, 1.0}), cube("c", {0.0, 2.0 + 1.5})});
  Simulation simulation(scene, {});
  const auto most = [&] {
    double sum = 0.0;
    for (const SnapshotForce& force : simulation.snapshot(everything).forces)
      if (force.range) sum += force.range->most;
    return sum;
  };
  const double at_start = most();
  EXPECT_GT(at_start, 0.0);
  simulation.advance_to(2.0);
  const double at_end = most();
  EXPECT_GT(at_end, 1.2 * at_start);
  EXPECT_EQ(most(), at_end);  // remembered
}

}  // namespace
}  // namespace wuerfel::test
