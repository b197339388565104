#include "app/film/specks.h"

#include <gtest/gtest.h>

#include "tests/support/image_scenes.h"

namespace wuerfel::test {
namespace {

TEST(HintAtSpecks, NamesTheViewOfTheLargestGroup) {
  Snapshot snapshot = testing::pyramid_snapshot();
  Bounds near;
  for (const SnapshotBox& box : snapshot.boxes)
    if (!box.fixed) near.include(box);
  SnapshotBox far = snapshot.boxes[0];
  far.center.x() = 1000.0;
  snapshot.boxes.push_back(far);
  const View view = fixed_view(Vec2(500.0, 0.0), 1100.0, 1280, 720);
  const std::string hint = hint_at_specks(snapshot, view);
  EXPECT_NE(hint.find("1.2 pixels"), std::string::npos) << hint;
  const Vec2 middle = 0.5 * (near.min + near.max);
  EXPECT_NE(hint.find("--view " + std::to_string(middle.x()).substr(0, 4)), std::string::npos)
      << hint;
}

TEST(HintAtSpecks, SaysNothingOfCrowdsAndOfWhatIsSeen) {
  Snapshot snapshot;
  EXPECT_EQ(hint_at_specks(snapshot, View{}), "");
  for (int i = 0; i < 1000; ++i) {
    SnapshotBox box;
    box.center = Vec2(i, 0.5);
    snapshot.boxes.push_back(box);
  }
  EXPECT_EQ(hint_at_specks(snapshot, fixed_view(Vec2(500.0, 0.0), 1100.0, 1280, 720)), "")
      << "one row of them";
  snapshot.boxes.resize(3);
  EXPECT_EQ(hint_at_specks(snapshot, fixed_view(Vec2::Zero(), 10.0, 1280, 720)), "");
}

}  // namespace
}  // namespace wuerfel::test
