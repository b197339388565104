// Arrows, and what else shows forces and motions, in the draw list.
#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "render/picture/labels.h"
#include "render/picture/units.h"
#include "tests/unit/render/picture/composition.h"

namespace wuerfel::test {
namespace {

TEST_F(Composition, ArrowLengthsAreProportionalToForces) {
  const auto arrows = arrows_of(compose({Layer::forces}), style.contact);
  ASSERT_EQ(arrows.size(), 9U) << "one for each joint";
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    const double expected = snapshot.joints[i].force.norm() * options.force_scale.metres_per_newton
                            * view.pixels_per_metre;
    EXPECT_NEAR(length(arrows[i]), std::min(expected, 0.8 * view.pixels_per_metre), 1e-3) << i;
  }
}

TEST_F(Composition, ArrowsEndAtTheirJoints) {
  const auto arrows = arrows_of(compose({Layer::forces}), style.contact);
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    const Vec2 place = view.to_pixel(snapshot.joints[i].point);
    EXPECT_NEAR(arrows[i].tip.x, place.x(), 1e-3);
    EXPECT_NEAR(arrows[i].tip.y, place.y(), 1e-3);
  }
}

TEST_F(Composition, WhatIsNotTheOnlyPossibleForceIsHollow) {
  const auto inside = arrows_of(compose({Layer::forces}), style.halo);
  EXPECT_EQ(inside.size(), 6U) << "the six joints in the upper rows";
}

TEST_F(Composition, LongArrowIsCutAndBroken) {
  const std::size_t before = compose({Layer::forces}).segments.size();
  snapshot.joints.front().force = Vec2(0.0, 1000.0);
  const DrawList list = compose({Layer::forces});
  EXPECT_NEAR(length(arrows_of(list, style.contact)[0]),
              options.force_scale.longest * view.pixels_per_metre, 1e-2);
  EXPECT_EQ(list.segments.size(), before + 3) << "a gap and two strokes";
}

TEST_F(Composition, HiddenForceLeavesADot) {
  snapshot.impacts.clear();
  const DrawList before = compose({Layer::forces});
  snapshot.joints.front().force = Vec2(0.0, 0.5 * options.force_scale.hidden_below);
  const DrawList list = compose({Layer::forces});
  EXPECT_EQ(arrows_of(list, style.contact).size(), 8U);
  ASSERT_EQ(list.discs.size(), before.discs.size() + 1);
  EXPECT_EQ(list.discs.back().fill, style.contact);
}

TEST_F(Composition, KindsOfArrowsDifferInForm) {
  const DrawList velocities = compose({Layer::velocities});
  EXPECT_TRUE(velocities.arrows.empty());
  EXPECT_EQ(velocities.segments.size(), 2U * 2U * 3U) << "two open heads with halos";
  EXPECT_EQ(compose({Layer::accelerations}).segments.size() % 5U, 0U) << "two heads each";
  const DrawList corners = compose({Layer::contact_forces});
  EXPECT_EQ(corners.triangles.size(), 4U) << "half heads of two frictions with halos";
}

TEST_F(Composition, NoHaloIsPaintedOverAnArrow) {
  const DrawList list = compose({Layer::cubes, Layer::forces});
  const auto first_arrow =
      std::ranges::find_if(list.arrows, [](const ArrowShape& a) { return a.grow == 0.0F; });
  EXPECT_GT(first_arrow - list.arrows.begin(), 0);
  EXPECT_TRUE(std::all_of(first_arrow, list.arrows.end(),
                          [](const ArrowShape& a) { return a.grow == 0.0F; }));
}

TEST_F(Composition, WeightsStartAtTheCentres) {
  const auto arrows = arrows_of(compose({Layer::weights}), style.own_weight);
  ASSERT_EQ(arrows.size(), 8U);
  const Vec2 center = view.to_pixel(snapshot.boxes[0].center);
  EXPECT_NEAR(arrows[0].tail.y, center.y(), 1e-3);
  EXPECT_GT(arrows[0].tip.y, arrows[0].tail.y) << "downwards";
}

