#include "render/raster/image.h"

#include <gtest/gtest.h>

#include "render/error.h"

namespace wuerfel::test {
namespace {

TEST(Image, OfImpossibleSizesIsAnError) {
  EXPECT_THROW(Image(0, 5), RenderError);
  EXPECT_THROW(Image(5, -1), RenderError);
  EXPECT_THROW(Image(20000, 5), RenderError);
}

TEST(Image, PasteCutsOffWhatLiesOutside) {
  Image target(4, 4, rgb(0x000000));
  const Image source(3, 3, rgb(0xFF0000));
  paste(source, -1, 2, target);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x)
      EXPECT_EQ(target.at(x, y), rgb(x < 2 && y >= 2 ? 0xFF0000 : 0x000000)) << x << ' ' << y;
  }
  paste(source, 9, 9, target);
  paste(source, -9, 0, target);
}

TEST(PixelHash, TellsPixelsAndShapesApart) {
  const Image wide(4, 2);
  const Image high(2, 4);
  EXPECT_NE(pixel_hash(wide), pixel_hash(high));
  Image changed = wide;
  changed.set(3, 1, {255, 255, 254, 255});
  EXPECT_NE(pixel_hash(wide), pixel_hash(changed));
  EXPECT_EQ(pixel_hash(wide), pixel_hash(Image(4, 2)));
}

TEST(PixelHash, IsTheSameNumberOnEveryMachine) {
  // FNV-1a over width, height (little endian) and the bytes, computed independently.
  EXPECT_EQ(pixel_hash(Image(1, 1, {1, 2, 3, 4})), 0xEF73DC3A80C8DA6DU);
}

TEST(Color, MixMeetsBothEnds) {
  constexpr Color a{10, 200, 30, 255};
  constexpr Color b{250, 0, 31, 0};
  EXPECT_EQ(mix(a, b, 0.0), a);
  EXPECT_EQ(mix(a, b, 1.0), b);
  EXPECT_EQ(mix(a, b, 0.5), (Color{130, 100, 31, 128}));
}

}  // namespace
}  // namespace wuerfel::test
