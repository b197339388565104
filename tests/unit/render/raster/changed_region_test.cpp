// A picture drawn after another one is the picture drawn alone, to the pixel.
#include "render/raster/changed_region.h"

#include <array>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "render/picture/compose_frame.h"
#include "render/raster/renderer.h"
#include "tests/support/image_scenes.h"
#include "tests/support/random_shapes.h"

namespace wuerfel::internal {
namespace {

class InChanges : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    changing = std::make_unique<Renderer>();
    fresh = std::make_unique<Renderer>();
  }
  static void TearDownTestSuite() {
    changing.reset();
    fresh.reset();
  }

  /// Draws with the renderer that knows the picture before, into an image that shows an older one,
  /// compares with one that was made to forget it, and what is said to be unchanged with the picture
  /// before.
  static void draw_and_compare(const DrawList& list) {
    std::swap(images[0], images[1]);
    std::swap(stale[0], stale[1]);
    Image& image = images[0];
    const RowSet changed = changing->draw(list, image, stale[0]);
    stale[0] = RowSet();
    if (stale[1]) stale[1]->add(changed);
    Image alone;
    DrawList other;
    other.width = list.width;
    other.height = list.height;
    other.background = {1, 2, 3, 255};
    fresh->draw(other, alone);
    fresh->draw(list, alone);
    ASSERT_EQ(image, alone);
    Image unchanged = image;
    if (before.width() != image.width() || before.height() != image.height()) before = image;
    for (const RowRange& rows : changed.ranges()) {
      for (int y = rows.begin; y < rows.end; ++y) {
        for (int x = rows.left; x < std::min(rows.right, image.width()); ++x)
          unchanged.set(x, y, before.at(x, y));
      }
    }
    ASSERT_EQ(unchanged, before);
    before = image;
  }

  // Contexts are made once for all tests. NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
  static inline std::unique_ptr<Renderer> changing;
  static inline std::unique_ptr<Renderer> fresh;
  static inline Image before;
  static inline std::array<Image, 2> images;
  static inline std::array<std::optional<RowSet>, 2> stale;
  // NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)
};

TEST_F(InChanges, FramesOfAFilmAreAsIfDrawnAlone) {
  Font font;
  for (const Theme theme : {Theme::light, Theme::dark, Theme::print, Theme::transparent}) {
    const Style style = make_style(theme);
    const FrameOptions options =
        test::literal_options({Layer::cubes, Layer::rods, Layer::forces, Layer::velocities,
                               Layer::contacts, Layer::names, Layer::hud});
    Snapshot snapshot = test::pyramid_snapshot();
    const View view = test::literal_view(snapshot, style, options, 320, 180);
    for (int i = 0; i < 12; ++i) {
      snapshot.boxes[6].center += Vec2(0.013, -0.02);
      snapshot.boxes[6].angle += 0.05;
      snapshot.time += 0.01;
      if (i % 3 == 2) snapshot.joints.pop_back();
      draw_and_compare(compose_frame(snapshot, view, style, options, font));
    }
  }
}

TEST_F(InChanges, ShapesOfEveryKindThatMoveAppearAndVanishAreAsIfDrawnAlone) {
  test::RandomShapes shapes(5);
  DrawList list;
  list.width = 200;
  list.height = 120;
  list.background = rgb(0xFFFFFF);
  shapes.add_some(list);
  for (int i = 0; i < 60; ++i) {
    switch (i % 5) {
      case 0:
        list.boxes[i % list.boxes.size()].center = shapes.place();
        break;
      case 1:
        list.arrows[i % list.arrows.size()].tip = shapes.place();
        break;
      case 2:
        list.discs[i % list.discs.size()].center = shapes.place();
        break;
      case 3:
        list.triangles[i % list.triangles.size()].a = shapes.place();
        break;
      default:
        list.segments[i % list.segments.size()].to = shapes.place();
    }
    if (i % 20 == 19) {
      DrawList fewer = list;
      fewer.runs.resize(fewer.runs.size() / 2);
      draw_and_compare(fewer);
    }
    draw_and_compare(list);
  }
}

TEST_F(InChanges, AnEqualListChangesNoMoreThanAPixel) {
  test::RandomShapes shapes(6);
  DrawList list;
  list.width = 200;
  list.height = 120;
  shapes.add_some(list);
  EXPECT_EQ(changed_region(list, list), (Region{0, 0, 1, 1}));
}

TEST_F(InChanges, AMovedShapeChangesItsPlacesAndLittleAround) {
  DrawList before_move;
  before_move.width = 200;
  before_move.height = 120;
  before_move.add(BoxShape{{100.0F, 60.0F}, {1.0F, 0.0F}, {50.0F, 50.0F}, 1.0F, 0.0F, {}, {}});
  before_move.add(DiscShape{{20.0F, 20.0F}, 5.0F, 0.0F, {}, {}});
  DrawList after_move = before_move;
  after_move.discs[0].center = {30.0F, 20.0F};
  const Region region = changed_region(before_move, after_move);
  EXPECT_LE(region.left, 14);
  EXPECT_GE(region.left, 11);
  EXPECT_GE(region.right, 36);
  EXPECT_LE(region.right, 39);
}

}  // namespace
}  // namespace wuerfel::internal