TEST_F(Composition, PointMassesHaveVelocitiesAndWeightsToo) {
  snapshot.boxes.clear();
  snapshot.masses = {{"bob", Vec2(1.0, 2.0), 1.0, Vec2(0.0, 3.0)}};
  const DrawList velocity = compose({Layer::velocities});
  EXPECT_EQ(velocity.segments.size(), 2U * 3U) << "an open head with its halo";
  const auto weights = arrows_of(compose({Layer::weights}), style.own_weight);
  ASSERT_EQ(weights.size(), 1U);
  const Vec2 place = view.to_pixel(Vec2(1.0, 2.0));
  EXPECT_NEAR(weights[0].tail.x, place.x(), 1e-3);
  EXPECT_NEAR(weights[0].tail.y, place.y(), 1e-3);
  EXPECT_GT(weights[0].tip.y, weights[0].tail.y) << "downwards";
  ForceRange range;
  range.include(snapshot);
  EXPECT_GT(range.scale().metres_per_newton, 0.0) << "of their weights, where nothing else is";
}

TEST_F(Composition, ACrowdShowsChainsInsteadOfArrows) {
  SnapshotBox far = snapshot.boxes[0];
  far.center = Vec2(-2.0, 4.0);
  snapshot.boxes.resize(snapshot.boxes.size() + crowd, far);
  snapshot.impacts.clear();
  const DrawList list = compose({Layer::forces});
  EXPECT_TRUE(list.arrows.empty());
  EXPECT_EQ(list.segments.size(), 2U * 9U);
}

TEST_F(Composition, NoNameLiesOnAnArrowOrOnAnotherName) {
  const DrawList list = compose({Layer::cubes, Layer::forces, Layer::velocities, Layer::names});
  EXPECT_GE(list.texts.size(), 8U);
  for (const TextShape& text : list.texts) {
    const internal::Area area = internal::text_area(text, font);
    internal::Labels labels(view.width, view.height);
    for (const ArrowShape& arrow : list.arrows)
      labels.keep_off(arrow.tail, arrow.tip, 1.0);
    for (const TextShape& other : list.texts)
      if (!(other == text)) labels.keep_off(internal::text_area(other, font));
    DrawList scratch;
    EXPECT_TRUE(labels.place(text, std::span(&text.baseline, 1), font, scratch)) << text.text;
    EXPECT_GT(area.right, area.left);
  }
}

TEST_F(Composition, PressureFillsTheFaceOrTheThirdThatCarries) {
  // e = 0.1 of the face: all of it presses.
  const auto extent = [&](const DrawList& list) {
    float low = 1e9F;
    float high = -1e9F;
    for (const SegmentShape& segment : list.segments) {
      low = std::min({low, segment.from.x, segment.to.x});
      high = std::max({high, segment.from.x, segment.to.x});
    }
    return static_cast<double>(high - low) / view.pixels_per_metre;
  };
  snapshot.joints.resize(1);
  EXPECT_NEAR(extent(compose({Layer::joints})), 1.0, 1e-4);
  // Outside the middle third: three times the distance from the edge.
  snapshot.joints[0].point = snapshot.joints[0].from - Vec2(0.2, 0.0);
  EXPECT_NEAR(extent(compose({Layer::joints})), 0.6, 1e-4);
}

TEST_F(Composition, HingesAreWhereTheThrustMeetsAnEnd) {
  EXPECT_TRUE(compose({Layer::thrust}).discs.empty());
  snapshot.joints[1].point = snapshot.joints[1].to;
  EXPECT_EQ(compose({Layer::thrust}).discs.size(), 1U);
}

TEST_F(Composition, TensionAndCompressionHaveTheirColours) {
  snapshot.rods = {{Vec2(0.0, 0.0), Vec2(1.0, 0.0), 5.0}, {Vec2(0.0, 1.0), Vec2(1.0, 1.0), -2.0}};
  const DrawList list = compose({Layer::rod_forces});
  ASSERT_EQ(list.segments.size(), 4U) << "two halos, two rods";
  EXPECT_EQ(list.segments[2].color, style.tension);
  EXPECT_EQ(list.segments[3].color, style.compression);
  EXPECT_GT(list.segments[2].half_width, list.segments[3].half_width);
}

