// What a frame is made of, looked at in the draw list: no pixel is drawn here.
#include "render/picture/compose_frame.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/image_scenes.h"

namespace wuerfel {
namespace {

class Composition : public ::testing::Test {
 protected:
  DrawList compose(Layers layers) {
    options.layers = layers;
    view = testing::literal_view(snapshot, style, options, 640, 360);
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

  Snapshot snapshot = testing::pyramid_snapshot();
  Style style = make_style(Theme::light);
  FrameOptions options = testing::literal_options(default_layers);
  View view;
  Font font;
};

double length(const ArrowShape& arrow) {
  return std::hypot(static_cast<double>(arrow.tip.x - arrow.tail.x),
                    static_cast<double>(arrow.tip.y - arrow.tail.y));
}

TEST_F(Composition, ArrowLengthsAreProportionalToForces) {
  const DrawList list = compose({Layer::forces});
  const auto arrows = arrows_of(list, style.friction);
  ASSERT_EQ(arrows.size(), 2U);
  const double expected = 6.0 * options.force_scale.metres_per_newton * view.pixels_per_metre;
  for (const ArrowShape& arrow : arrows)
    EXPECT_NEAR(length(arrow), expected, 1e-3);
}

TEST_F(Composition, ArrowsAreEquallyThickWhateverTheForce) {
  const auto arrows = arrows_of(compose({Layer::forces}), style.contact);
  ASSERT_EQ(arrows.size(), 14U) << "twelve, two of them with a second head";
  const auto [thinnest, thickest] = std::ranges::minmax(arrows, {}, &ArrowShape::half_width);
  EXPECT_EQ(thinnest.half_width, thickest.half_width);
}

TEST_F(Composition, LongArrowIsCutAndMarkedWithASecondHead) {
  const std::size_t before = arrows_of(compose({Layer::forces}), style.contact).size();
  snapshot.forces.front().force = Vec2(0.0, 1000.0);
  const auto arrows = arrows_of(compose({Layer::forces}), style.contact);
  ASSERT_EQ(arrows.size(), before + 1);
  EXPECT_NEAR(length(arrows[0]), options.force_scale.longest * view.pixels_per_metre, 1e-2);
  EXPECT_LT(length(arrows[1]), length(arrows[0])) << "the second head";
  EXPECT_EQ(arrows[1].tail.x, arrows[0].tail.x);
}

TEST_F(Composition, NegligibleForceIsNotDrawn) {
  const std::size_t before = arrows_of(compose({Layer::forces}), style.contact).size();
  snapshot.forces.front().force = Vec2(0.0, 0.5 * options.force_scale.hidden_below);
  EXPECT_EQ(arrows_of(compose({Layer::forces}), style.contact).size(), before - 1);
}

TEST_F(Composition, NoHaloIsPaintedOverAnArrow) {
  const DrawList list = compose({Layer::cubes, Layer::forces});
  const auto first_arrow =
      std::ranges::find_if(list.arrows, [](const ArrowShape& a) { return a.grow == 0.0F; });
  EXPECT_GT(first_arrow - list.arrows.begin(), 0);
  EXPECT_TRUE(std::all_of(first_arrow, list.arrows.end(),
                          [](const ArrowShape& a) { return a.grow == 0.0F; }));
}

TEST_F(Composition, ArrowsOfNeighboursAtOnePointLieSideBySide) {
  snapshot.forces = {{Vec2(-1.5, 0.0), Vec2(0.0, 8.0), ForceKind::contact, 0},
                     {Vec2(-1.5, 0.0), Vec2(0.0, 8.0), ForceKind::contact, 1}};
  const auto arrows = arrows_of(compose({Layer::forces}), style.contact);
  ASSERT_EQ(arrows.size(), 2U);
  EXPECT_LT(arrows[0].tail.x + arrows[0].half_width, arrows[1].tail.x - arrows[1].half_width);
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
  snapshot = testing::two_cubes_snapshot();
  const DrawList list = compose({Layer::sides});
  ASSERT_EQ(list.triangles.size(), 2U);
  EXPECT_EQ(list.triangles[0].outline, style.positive_side);
  EXPECT_EQ(list.triangles[1].outline, style.negative_side);
  EXPECT_EQ(list.segments.size(), 1U) << "the flat one is a line";
}

TEST_F(Composition, HudStaysInsideThePictureAtEverySize) {
  for (const auto& [width, height] :
       {std::pair(1280, 720), std::pair(320, 180), std::pair(200, 400)}) {
    options.layers = default_layers;
    view = testing::literal_view(snapshot, style, options, width, height);
    const DrawList list = compose_frame(snapshot, view, style, options, font);
    ASSERT_GE(list.texts.size(), 3U);
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
    EXPECT_GT(arrow.tip.y, 60.0F * 0.62F);
    EXPECT_LT(arrow.tip.y, 360.0F - 10.0F);
  }
}

TEST_F(Composition, LegendHasRoundNumbersAndIsAsLongAsItSays) {
  const DrawList list = compose({Layer::forces, Layer::hud});
  EXPECT_TRUE(std::ranges::any_of(
      list.texts, [](const TextShape& text) { return text.text == "5 N contact"; }));
  const auto arrows = arrows_of(list, style.contact);
  const double expected = 5.0 * options.force_scale.metres_per_newton * view.pixels_per_metre;
  EXPECT_TRUE(std::ranges::any_of(arrows, [&](const ArrowShape& arrow) {
    return arrow.tail.y == arrow.tip.y && std::abs(length(arrow) - expected) < 1e-3;
  }));
}

TEST_F(Composition, LinesAndTextGrowWithThePicture) {
  options.layers = default_layers;
  const auto title_size = [&](int width, int height, double scale) {
    options.scale = scale;
    view = testing::literal_view(snapshot, style, options, width, height);
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

}  // namespace
}  // namespace wuerfel
