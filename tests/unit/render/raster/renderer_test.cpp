// Properties of pixels, without stored pictures: colours where the shapes say, nothing elsewhere,
// symmetry.
#include "render/raster/renderer.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "render/picture/compose_frame.h"
#include "render/raster/draw_frame.h"
#include "tests/support/image_scenes.h"

namespace wuerfel::test {
namespace {

Renderer& shared_renderer() {
  static const std::unique_ptr<Renderer> renderer = std::make_unique<Renderer>();
  return *renderer;
}

Image draw(const DrawList& list) {
  Image image;
  shared_renderer().draw(list, image);
  return image;
}

DrawList empty_list(int width = 100, int height = 80) {
  DrawList list;
  list.width = width;
  list.height = height;
  list.background = rgb(0xFFFFFF);
  return list;
}

BoxShape box(float x, float y, float half_width, float half_height) {
  BoxShape shape;
  shape.center = {x, y};
  shape.half_size = {half_width, half_height};
  shape.fill = rgb(0x2060A0);
  shape.outline = rgb(0x000000);
  return shape;
}

/// Sum over all pixels of how far they are from white towards black, in pixels.
double ink(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      sum += 1.0 - brightness(image.at(x, y));
  }
  return sum;
}

TEST(Renderer, SaysWhoDraws) {
  EXPECT_EQ(shared_renderer().description(), "scan-lines");
  EXPECT_TRUE(Renderer(Rasteriser::osmesa).description().starts_with("llvmpipe"));
}

TEST(Renderer, FirstRowIsTheTopAndFirstColumnTheLeft) {
  DrawList list = empty_list();
  list.add(box(10.0F, 5.0F, 10.0F, 5.0F));
  const Image image = draw(list);
  EXPECT_EQ(image.at(0, 0), rgb(0x2060A0));
  EXPECT_EQ(image.at(19, 9), rgb(0x2060A0));
  EXPECT_EQ(image.at(20, 9), rgb(0xFFFFFF));
  EXPECT_EQ(image.at(19, 10), rgb(0xFFFFFF));
}

TEST(Renderer, HalfCoveredPixelIsHalfAsDark) {
  DrawList list = empty_list();
  BoxShape shape = box(20.25F, 20.0F, 10.25F, 10.0F);
  shape.fill = rgb(0x000000);
  list.add(shape);
  EXPECT_NEAR(draw(list).at(30, 20).r, 128, 1);
}

TEST(Renderer, InkOfABoxIsItsArea) {
  for (const double angle : {0.0, 0.3, 0.785398, 1.2}) {
    DrawList list = empty_list();
    BoxShape shape = box(50.3F, 40.6F, 23.0F, 11.5F);
    shape.axis = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
    shape.fill = rgb(0x000000);
    list.add(shape);
    EXPECT_NEAR(ink(draw(list)), 46.0 * 23.0, 3.0) << angle;
  }
}

TEST(Renderer, BoxesNarrowerThanAPixelFadeInsteadOfVanishing) {
  DrawList list = empty_list();
  BoxShape shape = box(50.3F, 40.0F, 30.0F, 0.1F);
  shape.fill = rgb(0x000000);
  list.add(shape);
  EXPECT_NEAR(ink(draw(list)), 60.0 * 0.2, 0.5);
}

TEST(Renderer, OutlineLiesInside) {
  DrawList list = empty_list();
  BoxShape shape = box(40.0F, 40.0F, 20.0F, 20.0F);
  shape.outline_width = 3.0F;
  list.add(shape);
  const Image image = draw(list);
  EXPECT_EQ(image.at(19, 40), rgb(0xFFFFFF));
  for (int x = 20; x < 23; ++x)
    EXPECT_EQ(image.at(x, 40), rgb(0x000000)) << x;
  EXPECT_EQ(image.at(23, 40), rgb(0x2060A0));
}

TEST(Renderer, DiagonalsCrossInTheMiddle) {
  DrawList list = empty_list();
  BoxShape shape = box(40.5F, 40.5F, 20.0F, 20.0F);
  shape.diagonal_width = 2.0F;
  list.add(shape);
  const Image image = draw(list);
  for (const int offset : {-10, 0, 10}) {
    EXPECT_LT(brightness(image.at(40 + offset, 40 + offset)), 0.1);
    EXPECT_LT(brightness(image.at(40 + offset, 40 - offset)), 0.1);
  }
  EXPECT_EQ(image.at(40, 30), rgb(0x2060A0));
}

TEST(Renderer, SegmentHasItsLengthAndWidth) {
  for (const float round : {0.0F, 1.0F}) {
    DrawList list = empty_list();
    list.add(SegmentShape{{20.0F, 20.0F}, {80.0F, 55.0F}, 2.0F, round, rgb(0x000000)});
    const double expected =
        std::hypot(60.0, 35.0) * 4.0 + static_cast<double>(round) * 3.14159 * 4.0;
    EXPECT_NEAR(ink(draw(list)), expected, 3.0);
  }
}

TEST(Renderer, ArrowEndsAtItsTip) {
  DrawList list = empty_list();
  list.add(ArrowShape{{10.5F, 40.5F}, {70.5F, 40.5F}, 1.5F, 12.0F, 5.0F, 0.0F, rgb(0x000000)});
  const Image image = draw(list);
  EXPECT_LT(brightness(image.at(68, 40)), 0.3);
  EXPECT_GT(brightness(image.at(71, 40)), 0.95);
  EXPECT_GT(brightness(image.at(9, 40)), 0.95);
  EXPECT_LT(brightness(image.at(11, 40)), 0.05);
  EXPECT_LT(brightness(image.at(60, 37)), 0.5) << "the head's wing";
  EXPECT_EQ(image.at(40, 36), rgb(0xFFFFFF)) << "beside the shaft";
}

TEST(Renderer, TriangleDoesNotDependOnTheOrderOfItsCorners) {
  TriangleShape shape{
      {10.0F, 10.0F}, {90.0F, 20.0F}, {40.0F, 70.0F}, 2.0F, with_alpha(rgb(0x208040), 0.5), rgb(0)};
  DrawList one = empty_list();
  one.add(shape);
  std::swap(shape.a, shape.b);
  DrawList other = empty_list();
  other.add(shape);
  EXPECT_EQ(draw(one), draw(other));
  EXPECT_EQ(draw(one).at(5, 60), rgb(0xFFFFFF));
}

TEST(Renderer, DiscHasItsArea) {
  DrawList list = empty_list();
  list.add(DiscShape{{50.3F, 40.2F}, 17.0F, 0.0F, rgb(0x000000), rgb(0x000000)});
  EXPECT_NEAR(ink(draw(list)), 3.14159265 * 17.0 * 17.0, 2.0);
}

TEST(Renderer, ArrowOfNoLengthHasNoDirectionAndIsNotDrawn) {
  DrawList list = empty_list();
  list.add(ArrowShape{{40.5F, 40.5F}, {40.5F, 40.5F}, 1.5F, 12.0F, 5.0F, 2.0F, rgb(0x000000)});
  EXPECT_EQ(draw(list), draw(empty_list()));
}

TEST(Renderer, WholePixelsInBetweenAreForgotten) {
  DrawList list = empty_list();
  list.add(box(40.0F, 40.0F, 20.0F, 20.0F));
  DrawList exact = empty_list();
  exact.exact = true;
  exact.add(box(60.0F, 20.0F, 9.0F, 9.0F));
  Image image;
  Renderer renderer;
  renderer.draw(list, image);
  renderer.draw(exact, image);
  renderer.draw(list, image, RowSet());
  EXPECT_EQ(image, draw(list));
}

TEST(Renderer, LaterShapesLieAboveEarlierOnes) {
  DrawList list = empty_list();
  list.add(box(40.0F, 40.0F, 20.0F, 20.0F));
  list.add(DiscShape{{40.0F, 40.0F}, 5.0F, 0.0F, rgb(0xFF0000), rgb(0xFF0000)});
  BoxShape top = box(40.0F, 40.0F, 2.0F, 2.0F);
  top.fill = rgb(0x00FF00);
  list.add(top);
  const Image image = draw(list);
  EXPECT_EQ(image.at(40, 40), rgb(0x00FF00));
  EXPECT_EQ(image.at(43, 40), rgb(0xFF0000));
  EXPECT_EQ(image.at(50, 40), rgb(0x2060A0));
}

TEST(Renderer, TransparentPictureHasStraightAlpha) {
  DrawList list = empty_list();
  list.background = {0, 0, 0, 0};
  BoxShape shape = box(40.25F, 40.0F, 20.25F, 20.0F);
  list.add(shape);
  const Image image = draw(list);
  EXPECT_EQ(image.at(2, 2), (Color{0, 0, 0, 0}));
  EXPECT_EQ(image.at(40, 40), rgb(0x2060A0));
  const Color edge = image.at(60, 40);
  EXPECT_NEAR(edge.a, 128, 1);
  EXPECT_NEAR(edge.g, 0x60, 2) << "not darkened by what is not there";
}

TEST(Renderer, OpaquePictureStaysOpaque) {
  Image image;
  const Snapshot snapshot = pyramid_snapshot();
  const Style style = make_style(Theme::light);
  const FrameOptions options =
      literal_options({Layer::cubes, Layer::sides, Layer::forces, Layer::trails, Layer::rods,
                       Layer::names, Layer::hud});
  draw_frame(shared_renderer(), snapshot, literal_view(snapshot, style, options, 640, 360), style,
             options, image);
  EXPECT_TRUE(image.opaque());
}

class Pyramid : public ::testing::Test {
 protected:
  Image drawn(const View& shown, Layers layers) {
    Image image;
    FrameOptions options = literal_options(layers);
    draw_frame(shared_renderer(), snapshot, shown, style, options, image);
    return image;
  }
  Snapshot snapshot = pyramid_snapshot();
  Style style = make_style(Theme::light);
  View view = fixed_view(Vec2(0.0, 1.5), 10.0, 640, 360);  // 64 px per metre: exact in binary
};

TEST_F(Pyramid, CubesHaveTheirColourAtTheirCentres) {
  const Image image = drawn(view, {Layer::cubes});
  for (const SnapshotBox& body : snapshot.boxes) {
    const Vec2 p = view.to_pixel(body.center);
    EXPECT_EQ(image.at(static_cast<int>(p.x()), static_cast<int>(p.y())), body_color(style, body))
        << body.name;
  }
}

TEST_F(Pyramid, NothingIsDrawnOutsideTheBodies) {
  snapshot.planes.clear();
  const Image image = drawn(view, {Layer::cubes});
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Vec2 world = view.to_world(Vec2(x + 0.5, y + 0.5));
      bool near = false;
      for (const SnapshotBox& body : snapshot.boxes)
        near = near || (world - body.center).norm() < 0.5 * body.size.norm() + 0.02;
      if (!near) {
        ASSERT_EQ(image.at(x, y), style.background) << x << ' ' << y;
      }
    }
  }
}