TEST_F(Composition, SmallBodiesHaveOneAccelerationAndThinOnesTwoMore) {
  snapshot.planes.clear();
  snapshot.boxes.resize(1);
  snapshot.boxes[0].acceleration = Vec2(0.0, -9.81);
  snapshot.boxes[0].angular_acceleration = 30.0;
  options.layers = {Layer::accelerations};
  view = {1280, 720, snapshot.boxes[0].center, 100.0};
  const auto arrows = [&](const Vec2& size) {
    snapshot.boxes[0].size = size;
    return compose_frame(snapshot, view, style, options, font).segments.size() / (2U * 5U);
  };
  EXPECT_EQ(arrows({1.0, 1.0}), 5U);
  EXPECT_EQ(arrows({3.0, 0.1}), 3U);
  EXPECT_EQ(arrows({0.2, 0.2}), 1U);
}

TEST_F(Composition, PressureHasItsNumberWithAndWithoutArrows) {
  const auto numbers = [&](Layers layers) {
    std::vector<std::string> texts;
    for (const TextShape& text : compose(layers).texts)
      texts.push_back(text.text);
    std::ranges::sort(texts);
    return texts;
  };
  const auto alone = numbers({Layer::cubes, Layer::joints});
  EXPECT_GE(alone.size(), 7U) << "of nine";
  EXPECT_NE(std::ranges::find(alone, "20.0 N"), alone.end()) << "below the middle";
}

TEST_F(Composition, WithoutArrowsTheNumberOfAPressureStandsBehindIt) {
  snapshot.joints.resize(1);
  options.force_scale.longest = 3.0;
  SnapshotJoint& joint = snapshot.joints.front();
  joint.force *= 2.0 / (options.force_scale.metres_per_newton * joint.force.norm());
  const DrawList list = compose({Layer::joints});
  ASSERT_EQ(list.texts.size(), 1U);
  float deepest = 0.0F;
  for (const SegmentShape& segment : list.segments)
    deepest = std::max({deepest, segment.from.y, segment.to.y});
  const internal::Area area = internal::text_area(list.texts.front(), font);
  EXPECT_NEAR(area.top, deepest, 16.0) << "an arrow of 2 m would begin farther away";
}

TEST_F(Composition, WithoutArrowsTheNumberOfACornerStandsBesideIt) {
  snapshot.joints.resize(1);
  SnapshotJoint& corner = snapshot.joints.front();
  corner.from = corner.to = corner.point;
  const DrawList list = compose({Layer::cubes, Layer::joints});
  ASSERT_EQ(list.texts.size(), 1U);
  const internal::Area area = internal::text_area(list.texts.front(), font);
  const Vec2 place = view.to_pixel(corner.point);
  EXPECT_NEAR(std::clamp(place.x(), area.left, area.right), place.x(), 16.0);
  EXPECT_NEAR(std::clamp(place.y(), area.top, area.bottom), place.y(), 16.0);
}

TEST_F(Composition, NumbersKeepOffTheGroundLine) {
  for (const TextShape& text :
       compose({Layer::cubes, Layer::forces, Layer::weights, Layer::values}).texts) {
    const internal::Area area = internal::text_area(text, font);
    const double ground = view.to_pixel(Vec2::Zero()).y();
    EXPECT_FALSE(area.top < ground && ground < area.bottom) << text.text;
  }
}

