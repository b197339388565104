#include "app/film/recording.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "tests/support/image_scenes.h"

namespace wuerfel::test {
namespace {

/// The literal pyramid and the triangles of Eq. (2), moved by `step` centimetres.
Snapshot moved(int step) {
  Snapshot snapshot = test::pyramid_snapshot();
  snapshot.sides = test::two_cubes_snapshot().sides;
  snapshot.time = 0.1 * step;
  snapshot.energy = 100.0 - step;
  snapshot.boxes[6].center.y() -= 0.01 * step;
  snapshot.boxes[6].angle = 0.3 * step;
  snapshot.forces.resize(static_cast<std::size_t>(step % 4));
  snapshot.joints.resize(static_cast<std::size_t>(5 + step % 4));
  snapshot.impacts.resize(static_cast<std::size_t>(step % 3));
  snapshot.boxes[6].acceleration.x() = step;
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
    EXPECT_EQ(a.boxes[i].acceleration, b.boxes[i].acceleration);
  }
  ASSERT_EQ(a.forces.size(), b.forces.size());
  for (std::size_t i = 0; i < a.forces.size(); ++i) {
    EXPECT_EQ(a.forces[i].point, b.forces[i].point);
    EXPECT_EQ(a.forces[i].force, b.forces[i].force);
    EXPECT_EQ(a.forces[i].kind, b.forces[i].kind);
    EXPECT_EQ(a.forces[i].body, b.forces[i].body);
  }
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.impacts, b.impacts);
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

/// Twenty instants of a cube in flight, which is what a recording may have to simulate again.
class Recordings : public ::testing::Test {
 protected:
  Scene scene = parse_scene("version = 1\n[[cube]]\nname = \"a\"\nposition = [0, 10]\n", "flight");
  StopSignal stop;
  MotionSource source{scene, {},  timetable(1.0, frame_times(1.0, {.fps = 20.0}), {}), {}, {},
                      {},    stop};
};

TEST_F(Recordings, GiveBackEverySnapshotAsOftenAsAsked) {
  Recording recording(source);
  for (int i = 0; i < 20; ++i)
    recording.add(moved(i));
  for (int round = 0; round < 2; ++round) {
    int i = 0;
    recording.for_each([&i](const Snapshot& snapshot) { expect_equal(snapshot, moved(i++)); });
    EXPECT_EQ(i, 20);
  }
}

TEST_F(Recordings, KnowWhatArrowsReach) {
  Recording recording(source);
  for (int i = 0; i < 4; ++i)
    recording.add(moved(i));
  double largest = 0.0;
  for (const SnapshotJoint& joint : moved(3).joints)
    largest = std::max(largest, joint.force.norm());
  EXPECT_EQ(recording.seen().forces.largest(), largest);
}

TEST_F(Recordings, OfWhatIsTooLargeToBeKeptAreSimulatedAgain) {
  std::vector<Snapshot> shown;
  Recording kept(source);
  Recording dropped(source, 1000);
  source.show_frames([&](const Snapshot& snapshot) {
    shown.push_back(snapshot);
    kept.add(snapshot);
    dropped.add(snapshot);
  });
  ASSERT_EQ(shown.size(), 21U);
  for (const Recording* recording : {&kept, &dropped}) {
    std::size_t i = 0;
    recording->for_each([&](const Snapshot& snapshot) {
      EXPECT_EQ(snapshot.time, shown[i].time);
      EXPECT_EQ(snapshot.energy, shown[i].energy);
      EXPECT_EQ(snapshot.boxes[0].center, shown[i].boxes[0].center);
      ++i;
    });
    EXPECT_EQ(i, 21U);
  }
  EXPECT_EQ(kept.range().fastest, dropped.range().fastest);
}

}  // namespace
}  // namespace wuerfel::test
