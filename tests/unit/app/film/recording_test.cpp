#include "app/film/recording.h"

#include <gtest/gtest.h>

#include "tests/support/image_scenes.h"

namespace wuerfel {
namespace {

/// The literal pyramid and the triangles of Eq. (2), moved by `step` centimetres.
Snapshot moved(int step) {
  Snapshot snapshot = testing::pyramid_snapshot();
  snapshot.sides = testing::two_cubes_snapshot().sides;
  snapshot.time = 0.1 * step;
  snapshot.energy = 100.0 - step;
  snapshot.boxes[6].center.y() -= 0.01 * step;
  snapshot.boxes[6].angle = 0.3 * step;
  snapshot.forces.resize(static_cast<std::size_t>(step % 4));
  return snapshot;
}

void expect_equal(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.energy, b.energy);
  EXPECT_EQ(a.title, b.title);
  ASSERT_EQ(a.boxes.size(), b.boxes.size());
  for (std::size_t i = 0; i < a.boxes.size(); ++i) {
    EXPECT_EQ(a.boxes[i].name, b.boxes[i].name);
    EXPECT_EQ(a.boxes[i].center, b.boxes[i].center);
    EXPECT_EQ(a.boxes[i].angle, b.boxes[i].angle);
    EXPECT_EQ(a.boxes[i].velocity, b.boxes[i].velocity);
    EXPECT_EQ(a.boxes[i].spin, b.boxes[i].spin);
  }
  ASSERT_EQ(a.forces.size(), b.forces.size());
  for (std::size_t i = 0; i < a.forces.size(); ++i) {
    EXPECT_EQ(a.forces[i].point, b.forces[i].point);
    EXPECT_EQ(a.forces[i].force, b.forces[i].force);
    EXPECT_EQ(a.forces[i].kind, b.forces[i].kind);
    EXPECT_EQ(a.forces[i].body, b.forces[i].body);
  }
  ASSERT_EQ(a.rods.size(), b.rods.size());
  EXPECT_EQ(a.rods.back().b, b.rods.back().b);
  EXPECT_EQ(a.rods.back().tension, b.rods.back().tension);
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(a.points.back().position, b.points.back().position);
  EXPECT_EQ(a.points.back().mass, b.points.back().mass);
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  EXPECT_EQ(a.contacts.back().p_k, b.contacts.back().p_k);
  EXPECT_EQ(a.contacts.back().normal, b.contacts.back().normal);
  ASSERT_EQ(a.sides.size(), b.sides.size());
  EXPECT_EQ(a.sides.back().p_j, b.sides.back().p_j);
  EXPECT_EQ(a.sides.back().area, b.sides.back().area);
}

TEST(Recording, GivesBackEverySnapshotAsOftenAsAsked) {
  Recording recording;
  for (int i = 0; i < 20; ++i)
    recording.add(moved(i));
  EXPECT_EQ(recording.size(), 20U);
  for (int round = 0; round < 2; ++round) {
    Recording::Replay replay(recording);
    Snapshot snapshot;
    for (int i = 0; i < 20; ++i) {
      ASSERT_TRUE(replay.next(snapshot));
      expect_equal(snapshot, moved(i));
    }
    EXPECT_FALSE(replay.next(snapshot));
  }
}

TEST(Revisions, AreEqualWhereOnlyTimeAndEnergyHaveChanged) {
  Recording recording;
  for (const int step : {0, 0, 1, 1, 0}) {
    Snapshot snapshot = moved(step);
    snapshot.time = static_cast<double>(recording.size());
    snapshot.energy = -snapshot.time;
    recording.add(snapshot);
  }
  Recording::Replay replay(recording);
  std::vector<std::uint64_t> revisions;
  for (Snapshot snapshot; replay.next(snapshot);) {
    EXPECT_EQ(snapshot.time, static_cast<double>(revisions.size()));
    revisions.push_back(snapshot.revision);
  }
  EXPECT_EQ(revisions, (std::vector<std::uint64_t>{1, 1, 2, 2, 3}));
}

TEST(Revisions, ChangeWithAForceAlone) {
  Revisions revisions;
  Snapshot snapshot = testing::pyramid_snapshot();
  EXPECT_TRUE(revisions.stamp(snapshot));
  EXPECT_FALSE(revisions.stamp(snapshot));
  snapshot.forces.front().force.x() += 1e-12;
  EXPECT_TRUE(revisions.stamp(snapshot));
}

}  // namespace
}  // namespace wuerfel
