#include "app/film/trails.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

Snapshot at(int moment) {
  Snapshot snapshot;
  SnapshotBox fixed;
  fixed.fixed = true;
  SnapshotBox cube;
  cube.color_index = 3;
  cube.center = Vec2(moment, 0.0);
  snapshot.boxes = {fixed, cube};
  return snapshot;
}

TEST(Trails, FollowCubesAndNotFixedBoxes) {
  Trails trails;
  for (int i = 0; i < 10; ++i)
    trails.add(at(i));
  ASSERT_EQ(trails.paths().size(), 1U);
  EXPECT_EQ(trails.paths()[0].color_index, 3);
  ASSERT_EQ(trails.paths()[0].path.size(), 10U);
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(trails.paths()[0].path[static_cast<std::size_t>(i)].x(), i);
}

TEST(Trails, OfLongRunsKeepTheirEndsAndEvenSteps) {
  Trails trails;
  for (int i = 0; i < 30000; ++i) {
    trails.add(at(i));
    const std::vector<Vec2>& path = trails.paths()[0].path;
    ASSERT_LE(path.size(), 2048U);
    ASSERT_EQ(path.front().x(), 0.0);
    ASSERT_EQ(path.back().x(), i);
    if (path.size() < 3) continue;
    const double step = path[1].x();
    ASSERT_EQ(path[path.size() - 2].x(), step * static_cast<double>(path.size() - 2));
    ASSERT_LE(path.back().x() - path[path.size() - 2].x(), step);
  }
  EXPECT_GT(trails.paths()[0].path.size(), 1000U);
}

}  // namespace
}  // namespace wuerfel::test
