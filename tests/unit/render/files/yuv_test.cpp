#include "render/files/yuv.h"

#include <cmath>

#include <gtest/gtest.h>

namespace wuerfel::internal {
namespace {

struct Yuv {
  int y;
  int u;
  int v;
};

/// The definition of ITU-R BT.709 in floating point.
Yuv reference(Color color) {
  const double r = color.r / 255.0;
  const double g = color.g / 255.0;
  const double b = color.b / 255.0;
  const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  return {static_cast<int>(std::lround(16.0 + 219.0 * y)),
          static_cast<int>(std::lround(128.0 + 224.0 * (b - y) / 1.8556)),
          static_cast<int>(std::lround(128.0 + 224.0 * (r - y) / 1.5748))};
}

TEST(Yuv, FollowsTheDefinitionForAllCornersAndMixtures) {
  for (int r = 0; r < 256; r += 15) {
    for (int g = 0; g < 256; g += 15) {
      for (int b = 0; b < 256; b += 15) {
        const Color color{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                          static_cast<std::uint8_t>(b), 255};
        std::vector<std::uint8_t> planes;
        append_yuv420(Image(2, 2, color), planes);
        const Yuv expected = reference(color);
        EXPECT_NEAR(planes[0], expected.y, 1);
        EXPECT_NEAR(planes[4], expected.u, 1);
        EXPECT_NEAR(planes[5], expected.v, 1);
      }
    }
  }
}

TEST(Yuv, GreyHasNoColour) {
  for (int level = 0; level < 256; ++level) {
    const auto byte = static_cast<std::uint8_t>(level);
    std::vector<std::uint8_t> planes;
    append_yuv420(Image(2, 2, {byte, byte, byte, 255}), planes);
    EXPECT_EQ(planes[4], 128) << level;
    EXPECT_EQ(planes[5], 128) << level;
  }
}

TEST(Yuv, RowsThatRepeatAreConvertedLikeAnyOther) {
  // Groups of 1 to 6 equal rows, so that they begin at even and at odd ones.
  constexpr int width = 4;
  constexpr int height = 42;
  Image image(width, height);
  for (int y = 0, group = 0, left = 0; y < height; ++y, --left) {
    if (left == 0) left = 1 + ++group % 6;
    for (int x = 0; x < width; ++x)
      image.set(x, y, rgb(static_cast<std::uint32_t>(group * 0x1A2B3C + x * 0x410203)));
  }
  std::vector<std::uint8_t> planes;
  append_yuv420(image, planes);
  for (int y = 0; y < height; y += 2) {
    Image two(width, 2);
    paste(image, 0, -y, two);
    std::vector<std::uint8_t> expected;
    append_yuv420(two, expected);
    const auto part = [&planes](std::size_t from, std::size_t count) {
      const auto begin = planes.begin() + static_cast<std::ptrdiff_t>(from);
      return std::vector<std::uint8_t>(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    const auto row = static_cast<std::size_t>(y);
    std::vector<std::uint8_t> actual = part(width * row, 2 * width);
    for (const std::size_t plane : {width * height, width * height * 5 / 4}) {
      const auto chroma = part(plane + row / 2 * (width / 2), width / 2);
      actual.insert(actual.end(), chroma.begin(), chroma.end());
    }
    EXPECT_EQ(actual, expected) << y;
  }
}

TEST(Yuv, OddSizesRepeatTheLastRowAndColumn) {
  Image image(3, 3, rgb(0x000000));
  for (int i = 0; i < 3; ++i) {
    image.set(2, i, rgb(0xFFFFFF));
    image.set(i, 2, rgb(0xFFFFFF));
  }
  std::vector<std::uint8_t> planes;
  append_yuv420(image, planes);
  ASSERT_EQ(planes.size(), 4U * 4U * 3U / 2U);
  EXPECT_EQ(planes[0], 16);
  EXPECT_EQ(planes[3], 235) << "right of the last column";
  EXPECT_EQ(planes[12], 235) << "below the last row";
}

TEST(Yuv, FramesAreAppended) {
  std::vector<std::uint8_t> planes{1, 2, 3};
  append_yuv420(Image(4, 2), planes);
  EXPECT_EQ(planes.size(), 3U + 12U);
  EXPECT_EQ(planes[0], 1);
}

}  // namespace
}  // namespace wuerfel::internal
