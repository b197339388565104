// Our own compressor, read back by libpng.
#include "render/files/deflate.h"

#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "render/files/huffman.h"
#include "render/files/png.h"
#include "render/files/png_chunks.h"

namespace wuerfel::internal {
namespace {

void expect_round_trip(const Image& image) {
  for (const PngEncoder encoder : {PngEncoder::run_length, PngEncoder::libpng}) {
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

TEST(Deflate, PatchworksComeBackAtManySizes) {
  std::mt19937 random(7);
  for (const int width : {1, 2, 3, 85, 86, 87, 255, 256, 257, 258, 259, 700}) {
    for (const bool opaque : {true, false})
      expect_round_trip(patchwork(random, width, 61, opaque));
  }
}

TEST(Deflate, SinglePixelsAndRowsComeBack) {
  expect_round_trip(Image(1, 1, rgb(0x123456)));
  expect_round_trip(Image(16384, 1, rgb(0x123456)));
  expect_round_trip(Image(1, 3000, {1, 2, 3, 4}));
}

TEST(Deflate, RowsLongerThanTheWindowComeBack) {
  std::mt19937 random(8);
  expect_round_trip(patchwork(random, 12000, 20, true));
  expect_round_trip(Image(16384, 5, {9, 9, 9, 9}));
}

TEST(Deflate, NoiseOfManyBlocksComesBack) {
  std::mt19937 random(9);
  Image image(300, 200);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 300; ++x)
      image.set(x, y, rgb(static_cast<std::uint32_t>(random())));
  }
  expect_round_trip(image);
}

TEST(Deflate, FlatPictureBecomesLessThanAHundredth) {
  std::vector<std::uint8_t> bytes;
  deflate_image(Image(1920, 1080), 3, bytes);
  EXPECT_LT(bytes.size(), 20000U);
}

TEST(Huffman, CodesAreCompleteAndShorterForFrequentSymbols) {
  const std::vector<std::uint32_t> frequencies{50, 0, 20, 20, 5, 4, 1};
  const HuffmanCode code = huffman_code(frequencies, 15);
  double sum = 0.0;
  for (const int length : code.lengths)
    sum += length == 0 ? 0.0 : 1.0 / (1 << length);
  EXPECT_EQ(sum, 1.0) << "Kraft";
  EXPECT_EQ(code.lengths, (std::vector<std::uint8_t>{1, 0, 3, 2, 4, 5, 5}));
}

TEST(Huffman, NoCodeIsLongerThanTheLimit) {
  std::vector<std::uint32_t> fibonacci{1, 1};
  while (fibonacci.size() < 30)
    fibonacci.push_back(fibonacci[fibonacci.size() - 1] + fibonacci[fibonacci.size() - 2]);
  for (const int limit : {7, 9, 15}) {
    double sum = 0.0;
    for (const int length : huffman_code(fibonacci, limit).lengths) {
      EXPECT_LE(length, limit);
      EXPECT_GT(length, 0);
      sum += 1.0 / (1 << length);
    }
    EXPECT_EQ(sum, 1.0);
  }
}

TEST(Huffman, SingleSymbolGetsOneBit) {
  EXPECT_EQ(huffman_code(std::vector<std::uint32_t>{0, 7}, 15).lengths,
            (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(huffman_code(std::vector<std::uint32_t>{0, 0}, 15).lengths,
            (std::vector<std::uint8_t>{0, 0}));
}

}  // namespace
}  // namespace wuerfel::internal
