// What marks and words of a reason come to in the draw list.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "render/picture/compose_frame.h"

namespace wuerfel::test {
namespace {

Snapshot two_boxes() {
  Snapshot snapshot;
  snapshot.title = "two";
  snapshot.gravity = {0.0, -9.81};
  SnapshotBox below;
  below.name = "a";
  below.center = {0.0, 0.5};
  SnapshotBox above;
  above.name = "b";
  above.center = {0.6, 1.5};
  snapshot.boxes = {below, above};
  SnapshotReason reason;
  reason.headlines = {"b tips"};
  reason.advice = {"move b", "hold b"};
  snapshot.causes = {{.part = {1},
                      .centre = Vec2(0.6, 1.5),
                      .corner = Vec2(0.5, 1.0),
                      .beside = Vec2(0.6, 1.0),
                      .outside = 0.1,
                      .label = "a tenth"}};
  reason.fixes.resize(2);
  reason.fixes[0].moved = {1};
  reason.fixes[0].way = {-0.1, 0.0};
  reason.fixes[0].point = {0.6, 1.5};
  reason.fixes[0].label = "0.1 m";
  reason.fixes[1].point = {1.1, 1.0};
  reason.fixes[1].force = {0.0, 0.9};
  reason.fixes[1].label = "0.9 N";
  snapshot.reason = reason;
  return snapshot;
}

DrawList compose(const Snapshot& snapshot, Font& font) {
  FrameOptions options;
  options.layers = {Layer::cubes, Layer::causes, Layer::mechanism, Layer::names, Layer::hud};
  options.legend = {LegendEntry::mechanism, LegendEntry::cause};
  View view;
  view.width = 800;
  view.height = 600;
  view.pixels_per_metre = 150.0;
  view.center = {0.3, 1.0};
  return compose_frame(snapshot, view, make_style(Theme::light), options, font);
}

bool tells(const DrawList& list, const std::string& text) {
  return std::ranges::find(list.texts, text, &TextShape::text) != list.texts.end();
}

TEST(ComposeCauses, TellsWhatFailsAndWhatHelps) {
  Font font;
  const DrawList list = compose(two_boxes(), font);
  for (const char* text : {"b tips", "move b", "hold b", "a tenth", "0.1 m", "0.9 N"})
    EXPECT_TRUE(tells(list, text)) << text;
  EXPECT_FALSE(tells(list, "two"));  // in the place of the HUD
  for (const TextShape& text : list.texts) {
    EXPECT_GE(text.baseline.x, 0.0F) << text.text;
    EXPECT_LE(text.baseline.y, 600.0F) << text.text;
  }
}

TEST(ComposeCauses, NamesWhatTheWordsSpeakOfBesideItWhereItIsTooNarrow) {
  Font font;
  Snapshot snapshot = two_boxes();
  const std::string above = "the upper one of the two boxes of this picture";
  const std::string below = "the lower one of the two boxes of this picture";
  snapshot.boxes[0].name = below;
  snapshot.boxes[1].name = above;
  snapshot.reason->headlines = {above + " tips"};
  const DrawList list = compose(snapshot, font);
  EXPECT_TRUE(tells(list, above));
  EXPECT_FALSE(tells(list, below)) << "of which nothing is said";
  snapshot.boxes[0].name = "the upper one of the two boxes of this p";
  EXPECT_FALSE(tells(compose(snapshot, font), snapshot.boxes[0].name)) << "no word of its own";
}

TEST(ComposeCauses, MarksTheCornerTheCentreAndTheLever) {
  Font font;
  const Snapshot snapshot = two_boxes();
  const DrawList list = compose(snapshot, font);
  ASSERT_EQ(list.discs.size(), 2U);
  EXPECT_FLOAT_EQ(list.discs[0].center.x, 400.0F + 150.0F * 0.2F);  // the corner
  EXPECT_FLOAT_EQ(list.discs[1].center.x, 400.0F + 150.0F * 0.3F);  // the centre of mass
  const bool lever = std::ranges::any_of(list.segments, [](const SegmentShape& s) {
    return s.from.x == 430.0F && std::abs(s.to.x - 445.0F) < 1e-3F && s.from.y == s.to.y;
  });
  EXPECT_TRUE(lever);
}

TEST(ComposeCauses, ShowsWhereAMovedBoxWouldStand) {
  Font font;
  Snapshot snapshot = two_boxes();
  const std::size_t with = compose(snapshot, font).boxes.size();
  snapshot.reason->fixes.erase(snapshot.reason->fixes.begin());
  const std::size_t without = compose(snapshot, font).boxes.size();
  EXPECT_EQ(with, without + 1);
}

TEST(ComposeCauses, AWayTooShortToBeSeenIsShownAllTheSame) {
  Font font;
  Snapshot snapshot = two_boxes();
  snapshot.reason->fixes.resize(1);
  snapshot.reason->fixes[0].way = {-1e-9, 0.0};
  const DrawList list = compose(snapshot, font);
  const bool seen = std::ranges::any_of(
      list.arrows, [](const ArrowShape& a) { return a.tail.x - a.tip.x > 12.0F; });
  EXPECT_TRUE(seen);
}

TEST(ComposeCauses, WithoutAReasonTheLayerMeasuresByItself) {
  Font font;
  Snapshot snapshot = two_boxes();
  snapshot.reason.reset();
  snapshot.causes.front().label.clear();
  const DrawList list = compose(snapshot, font);
  EXPECT_TRUE(tells(list, "100 mm"));
  EXPECT_TRUE(tells(list, "two"));
  EXPECT_TRUE(tells(list, "fails by itself"));
  EXPECT_EQ(list.discs.size(), 2U);
}

// Dashes along the sides of the box where it comes to: 0.4 sides down, and a dashed arrow there.
TEST(ComposeCauses, AMechanismIsShownByDisplacedOutlines) {
  Font font;
  Snapshot snapshot = two_boxes();
  snapshot.reason.reset();
  snapshot.causes.clear();
  const std::size_t before = compose(snapshot, font).segments.size();
  snapshot.mechanism = {{1, Vec2(0.0, -1.0), 0.0}};
  const DrawList list = compose(snapshot, font);
  EXPECT_TRUE(tells(list, "mechanism, not to scale"));
  const Color color = make_style(Theme::light).mechanism;
  float lowest = 0.0F;
  int dashes = 0;
  for (const SegmentShape& s : list.segments) {
    if (s.color != color || s.from.y > 500.0F) continue;  // below stands the legend
    ++dashes;
    lowest = std::max(lowest, std::max(s.from.y, s.to.y));
  }
  EXPECT_GT(dashes, 30);
  EXPECT_GT(list.segments.size(), before + 30);
  EXPECT_NEAR(lowest, 360.0F, 1.0F);  // 0.6 m
  const bool arrow = std::ranges::any_of(list.arrows, [&](const ArrowShape& a) {
    return a.color == color && a.grow == 0.0F && std::abs(a.tip.y - 285.0F) < 1.0F;
  });
  EXPECT_TRUE(arrow);  // to 1.1 m, from 1.5 m
}

}  // namespace
}  // namespace wuerfel::test
