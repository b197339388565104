#include "render/raster/text.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace wuerfel::internal {
namespace {

std::vector<char32_t> code_points(std::string_view text) {
  std::vector<char32_t> points;
  for (std::size_t at = 0; at < text.size();)
    points.push_back(next_code_point(text, at));
  return points;
}

/// Dark pixels of a text on white.
int ink(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      count += image.at(x, y).r < 128 ? 1 : 0;
  }
  return count;
}

Image written(const std::string& text, float x, float y) {
  Font font;
  Image image(120, 40);
  TextShape shape;
  shape.text = text;
  shape.baseline = {x, y};
  shape.size = 20.0F;
  blend_text(shape, {0, image.height()}, font, image);
  return image;
}

TEST(CodePoints, AreReadFromUtf8) {
  EXPECT_EQ(code_points("aü立😀"), (std::vector<char32_t>{U'a', U'ü', U'立', U'😀'}));
}

TEST(CodePoints, OfBrokenUtf8AreReplacedAndReadingGoesOn) {
  EXPECT_EQ(code_points("a\xFF"), (std::vector<char32_t>{U'a', 0xFFFD}));
  EXPECT_EQ(code_points("\xC3"), (std::vector<char32_t>{0xFFFD}));
  EXPECT_EQ(code_points("\xE7z"), (std::vector<char32_t>{0xFFFD, U'z'}));
  EXPECT_EQ(code_points("\xC0\x80").front(), char32_t{0xFFFD});
}

TEST(Font, WidthGrowsWithTextAndSize) {
  Font font;
  EXPECT_EQ(font.width("", 20.0), 0.0);
  EXPECT_NEAR(font.width("Würfel", 40.0), 2.0 * font.width("Würfel", 20.0), 0.2);
  EXPECT_NEAR(font.width("1111", 14.0), font.width("8888", 14.0), 1e-9)
      << "digits are equally wide";
}

TEST(Font, HasUmlautsAndGreek) {
  Font font;
  for (const char32_t letter : {U'ü', U'ß', U'Ä', U'µ', U'…', U'–'}) {
    EXPECT_NE(font.glyph(letter, 20.0, 0, 0.0).coverage, font.glyph(0xE123, 20.0, 0, 0.0).coverage)
        << static_cast<unsigned>(letter);
  }
}

TEST(Text, StandsOnItsBaseline) {
  const Image image = written("H", 10.0F, 30.0F);
  EXPECT_GT(ink(image), 20);
  for (int y = 30; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      EXPECT_EQ(image.at(x, y), rgb(0xFFFFFF)) << x << ' ' << y;
  }
}

TEST(Text, OutsideThePictureIsCutOff) {
  EXPECT_EQ(ink(written("Würfel", -500.0F, 20.0F)), 0);
  EXPECT_EQ(ink(written("Würfel", 20.0F, -50.0F)), 0);
  EXPECT_GT(ink(written("Würfel", -10.0F, 5.0F)), 0);
  EXPECT_GT(ink(written("Würfel", 100.0F, 45.0F)), 0);
}

TEST(Text, HaloSurroundsTheLetters) {
  Font font;
  Image image(60, 40, rgb(0x000000));
  TextShape shape;
  shape.text = "I";
  shape.baseline = {25.0F, 30.0F};
  shape.size = 20.0F;
  shape.color = rgb(0x000000);
  shape.halo = rgb(0xFFFFFF);
  shape.halo_width = 3.0F;
  blend_text(shape, {0, image.height()}, font, image);
  const int white = 60 * 40 - ink(image);
  EXPECT_GT(white, 60);
  EXPECT_LT(white, 300);
}

}  // namespace
}  // namespace wuerfel::internal
