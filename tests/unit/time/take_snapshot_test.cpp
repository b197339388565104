// What a picture shows of an instant. (Joints, causes and ranges: looks_test.cpp, shown_statics_test.cpp.)
#include "core/time/take_snapshot.h"

#include <gtest/gtest.h>

#include "core/dynamics/forces_at.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

Snapshot snapshot_of(const Scene& scene, const SnapshotRequest& request) {
  const Mechanism m(scene);
  const InstantForces found = forces_at(m.system, {}, m.state, detail_of(request));
  return take_snapshot(scene, m.system, m.state, found, {}, request);
}

TEST(TakeSnapshot, AsksForNoMoreThanIsShown) {
  EXPECT_EQ(detail_of({}), Detail::contacts);
  EXPECT_EQ(detail_of({.accelerations = true}), Detail::accelerations);
  EXPECT_EQ(detail_of({.rod_forces = true}), Detail::forces);
  EXPECT_EQ(detail_of({.forces = true}), Detail::forces);
  EXPECT_EQ(detail_of({.joints = true}), Detail::forces);
  EXPECT_EQ(detail_of({.forces = true, .unique = true}), Detail::uniqueness);
}

TEST(TakeSnapshot, AContactShowsTheForceOnWhatItCarries) {
  //   +---+
  //   | b |     a carries b, the floor carries both
  //  +---+
  //  | a |
  // ~~~~~~~
  const Snapshot snapshot =
      snapshot_of(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.2, 1.5})}), {.forces = true});
  ASSERT_EQ(snapshot.boxes.size(), 2U);
  ASSERT_EQ(snapshot.planes.size(), 1U);
  std::vector<Vec2> on(2, Vec2::Zero());
  for (const SnapshotForce& f : snapshot.forces)
    on.at(f.body) += f.force;
  EXPECT_NEAR((on[0] - Vec2(0.0, 2.0 * g)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((on[1] - Vec2(0.0, g)).norm(), 0.0, 1e-12);
  EXPECT_LT(snapshot.force_residual, 1e-13);
}

TEST(TakeSnapshot, SidesSpanTheAreaOfEquationTwo) {
  // b is 0.25 m beside a: the nearest corner and a side of 1 m.
  Scene scene;
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.25, 0.1}), cube("far", {9.0, 0.0})};
  const Snapshot snapshot = snapshot_of(scene, {.sides = true});
  ASSERT_EQ(snapshot.sides.size(), 1U);
  EXPECT_NEAR(snapshot.sides[0].area, 0.25, 1e-14);
}

TEST(TakeSnapshot, ContactsShowTheVelocitiesOfTheirPoints) {
  Scene scene = on_floor({cube("a", {0.0, 0.5})});
  scene.cubes[0].velocity = {2.0, 0.0};
  const Snapshot snapshot = snapshot_of(scene, {.contacts = true});
  ASSERT_EQ(snapshot.contacts.size(), 2U);
  for (const SnapshotContact& c : snapshot.contacts) {
    EXPECT_EQ(c.v_k, Vec2(2.0, 0.0));
    EXPECT_EQ(c.v_i, Vec2::Zero());
    EXPECT_NEAR((c.p_j - c.p_i).norm(), 1.0, 1e-15);
    EXPECT_NEAR(c.p_k.y(), 0.0, 1e-15);
  }
}

TEST(TakeSnapshot, ACubeHasItsPointsAndRods) {
  const Snapshot snapshot =
      snapshot_of(on_floor({cube("a", {0.0, 0.5})}), {.rods = true, .points = true});
  double mass = 0.0;
  for (const SnapshotPoint& p : snapshot.points)
    mass += p.mass;
  EXPECT_NEAR(mass, 1.0, 1e-15);
  EXPECT_FALSE(snapshot.rods.empty());
  for (const SnapshotRod& rod : snapshot.rods) {
    EXPECT_GT((rod.b - rod.a).norm(), 0.5);
    EXPECT_EQ(rod.tension, 0.0) << "was not asked for";
  }
}

TEST(TakeSnapshot, WhatFallsAcceleratesWhereItIsAskedFor) {
  const Scene scene = on_floor({cube("a", {0.0, 5.0})});
  EXPECT_EQ(snapshot_of(scene, {}).boxes[0].acceleration, Vec2::Zero());
  EXPECT_EQ(snapshot_of(scene, {.accelerations = true}).boxes[0].acceleration, Vec2(0.0, -9.81));
}

}  // namespace
}  // namespace wuerfel::test
