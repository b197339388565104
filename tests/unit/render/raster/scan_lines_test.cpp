// Our own rasteriser and OpenGL's shaders draw the same pictures: no channel differs by more than rounding
// and what half a hundredth of a pixel of distance makes.
#include "render/raster/scan_lines.h"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "render/picture/compose_frame.h"
#include "render/raster/compare.h"
#include "render/raster/renderer.h"
#include "tests/support/image_scenes.h"
#include "tests/support/random_shapes.h"

namespace wuerfel::internal {
namespace {

class BothRasterisers : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { osmesa = std::make_unique<Renderer>(Rasteriser::osmesa); }
  static void TearDownTestSuite() { osmesa.reset(); }

  static void draw_and_compare(const DrawList& list, const std::string& what) {
    Image own;
    Renderer().draw(list, own);
    Image other;
    osmesa->draw(list, other);
    const Comparison difference = compare_images(own, other);
    EXPECT_LE(difference.largest_difference, 3) << what << ": " << describe(difference);
  }

  // A context is made once for all tests. NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
  static inline std::unique_ptr<Renderer> osmesa;
};

TEST_F(BothRasterisers, DrawTheSameFrames) {
  Font font;
  for (const Theme theme : {Theme::light, Theme::dark, Theme::print}) {
    const Style style = make_style(theme);
    const FrameOptions options = test::literal_options(
        {Layer::cubes, Layer::rods, Layer::points, Layer::sides, Layer::forces, Layer::velocities,
         Layer::contacts, Layer::weights, Layer::names, Layer::grid, Layer::hud});
    const Snapshot snapshot = test::pyramid_snapshot();
    const View view = test::literal_view(snapshot, style, options, 640, 360);
    draw_and_compare(compose_frame(snapshot, view, style, options, font),
                     std::string(to_string(theme)));
  }
}

TEST_F(BothRasterisers, DrawTheSameShapesOfEveryKind) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    DrawList list;
    list.width = 200;
    list.height = 120;
    list.background = rgb(0xFFFFFF);
    test::RandomShapes(seed).add_some(list);
    draw_and_compare(list, "seed " + std::to_string(seed));
  }
}

DrawList opaque_list() {
  DrawList list;
  list.width = 60;
  list.height = 40;
  list.background = rgb(0xFFFFFF);
  return list;
}

Image drawn(const DrawList& list) {
  Image image(list.width, list.height);
  draw_scan_lines(list, {0, list.height}, image);
  return image;
}

TEST(ScanLines, DrawNothingOfWhatIsNoNumberOrEndless) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float endless = std::numeric_limits<float>::infinity();
  const Image empty = drawn(opaque_list());
  for (const float bad : {nan, endless, -endless}) {
    DrawList list = opaque_list();
    list.add(BoxShape{{bad, 5.0F}, {1.0F, 0.0F}, {5.0F, 5.0F}, 1.0F, 0.0F, rgb(0), rgb(0)});
    list.add(SegmentShape{{5.0F, bad}, {9.0F, 9.0F}, 1.0F, 1.0F, rgb(0)});
    list.add(ArrowShape{{5.0F, 5.0F}, {bad, 9.0F}, 1.0F, 8.0F, 4.0F, 0.0F, rgb(0)});
    list.add(DiscShape{{bad, bad}, 4.0F, 0.0F, rgb(0), rgb(0)});
    list.add(TriangleShape{{1.0F, 1.0F}, {9.0F, 1.0F}, {5.0F, bad}, 0.0F, rgb(0), rgb(0)});
    EXPECT_EQ(drawn(list), empty) << bad;
  }
}

TEST(ScanLines, FillThePictureWithWhatIsFarLarger) {
  DrawList list = opaque_list();
  list.add(BoxShape{{1e7F, 0.0F}, {0.6F, 0.8F}, {2e7F, 2e7F}, 2.0F, 0.0F, rgb(0x123456), rgb(0)});
  EXPECT_EQ(drawn(list), Image(60, 40, rgb(0x123456)));
}

TEST(ScanLines, SurviveShapesWithoutExtent) {
  DrawList list = opaque_list();
  list.add(BoxShape{{9.0F, 9.0F}, {1.0F, 0.0F}, {0.0F, 0.0F}, 1.0F, 1.0F, rgb(0), rgb(0)});
  list.add(SegmentShape{{9.0F, 9.0F}, {9.0F, 9.0F}, 0.0F, 0.0F, rgb(0)});
  list.add(ArrowShape{{9.0F, 9.0F}, {9.0F, 9.0F}, 0.0F, 0.0F, 0.0F, 0.0F, rgb(0)});
  list.add(DiscShape{{9.0F, 9.0F}, 0.0F, 0.0F, {0, 0, 0, 0}, {0, 0, 0, 0}});
  list.add(TriangleShape{{9.0F, 9.0F}, {9.0F, 9.0F}, {9.0F, 9.0F}, 1.0F, rgb(0), rgb(0)});
  const Image image = drawn(list);
  EXPECT_TRUE(image.opaque());
  EXPECT_EQ(image.at(20, 20), rgb(0xFFFFFF));
}

TEST(ScanLines, DrawRowsAndColumnsAsTheyDrawThePicture) {
  DrawList list = opaque_list();
  test::RandomShapes(7).add_some(list);
  const Image whole = drawn(list);
  Image parts(list.width, list.height);
  for (const auto& [begin, end] : {std::pair{0, 13}, {13, 14}, {14, 40}}) {
    draw_scan_lines(list, {begin, end, 0, 21}, parts);
    draw_scan_lines(list, {begin, end, 21, 60}, parts);
  }
  EXPECT_EQ(parts, whole);
}

TEST(ScanLines, BlendEachChannelExactly) {
  for (int alpha = 0; alpha <= 255; alpha += 5) {
    for (int below = 0; below <= 255; below += 3) {
      DrawList list = opaque_list();
      const auto ground = static_cast<std::uint8_t>(below);
      list.background = {ground, 0, 255, 255};
      const Color fill{200, 17, 3, static_cast<std::uint8_t>(alpha)};
      list.add(BoxShape{{30.0F, 20.0F}, {1.0F, 0.0F}, {9.0F, 9.0F}, 0.0F, 0.0F, fill, fill});
      const double share = alpha / 255.0;
      const Color mixed = drawn(list).at(30, 20);
      ASSERT_NEAR(mixed.r, 200.0 * share + below * (1.0 - share), 1.0);
      ASSERT_NEAR(mixed.g, 17.0 * share, 1.0);
      ASSERT_NEAR(mixed.b, 3.0 * share + 255.0 * (1.0 - share), 1.0);
      ASSERT_EQ(mixed.a, 255);
    }
  }
}

}  // namespace
}  // namespace wuerfel::internal
