// Both compressors, read back by libpng.
#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "render/files/png.h"

namespace wuerfel::test {
namespace {

constexpr std::array encoders{PngEncoder::isa_l, PngEncoder::libpng};

void expect_round_trip(const Image& image) {
  for (const PngEncoder encoder : encoders) {
    ASSERT_EQ(decode_png(encode_png(image, {}, encoder)).image, image);
  }
}

/// Runs, repeated rows, gradients and noise in random places: what makes every kind of token.
Image patchwork(std::mt19937& random, int width, int height, bool opaque) {
  Image image(width, height);
  const auto byte = [&random] { return static_cast<std::uint8_t>(random()); };
  for (int patch = 0; patch < 12; ++patch) {
    const int left = static_cast<int>(random() % static_cast<unsigned>(width));
    const int top = static_cast<int>(random() % static_cast<unsigned>(height));
    const int right = std::min(width, left + static_cast<int>(random() % 400));
    const int bottom = std::min(height, top + static_cast<int>(random() % 40));
    const bool noise = random() % 4 == 0;
    const Color flat{byte(), byte(), byte(), opaque ? std::uint8_t{255} : byte()};
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        image.set(
            x, y,
            noise ? Color{byte(), byte(), byte(), opaque ? std::uint8_t{255} : byte()} : flat);
      }
    }
  }
  return image;
}

TEST(ImageCompressor, GivesPatchworksBackAtManySizes) {
  std::mt19937 random(7);
  for (const int width : {1, 2, 3, 85, 86, 87, 255, 256, 257, 258, 259, 700}) {
    for (const bool opaque : {true, false})
      expect_round_trip(patchwork(random, width, 61, opaque));
  }
}

TEST(ImageCompressor, GivesSinglePixelsAndRowsBack) {
  expect_round_trip(Image(1, 1, rgb(0x123456)));
  expect_round_trip(Image(16384, 1, rgb(0x123456)));
  expect_round_trip(Image(1, 3000, {1, 2, 3, 4}));
}

TEST(ImageCompressor, GivesRowsBackThatAreLongerThanTheWindow) {
  std::mt19937 random(8);
  expect_round_trip(patchwork(random, 12000, 20, true));
  expect_round_trip(Image(16384, 5, {9, 9, 9, 9}));
}

TEST(ImageCompressor, GivesNoiseOfManyBlocksBack) {
  std::mt19937 random(9);
  Image image(300, 200);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 300; ++x)
      image.set(x, y, rgb(static_cast<std::uint32_t>(random())));
  }
  expect_round_trip(image);
}

TEST(ImageCompressor, MakesLessThanASeventiethOfAFlatPicture) {
  for (const PngEncoder encoder : encoders) {
    CompressedImage compressed;
    ImageCompressor(encoder).compress(Image(1920, 1080), PngChannels::rgb, compressed);
    EXPECT_LT(compressed.stream.size(), 1920U * 1080U * 3U / 70U) << to_string(encoder);
  }
}

TEST(ImageCompressor, PacksOnlyChangedRowsToTheSameStream) {
  std::mt19937 random(11);
  Image image = patchwork(random, 700, 600, true);
  ImageCompressor compressor;
  CompressedImage compressed;
  compressor.compress(image, PngChannels::rgb, compressed);
  for (const auto& [begin, end] : {std::pair{0, 1}, {599, 600}, {250, 310}, {0, 600}}) {
    for (int y = begin; y < end; ++y)
      image.set(y % 700, y, {static_cast<std::uint8_t>(random()), 7, 9, 255});
    compressor.compress(image, PngChannels::rgb, compressed, RowRange{begin, end});
    CompressedImage fresh;
    ImageCompressor().compress(image, PngChannels::rgb, fresh);
    EXPECT_EQ(compressed.stream, fresh.stream) << begin;
  }
}

TEST(ImageCompressor, PacksOnlyChangedColumnsToTheSameStream) {
  std::mt19937 random(12);
  for (const PngChannels channels : {PngChannels::rgb, PngChannels::rgba}) {
    Image image = patchwork(random, 70, 60, true);
    ImageCompressor compressor;
    CompressedImage compressed;
    compressor.compress(image, channels, compressed);
    for (int width = 1; width < 20; ++width) {
      const int left = static_cast<int>(random() % (70U - static_cast<unsigned>(width)));
      for (int x = left; x < left + width; ++x)
        image.set(x, 30, {static_cast<std::uint8_t>(random()), 7, 9, 255});
      compressor.compress(image, channels, compressed, RowRange{29, 32, left, left + width});
      CompressedImage fresh;
      ImageCompressor().compress(image, channels, fresh);
      ASSERT_EQ(compressed.stream, fresh.stream) << left << ' ' << width;
    }
  }
}

TEST(ImageCompressor, RemembersNothingOfThePictureBefore) {
  std::mt19937 random(10);
  const Image first = patchwork(random, 300, 200, true);
  const Image second = patchwork(random, 640, 100, false);
  for (const PngEncoder encoder : encoders) {
    CompressedImage fresh;
    ImageCompressor(encoder).compress(second, PngChannels::automatic, fresh);
    ImageCompressor compressor(encoder);
    CompressedImage again;
    compressor.compress(first, PngChannels::automatic, again);
    compressor.compress(second, PngChannels::automatic, again);
    EXPECT_EQ(again.stream, fresh.stream) << to_string(encoder);
    EXPECT_EQ(again.check_sum, fresh.check_sum);
    EXPECT_EQ(again.alpha, fresh.alpha);
  }
}

}  // namespace
}  // namespace wuerfel::test
