// What a frame is made of, looked at in the draw list: no pixel is drawn here.
#include "render/picture/compose_frame.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "render/picture/explode.h"
#include "render/picture/labels.h"
#include "render/picture/units.h"
#include "render/raster/renderer.h"
#include "tests/support/image_scenes.h"

namespace wuerfel {
namespace {

bool is_upright(const SegmentShape& s) { return s.from.x == s.to.x && s.from.y != s.to.y; }

class Composition : public ::testing::Test {
 protected:
  DrawList compose(Layers layers) {
    options.layers = layers;
    view = test::literal_view(snapshot, style, options, 640, 360);
    return compose_frame(snapshot, view, style, options, font);
  }
  /// Arrows of a colour without their halos.
  std::vector<ArrowShape> arrows_of(const DrawList& list, Color color) const {
    std::vector<ArrowShape> found;
    std::ranges::copy_if(list.arrows, std::back_inserter(found), [color](const ArrowShape& arrow) {
      return arrow.color == color && arrow.grow == 0.0F;
    });
    return found;
  }

  Snapshot snapshot = test::pyramid_snapshot();
  Style style = make_style(Theme::light);
  FrameOptions options = test::literal_options(default_layers);
  View view;
  Font font;
};

double length(const ArrowShape& arrow) {
  return std::hypot(static_cast<double>(arrow.tip.x - arrow.tail.x),
                    static_cast<double>(arrow.tip.y - arrow.tail.y));
}

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

TEST_F(Composition, NamesThatDoNotFitAreLeftOutAndCounted) {
  snapshot.boxes[0].name = std::string(60, 'x');
  const DrawList list = compose({Layer::cubes, Layer::names});
  EXPECT_TRUE(std::ranges::none_of(
      list.texts, [](const TextShape& text) { return text.text.starts_with("xx"); }));
  EXPECT_GE(list.labels_left_out, 1);
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

TEST_F(Composition, LayerThatIsOffLeavesNothing) {
  EXPECT_TRUE(compose({Layer::forces}).boxes.empty());
  EXPECT_TRUE(compose({Layer::cubes}).arrows.empty());
  EXPECT_TRUE(compose({Layer::cubes}).texts.empty());
  EXPECT_TRUE(compose({Layer::cubes}).discs.empty());
  EXPECT_TRUE(compose({}).runs.empty());
}

TEST_F(Composition, RodsThatAreNotListedAreDiagonals) {
  snapshot.rods.clear();
  const DrawList list = compose({Layer::cubes, Layer::rods});
  EXPECT_EQ(std::ranges::count_if(list.boxes,
                                  [](const BoxShape& box) { return box.diagonal_width > 0.0F; }),
            8)
      << "one for each cube, none for the shelf and the ground";
}

TEST_F(Composition, MassesHaveAreasProportionalToThem) {
  snapshot.points = {{Vec2(0.0, 0.0), 4.0}, {Vec2(1.0, 0.0), 1.0}};
  const DrawList list = compose({Layer::points});
  ASSERT_EQ(list.discs.size(), 2U);
  const float border = list.discs[0].outline_width;
  EXPECT_NEAR((list.discs[0].radius - border) / (list.discs[1].radius - border), 2.0, 1e-4);
}

TEST_F(Composition, TensionAndCompressionHaveTheirColours) {
  snapshot.rods = {{Vec2(0.0, 0.0), Vec2(1.0, 0.0), 5.0}, {Vec2(0.0, 1.0), Vec2(1.0, 1.0), -2.0}};
  const DrawList list = compose({Layer::rod_forces});
  ASSERT_EQ(list.segments.size(), 4U) << "two halos, two rods";
  EXPECT_EQ(list.segments[2].color, style.tension);
  EXPECT_EQ(list.segments[3].color, style.compression);
  EXPECT_GT(list.segments[2].half_width, list.segments[3].half_width);
}

TEST_F(Composition, TrianglesOfEquation2ShowTheirSign) {
  snapshot = test::two_cubes_snapshot();
  const DrawList list = compose({Layer::sides});
  ASSERT_EQ(list.triangles.size(), 2U);
  EXPECT_EQ(list.triangles[0].outline, style.positive_side);
  EXPECT_EQ(list.triangles[1].outline, style.negative_side);
  EXPECT_EQ(std::ranges::count(list.segments, style.positive_side, &SegmentShape::color), 1)
      << "the flat one is a line";
  EXPECT_GT(std::ranges::count(list.segments, style.negative_side, &SegmentShape::color), 1)
      << "the negative one is hatched";
}

TEST_F(Composition, HudStaysInsideThePictureAtEverySize) {
  for (const auto& [width, height] :
       {std::pair(1280, 720), std::pair(320, 180), std::pair(200, 400)}) {
    options.layers = default_layers;
    view = test::literal_view(snapshot, style, options, width, height);
    const DrawList list = compose_frame(snapshot, view, style, options, font);
    ASSERT_GE(list.texts.size(), 2U);
    for (const TextShape& text : list.texts) {
      const double size = static_cast<double>(text.size);
      EXPECT_GE(text.baseline.x, 0.0F) << text.text;
      EXPECT_LE(static_cast<double>(text.baseline.x) + font.width(text.text, size), width)
          << text.text;
      EXPECT_GE(static_cast<double>(text.baseline.y) - size, 0.0) << text.text;
      EXPECT_LE(text.baseline.y, static_cast<float>(height)) << text.text;
    }
  }
}

TEST_F(Composition, FittedPictureLeavesRoomForArrowsAndHud) {
  const DrawList list = compose(default_layers);
  for (const ArrowShape& arrow : arrows_of(list, style.contact)) {
    if (arrow.tail.y == arrow.tip.y) continue;  // of the legend
    EXPECT_GT(arrow.tip.y, 60.0F * 0.62F);
    EXPECT_LT(arrow.tail.y, 360.0F - 50.0F * 0.62F);
  }
}

TEST_F(Composition, LegendHasRoundNumbersAndIsAsLongAsItSays) {
  const DrawList list = compose({Layer::forces, Layer::hud});
  EXPECT_TRUE(
      std::ranges::any_of(list.texts, [](const TextShape& text) { return text.text == "20 N"; }));
  const auto arrows = arrows_of(list, style.contact);
  const double expected = 20.0 * options.force_scale.metres_per_newton * view.pixels_per_metre;
  EXPECT_TRUE(std::ranges::any_of(arrows, [&](const ArrowShape& arrow) {
    return arrow.tail.y == arrow.tip.y && std::abs(length(arrow) - expected) < 1e-3;
  }));
}

TEST_F(Composition, LinesAndTextGrowWithThePicture) {
  options.layers = default_layers;
  const auto title_size = [&](int width, int height, double scale) {
    options.scale = scale;
    view = test::literal_view(snapshot, style, options, width, height);
    return compose_frame(snapshot, view, style, options, font).texts.front().size;
  };
  const float normal = title_size(1280, 720, 1.0);
  EXPECT_FLOAT_EQ(title_size(2560, 1440, 1.0), 2.0F * normal);
  EXPECT_FLOAT_EQ(title_size(1280, 720, 1.5), 1.5F * normal);
}

TEST_F(Composition, LongTitleIsShortened) {
  snapshot.title = std::string(300, 'W');
  const DrawList list = compose(default_layers);
  EXPECT_TRUE(list.texts.front().text.ends_with("…"));
}

TEST_F(Composition, GridEndsHoweverFarOutTheViewIs) {
  for (const double distance : {1e6, 1e12, 1e15, 1e16, 1e100, 1e300}) {
    for (const double width : {1e-300, 1e-3, 1.0, 1e300}) {
      options.layers = {Layer::grid, Layer::cubes};
      view = fixed_view(Vec2(distance, -distance), width, 640, 360);
      EXPECT_LT(compose_frame(snapshot, view, style, options, font).segments.size(), 2000U)
          << distance << ' ' << width;
    }
  }
}

TEST_F(Composition, GridHasALineAtEveryHalfMetreThatIsSeen) {
  options.layers = {Layer::grid};
  view = fixed_view(Vec2(1e6, 0.0), 6.4, 640, 360);
  const DrawList list = compose_frame(snapshot, view, style, options, font);
  EXPECT_EQ(list.segments.size(), 13U + 7U);
}

TEST_F(Composition, HudHasAPlateBehindIt) {
  snapshot.planes.push_back({"wall", Vec2(-4.0, 0.0), Vec2::UnitX()});
  const DrawList list = compose({Layer::cubes, Layer::hud});
  // The head's plate is the first of the strokes that are as high as a title; its texts lie inside.
  const auto plate = std::ranges::find_if(
      list.segments, [](const SegmentShape& s) { return s.half_width > 12.0F && s.round == 0.0F; });
  ASSERT_NE(plate, list.segments.end());
  for (const std::size_t i : {0U, 1U, 2U}) {
    const internal::Area area = internal::text_area(list.texts[i], font);
    EXPECT_GE(area.left, plate->from.x);
    EXPECT_LE(area.right, plate->to.x);
    EXPECT_GE(area.top, plate->from.y - plate->half_width);
    EXPECT_LE(area.bottom, plate->from.y + plate->half_width);
  }
  EXPECT_GT(plate->color.a, 216);
}

TEST_F(Composition, PlatesHaveTheColoursOfWhatTheyHide) {
  // The edge of a wall runs through the title: ground on its left, background on its right.
  view = test::literal_view(snapshot, style, options, 640, 360);
  const Vec2 place = view.to_world(Vec2(60.0, 20.0));
  snapshot.planes.push_back({"wall", place, Vec2::UnitX()});
  options.layers = {Layer::cubes, Layer::hud};
  const DrawList list = compose_frame(snapshot, view, style, options, font);
  const auto last_over = [&](float x, float y) {
    Color color;
    for (const SegmentShape& s : list.segments) {
      if (s.round == 0.0F && s.from.y == s.to.y && s.half_width > 5.0F && s.from.x <= x
          && x <= s.to.x && std::abs(s.from.y - y) <= s.half_width)
        color = s.color;
    }
    return color;
  };
  const float y = list.texts.front().baseline.y;
  EXPECT_EQ(last_over(40.0F, y), style.ground);
  EXPECT_EQ(last_over(80.0F, y), style.background);
}

TEST_F(Composition, TheLegendHasAPlateOverBodies) {
  // Bodies reach to the lower border, as under a camera that follows one.
  options.layers = default_layers;
  view = fixed_view(Vec2(-1.0, 1.4), 3.0, 640, 360);
  const DrawList list = compose_frame(snapshot, view, style, options, font);
  const auto hud = std::ranges::find(list.groups, "hud", &ShapeGroup::name);
  ASSERT_NE(hud, list.groups.end());
  const auto bodies = std::ranges::find(list.groups, "bodies", &ShapeGroup::name);
  EXPECT_LT(bodies->shape, hud->shape) << "the HUD is painted after all bodies";
  const TextShape& foot = list.texts.back();
  const internal::Area area = internal::text_area(foot, font);
  EXPECT_TRUE(std::ranges::any_of(list.segments, [&](const SegmentShape& s) {
    return s.round == 0.0F
           && static_cast<double>(s.from.x)<area.left&& static_cast<double>(s.to.x)> area.right
           && static_cast<double>(
                  s.from.y - s.half_width)<area.top&& static_cast<double>(s.from.y + s.half_width)>
                  area.bottom
           && s.color.a == 255;
  })) << foot.text;
}

TEST_F(Composition, ContactsAndPointsArePaintedOverArrows) {
  const DrawList list =
      compose({Layer::cubes, Layer::forces, Layer::contacts, Layer::points, Layer::normals});
  const auto start = [&](std::string_view name) {
    const auto group = std::ranges::find(list.groups, name, &ShapeGroup::name);
    EXPECT_NE(group, list.groups.end()) << name;
    return group->shape;
  };
  EXPECT_LT(start("arrows"), start("contacts"));
  EXPECT_LT(start("arrows"), start("points"));
}

TEST_F(Composition, TheLegendNamesNormalsAndThrust) {
  const auto says = [&](Layers layers, std::string_view what) {
    return std::ranges::any_of(compose(layers).texts,
                               [&](const TextShape& text) { return text.text == what; });
  };
  EXPECT_TRUE(says({Layer::normals, Layer::hud}, "normal"));
  EXPECT_TRUE(says({Layer::forces, Layer::hud}, "thrust"));
  EXPECT_FALSE(says({Layer::contact_forces, Layer::hud}, "thrust"));
}

TEST_F(Composition, TheLegendNamesTheForcesThatAreDrawn) {
  const auto says = [&](Layers layers, std::string_view what) {
    return std::ranges::any_of(compose(layers).texts, [&](const TextShape& text) {
      return text.text.find(what) != std::string::npos;
    });
  };
  options.legend = {LegendEntry::contact, LegendEntry::hidden};
  EXPECT_TRUE(says({Layer::weights, Layer::hud}, "N weight"));
  EXPECT_TRUE(arrows_of(compose({Layer::weights, Layer::hud}), style.contact).empty());
  EXPECT_FALSE(says({Layer::weights, Layer::forces, Layer::hud}, "N weight"));
  EXPECT_TRUE(says({Layer::forces, Layer::hud}, "below"));
  EXPECT_FALSE(says({Layer::contact_forces, Layer::hud}, "friction"));
  options.legend.insert(LegendEntry::friction);
  EXPECT_TRUE(says({Layer::contact_forces, Layer::hud}, "friction"));
}

TEST_F(Composition, LegendEntriesWithoutRoomAreCounted) {
  Layers all{Layer::hud};
  for (const Layer layer : {Layer::cubes, Layer::contact_forces, Layer::weights, Layer::normals,
                            Layer::joints, Layer::thrust, Layer::rod_forces})
    all.insert(layer);
  options.layers = all;
  const auto left_out = [&](int width) {
    view = test::literal_view(snapshot, style, options, width, 360);
    return compose_frame(snapshot, view, style, options, font).legend_left_out;
  };
  EXPECT_EQ(left_out(1280), 0);
  EXPECT_GT(left_out(200), 0);
}

TEST_F(Composition, TwoRowsOfALegendAreAboutAsLongAsEachOther) {
  options.legend = {LegendEntry::contact, LegendEntry::friction, LegendEntry::cut,
                    LegendEntry::several, LegendEntry::hidden,   LegendEntry::impact};
  options.layers = {Layer::contact_forces, Layer::forces, Layer::weights, Layer::hud};
  view = test::literal_view(snapshot, style, options, 1000, 500);
  const DrawList list = compose_frame(snapshot, view, style, options, font);
  ASSERT_EQ(list.legend_left_out, 0);
  std::map<float, double> end_of_row;
  for (const TextShape& text : list.texts) {
    if (text.baseline.y > 450.0F) {
      double& end = end_of_row[text.baseline.y];
      end = std::max(end, internal::text_area(text, font).right);
    }
  }
  ASSERT_EQ(end_of_row.size(), 2U);
  const double first = end_of_row.begin()->second;
  const double second = end_of_row.rbegin()->second;
  EXPECT_LT(std::max(first, second), 1.4 * std::min(first, second));
}

TEST_F(Composition, TheLegendNamesSidesMassesAndWhiskers) {
  const auto says = [&](Layers layers, std::string_view what) {
    options.layers = layers;
    view = test::literal_view(snapshot, style, options, 1280, 720);
    const DrawList list = compose_frame(snapshot, view, style, options, font);
    return std::ranges::any_of(list.texts,
                               [&](const TextShape& text) { return text.text == what; });
  };
  EXPECT_TRUE(says({Layer::sides, Layer::hud}, "A ≥ 0"));
  EXPECT_FALSE(says({Layer::sides, Layer::hud}, "A < 0"));
  options.legend.insert(LegendEntry::negative);
  EXPECT_TRUE(says({Layer::sides, Layer::hud}, "A < 0"));
  EXPECT_TRUE(says({Layer::points, Layer::hud}, "mass, by area"));
  options.legend.insert(LegendEntry::range);
  EXPECT_TRUE(says({Layer::forces, Layer::whiskers, Layer::hud}, "from least to most"));
  EXPECT_FALSE(says({Layer::forces, Layer::whiskers, Layer::hud}, "and on"));
  options.legend.insert(LegendEntry::beyond);
  EXPECT_TRUE(says({Layer::forces, Layer::whiskers, Layer::hud}, "and on"));
}

TEST_F(Composition, ColorBarsPointUpWhereThereIsMore) {
  options.coloring = {ColorBy::load, 40.0};
  const auto written = [&] {
    std::string all;
    for (const TextShape& text : compose({Layer::cubes, Layer::hud}).texts)
      all += text.text + "|";
    return all;
  };
  const auto points = [&] { return compose({Layer::cubes, Layer::hud}).triangles.size(); };
  EXPECT_NE(written().find("|40 N|"), std::string::npos) << written();
  const std::size_t before = points();
  options.legend.insert(LegendEntry::above);
  EXPECT_NE(written().find("|≥ 40 N|"), std::string::npos) << written();
  EXPECT_EQ(points(), before + 1);
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

TEST_F(Composition, SmallTextOnSlidesIsDark) {
  const Style slide = make_style(Theme::transparent);
  EXPECT_EQ(slide.quiet_ink, slide.ink);
  EXPECT_LT(brightness(slide.quiet_ink), 0.2);
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

TEST_F(Composition, EnergyBelowRoundingIsNone) {
  const auto energy = [&] {
    const DrawList list = compose({Layer::hud});
    const auto text = std::ranges::find_if(
        list.texts, [](const TextShape& t) { return t.text.starts_with("E ="); });
    return text == list.texts.end() ? std::string() : text->text;
  };
  snapshot.energy_start = 0.0;
  snapshot.energy = 3.2e-12;  // J, of cubes of some 10 J
  EXPECT_EQ(energy(), "E = 0.00 J");
  snapshot.energy_start = 100.0;
  snapshot.energy = 100.0 - 1e-7;
  EXPECT_EQ(energy(), "E = 100.0 J");
  snapshot.energy = 99.0;
  EXPECT_EQ(energy(), "E = 99.0 J (−1.00 J)");
}

TEST_F(Composition, TimeAndEnergyNeverMeet) {
  for (const double t : {0.0, 99.5, 100000.0, 1e9}) {
    snapshot.time = t;
    const DrawList list = compose(default_layers);
    const auto energy = std::ranges::find_if(
        list.texts, [](const TextShape& text) { return text.text.starts_with("E ="); });
    if (energy == list.texts.end()) continue;
    const internal::Area time = internal::text_area(*(energy - 1), font);
    EXPECT_LT(time.right + 5.0, energy->baseline.x) << t;
  }
}

TEST_F(Composition, PartsOfTheHudAreDroppedWhereThereIsNoRoom) {
  for (const auto& [width, height] : {std::pair(64, 64), std::pair(100, 16), std::pair(201, 77)}) {
    view = test::literal_view(snapshot, style, options, width, height);
    const DrawList list = compose_frame(snapshot, view, style, options, font);
    EXPECT_TRUE(list.texts.empty()) << width;
    EXPECT_GT(view.pixels_per_metre, 2.0) << "the scene is seen";
  }
}

TEST(Units, HavePrefixesBothWays) {
  using internal::energy_label;
  using internal::with_prefix;
  using internal::Zeros;
  EXPECT_EQ(with_prefix(5e12, "N"), "5 TN");
  EXPECT_EQ(with_prefix(2000.0, "N"), "2 kN");
  EXPECT_EQ(with_prefix(2e-12, "N"), "2 pN");
  EXPECT_EQ(with_prefix(24.83, "N", 3), "24.8 N");
  EXPECT_EQ(with_prefix(243.0, "N", 2), "240 N");
  EXPECT_EQ(with_prefix(0.3, "N", 2), "300 mN");
  EXPECT_EQ(with_prefix(15.0, "N", 3, Zeros::kept), "15.0 N");
  EXPECT_EQ(with_prefix(124.9, "N", 3, Zeros::kept), "125 N");
  EXPECT_EQ(with_prefix(999.9, "N", 3), "1 kN");
  EXPECT_EQ(energy_label(4.905e-9, 0.0), "4.90 nJ");
  EXPECT_EQ(energy_label(7.848e16, 0.0), "78.48 PJ");
  EXPECT_EQ(energy_label(843.7, 843.7), "843.7 J");
  EXPECT_EQ(energy_label(12.0, 843.7), "12.0 J") << "digits stand still";
  EXPECT_EQ(energy_label(0.0, 0.0), "0.00 J");
}

TEST(Units, TimesHaveTheDigitsThatTellFramesApart) {
  using internal::time_label;
  EXPECT_EQ(time_label(1.6, 1.0 / 60.0), "1.600 s");
  EXPECT_EQ(time_label(0.00012, 1e-5), "0.000120 s");
  EXPECT_EQ(time_label(0.00012, 0.0), "0.00012 s") << "a still picture";
  EXPECT_EQ(time_label(2.0, 0.0), "2.000 s");
}

TEST(BodyColors, TellLoadsSpeedsAndIslands) {
  Snapshot snapshot = test::pyramid_snapshot();
  const Style style = make_style(Theme::light);
  const auto loads_of = loads(snapshot);
  EXPECT_DOUBLE_EQ(loads_of[1], 20.0);
  EXPECT_DOUBLE_EQ(loads_of[3], 14.0);
  const auto by_load = body_colors(snapshot, style, {ColorBy::load, 40.0});
  EXPECT_EQ(by_load[1], scale_color(style, 0.5));
  EXPECT_EQ(by_load[8], style.fixed) << "the shelf bears nothing";
  const auto by_speed = body_colors(snapshot, style, {ColorBy::speed, 0.0});
  EXPECT_EQ(by_speed[0], scale_color(style, 0.0));
  EXPECT_EQ(by_speed[6], scale_color(style, 1.0)) << "the fastest";
  const auto by_island = body_colors(snapshot, style, {ColorBy::island, 0.0});
  EXPECT_EQ(by_island[0], by_island[5]);
  EXPECT_EQ(by_island[6], style.palette[6]);
}

TEST_F(Composition, FreeBodiesShowBothForcesOfEachPair) {
  const Snapshot apart = exploded(snapshot, 0.5);
  ASSERT_EQ(apart.forces.size(), 9U + 6U) << "the floor is not cut free";
  EXPECT_EQ(apart.boxes[5].size, snapshot.boxes[5].size);
  const Vec2 foot =
      snapshot.boxes[5].center - 2.0 * (apart.boxes[5].center - snapshot.boxes[5].center);
  EXPECT_NEAR(foot.y(), 0.0, 0.2) << "spread about the foot";
  Vec2 sum = Vec2::Zero();
  for (const SnapshotForce& force : apart.forces)
    sum += force.force;
  EXPECT_NEAR(sum.y(), 50.0, 1e-12) << "what the floor bears";
  options.explode = 0.5;
  const DrawList list = compose({Layer::cubes, Layer::forces});
  EXPECT_EQ(arrows_of(list, style.contact).size(), 15U);
}

TEST_F(Composition, NamesOfPointsStandBesideThem) {
  snapshot.masses.push_back({"bob", Vec2(3.5, 3.0), 1.0});
  const DrawList list = compose({Layer::cubes, Layer::names});
  const auto name = std::ranges::find(list.texts, "bob", &TextShape::text);
  ASSERT_NE(name, list.texts.end());
  const double at = view.to_pixel(snapshot.masses[0].position).x();
  const double aside = std::abs(static_cast<double>(name->baseline.x) - at);
  EXPECT_GT(aside, 3.0) << "not on the disc";
  EXPECT_LT(aside, 60.0);
  const DrawList plain = compose({Layer::cubes});
  EXPECT_EQ(std::ranges::find(plain.texts, "bob", &TextShape::text), plain.texts.end());
}

TEST(Exploded, RodsPinsAndPointsGoWithTheirBodies) {
  Snapshot snapshot;
  snapshot.boxes.resize(2);
  snapshot.boxes[0].name = "a";
  snapshot.boxes[1].name = "b";
  snapshot.boxes[1].center = Vec2(2.0, 0.0);
  snapshot.masses.push_back({"m", Vec2(1.0, 3.0), 1.0});
  const Vec2 pull(0.0, -4.0);
  snapshot.links.push_back({"rod", false, Vec2(0.5, 0.5), Vec2(1.0, 3.0), {"a", "m"}, -pull, 4.0});
  snapshot.links.push_back(
      {"pin", true, Vec2(1.0, 0.0), Vec2(1.0, 0.0), {"a", "b"}, Vec2(1.0, 0.0), 0.0});
  for (const double x : {-0.5, 0.5, 1.5, 2.5}) {
    snapshot.points.push_back({Vec2(x, -0.5), 0.5});
    snapshot.rods.push_back({Vec2(x, -0.5), Vec2(x, 0.5), 0.0});
  }
  const Snapshot apart = exploded(snapshot, 1.0);
  const Vec2 way_a = apart.boxes[0].center - snapshot.boxes[0].center;
  const Vec2 way_b = apart.boxes[1].center - snapshot.boxes[1].center;
  const Vec2 way_m = apart.masses[0].position - snapshot.masses[0].position;
  EXPECT_GT((way_b - way_a).x(), 1.9);
  EXPECT_EQ(apart.links[0].a, snapshot.links[0].a + way_a);
  EXPECT_EQ(apart.links[0].b, snapshot.links[0].b + way_m);
  EXPECT_EQ(apart.links[1].a, snapshot.links[1].a + way_a);
  EXPECT_EQ(apart.links[1].b, snapshot.links[1].b + way_b);
  EXPECT_EQ(apart.points[1].position, snapshot.points[1].position + way_a);
  EXPECT_EQ(apart.points[2].position, snapshot.points[2].position + way_b);
  EXPECT_EQ(apart.rods[3].b, snapshot.rods[3].b + way_b);
  ASSERT_EQ(apart.forces.size(), 4U) << "both of each pair";
  Vec2 sum = Vec2::Zero();
  for (const SnapshotForce& force : apart.forces)
    sum += force.force;
  EXPECT_TRUE(sum.isZero(0.0));
}

TEST_F(Composition, GhostsLieBelowTheBodiesAndOnlyWhereTheyMoved) {
  snapshot.ghosts = {snapshot.boxes[6], snapshot.boxes[0]};
  snapshot.ghosts[0].center.y() += 1.0;
  const DrawList list = compose({Layer::cubes});
  EXPECT_EQ(list.boxes.size(), 2U + 1U + 9U) << "two planes, a ghost, the bodies";
  EXPECT_LT(list.boxes[2].fill.a, 100);
}

TEST_F(Composition, InstanceMasksAreNumbersAndWholePixels) {
  snapshot.boxes.resize(400, snapshot.boxes[1]);
  snapshot.boxes.back().center = Vec2(2.0, 0.5);
  Renderer renderer;
  Image image;
  options.layers = {Layer::instances};
  view = test::literal_view(snapshot, style, options, 320, 180);
  renderer.draw(compose_frame(snapshot, view, style, options, font), image);
  const Vec2 middle = view.to_pixel(Vec2(2.0, 0.5));
  const Color color = image.at(static_cast<int>(middle.x()), static_cast<int>(middle.y()));
  EXPECT_EQ(color.r + 256 * color.g + 65536 * color.b, 400);
  int covered = 0;
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) {
      const Color at = image.at(x, y);
      const int id = at.r + 256 * at.g;
      ASSERT_LE(id, 400);
      covered += id == 400 ? 1 : 0;
    }
  }
  const double side = view.pixels_per_metre;
  EXPECT_NEAR(covered, side * side, 2.0 * side) << "no antialiasing";
}

// As long as the difference of two arrows, and beside the one that is drawn.
TEST_F(Composition, WhiskersReachFromTheLeastForceToTheMost) {
  snapshot = test::failing_snapshot();
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
  snapshot = test::failing_snapshot();
  const DrawList list = compose({Layer::cubes, Layer::contact_forces, Layer::whiskers});
  EXPECT_EQ(std::ranges::count_if(
                list.segments,
                [&](const SegmentShape& s) { return s.color == style.whisker && is_upright(s); }),
            1);
}

}  // namespace
}  // namespace wuerfel