TEST_F(Composition, WeightsAndTextGrowWithThePicture) {
  EXPECT_DOUBLE_EQ(frame_unit(1280, 720, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(frame_unit(2560, 1440, 1.0), 2.0) << "what --scale 2 would double again";
  EXPECT_DOUBLE_EQ(frame_unit(2560, 1440, 2.0), 4.0);
  EXPECT_NEAR(frame_unit(320, 240, 1.0), 0.62, 1e-12) << "never below what can be read";
}

TEST_F(Composition, ArrowsThatAThinBodyCutsBeginBehindIt) {
  Snapshot plank;
  plank.boxes = {snapshot.boxes[0], snapshot.boxes[0]};
  plank.boxes[0].center = {0.0, 0.5};
  plank.boxes[0].size = {1.0, 1.0};
  plank.boxes[0].angle = 0.0;
  plank.boxes[1] = plank.boxes[0];
  plank.boxes[1].center = {0.0, -0.02};
  plank.boxes[1].size = {2.0, 0.04};
  plank.joints = {snapshot.joints[0]};
  SnapshotJoint& joint = plank.joints[0];
  joint.body = 0;
  joint.other = 1;
  joint.point = {0.0, 0.0};
  joint.normal = {0.0, 1.0};
  joint.from = {-0.5, 0.0};
  joint.to = {0.5, 0.0};
  joint.force = {0.0, 0.5 / options.force_scale.metres_per_newton};  // half a side long
  snapshot = plank;
  const auto free = arrows_of(compose({Layer::forces}), style.contact);
  ASSERT_EQ(free.size(), 1U);
  EXPECT_GT(length(free[0]), 0.04 * view.pixels_per_metre) << "longer than the plank is thick";
  // Never into the next body.
  snapshot.boxes.push_back(plank.boxes[0]);
  snapshot.boxes[2].center = {0.0, -0.54};
  for (const ArrowShape& arrow : arrows_of(compose({Layer::forces}), style.contact))
    EXPECT_LT(length(arrow), 0.04 * view.pixels_per_metre);
}

TEST_F(Composition, ForcesRunThroughTheBodies) {
  const DrawList list = compose({Layer::forces});
  // Six ways: two joints above and below each box of the middle row, two below the top, ...
  const auto ways = std::ranges::count_if(
      list.segments, [](const SegmentShape& s) { return s.color.a < 255 && s.round == 1.0F; });
  EXPECT_EQ(ways, 1 + 3 + 1 + 3 + 3 + 2) << "of six boxes";
  EXPECT_EQ(std::ranges::count(compose({Layer::forces, Layer::thrust}).groups, "paths",
                               &ShapeGroup::name),
            0)
      << "not twice";
}

TEST_F(Composition, NumbersStandBehindTheirArrows) {
  const DrawList list = compose({Layer::cubes, Layer::forces, Layer::values});
  const ArrowShape first = arrows_of(list, style.contact)[1];
  const auto number = std::ranges::find(list.texts, "20.0 N", &TextShape::text);
  ASSERT_NE(number, list.texts.end());
  const internal::Area area = internal::text_area(*number, font);
  EXPECT_GT(area.top, static_cast<double>(first.tail.y)) << "below the tail";
  EXPECT_NEAR(0.5 * (area.left + area.right), static_cast<double>(first.tail.x), 1e-3);
}

TEST_F(Composition, WhiskersReachFromTheLeastForceToTheMost) {
  snapshot = failing_snapshot();
  const auto whiskers = [&](const DrawList& list) {
    std::vector<SegmentShape> found;
    std::ranges::copy_if(list.segments, std::back_inserter(found), [&](const SegmentShape& s) {
      return s.color == style.whisker && is_upright(s);
    });
    return found;
  };
  EXPECT_TRUE(whiskers(compose({Layer::cubes, Layer::forces})).empty());
  const DrawList list = compose({Layer::cubes, Layer::forces, Layer::whiskers});
  const std::vector<SegmentShape> found = whiskers(list);
  ASSERT_EQ(found.size(), 3U);
  const double ppm = view.pixels_per_metre;
  const Vec2 place = view.to_pixel(snapshot.joints[3].point);
  EXPECT_NEAR(found[0].from.y, place.y() + 2.0 * 0.04 * ppm, 1e-2);
  EXPECT_NEAR(found[0].to.y, place.y() + 12.0 * 0.04 * ppm, 1e-2);
  EXPECT_GT(found[0].from.x, place.x() + 2.0);
  // 40 N are longer than the longest arrow: an open end instead of a bar.
  EXPECT_NEAR(found[1].to.y, view.to_pixel(snapshot.joints[4].point).y() + 0.8 * ppm, 1e-2);
  const auto bars = std::ranges::count_if(list.segments, [&](const SegmentShape& s) {
    return s.color == style.whisker && std::abs(s.from.y - s.to.y) < 1e-3F;
  });
  EXPECT_EQ(bars, 5);
}

TEST_F(Composition, WhiskersStandAtCornerForcesToo) {
  snapshot = failing_snapshot();
  const DrawList list = compose({Layer::cubes, Layer::contact_forces, Layer::whiskers});
  EXPECT_EQ(std::ranges::count_if(
                list.segments,
                [&](const SegmentShape& s) { return s.color == style.whisker && is_upright(s); }),
            1);
}

}  // namespace
}  // namespace wuerfel::test