TEST_F(Pyramid, ArrowTipsAreWhereTheForcesSay) {
  SnapshotJoint joint;
  joint.point = Vec2(2.0, 1.5);
  joint.force = Vec2(0.0, 20.0);
  snapshot.joints = {joint};
  snapshot.impacts.clear();
  const Image image = drawn(view, {Layer::forces});
  const Vec2 tip = view.to_pixel(Vec2(2.0, 1.5));
  int top = image.height();
  for (int y = image.height() - 1; y >= 0; --y) {
    for (int x = 0; x < image.width(); ++x) {
      if (brightness(image.at(x, y)) < 0.6) top = y;
    }
  }
  EXPECT_NEAR(top, tip.y(), 1.5);
}

TEST_F(Pyramid, MovedByWholePixelsIsTheSamePicture) {
  const Layers layers{Layer::cubes};
  snapshot.planes.clear();
  const Image image = drawn(view, layers);
  View moved = view;
  moved.center += Vec2(3.0 / 64.0, -5.0 / 64.0);
  const Image shifted = drawn(moved, layers);
  for (int y = 0; y + 5 < image.height(); ++y) {
    for (int x = 3; x < image.width(); ++x)
      ASSERT_EQ(image.at(x, y + 5), shifted.at(x - 3, y)) << x << ' ' << y;
  }
}

TEST_F(Pyramid, MirroredSceneIsTheMirroredPicture) {
  snapshot.planes.clear();
  const Image image = drawn(view, {Layer::cubes});
  for (SnapshotBox& body : snapshot.boxes) {
    body.center.x() = -body.center.x();
    body.angle = -body.angle;
  }
  const Image mirrored = drawn(view, {Layer::cubes});
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Color a = image.at(x, y);
      const Color b = mirrored.at(image.width() - 1 - x, y);
      ASSERT_LE(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b), 6)
          << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace wuerfel::test
