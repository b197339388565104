#include "render/raster/compare.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

constexpr Color grey = rgb(0x808080);

TEST(Compare, EqualPicturesAreIdentical) {
  EXPECT_EQ(compare_images(Image(9, 7, grey), Image(9, 7, grey)).verdict,
            CompareVerdict::identical);
}

TEST(Compare, FewSmallDifferencesAreNearEnough) {
  Image actual(20, 20, grey);
  actual.set(3, 4, rgb(0x848080));
  const Comparison comparison = compare_images(Image(20, 20, grey), actual);
  EXPECT_EQ(comparison.verdict, CompareVerdict::near_enough);
  EXPECT_EQ(comparison.changed, 1);
  EXPECT_EQ(comparison.largest_difference, 4);
}

TEST(Compare, OneDifferenceBeyondTheLimitIsDifferent) {
  Image actual(20, 20, grey);
  actual.set(3, 4, rgb(0x808580));
  const Comparison comparison = compare_images(Image(20, 20, grey), actual);
  EXPECT_EQ(comparison.verdict, CompareVerdict::different);
  EXPECT_EQ(comparison.worst_x, 3);
  EXPECT_EQ(comparison.worst_y, 4);
}

TEST(Compare, ManySmallDifferencesAreDifferent) {
  EXPECT_EQ(compare_images(Image(20, 20, grey), Image(20, 20, rgb(0x818080))).verdict,
            CompareVerdict::different);
}

TEST(Compare, LimitsCanBeSet) {
  const Image actual(20, 20, rgb(0x818080));
  EXPECT_EQ(compare_images(Image(20, 20, grey), actual, {1, 1.0}).verdict,
            CompareVerdict::near_enough);
  EXPECT_EQ(compare_images(Image(20, 20, grey), actual, {0, 1.0}).verdict,
            CompareVerdict::different);
}

TEST(Compare, NamesTheRectangleAroundAllDifferences) {
  Image actual(20, 20, grey);
  actual.set(3, 9, rgb(0x000000));
  actual.set(11, 4, rgb(0xFFFFFF));
  const Comparison comparison = compare_images(Image(20, 20, grey), actual);
  EXPECT_EQ(describe(comparison),
            "different: 2 pixels (0.5 %), largest difference 128 at (3, 9), within 9x6+3+4");
}

TEST(Compare, OtherSizesAreDifferent) {
  const Comparison comparison = compare_images(Image(20, 20, grey), Image(21, 20, grey));
  EXPECT_EQ(comparison.verdict, CompareVerdict::different);
  EXPECT_FALSE(comparison.same_size);
  EXPECT_EQ(comparison.changed, 20);
}

TEST(Compare, InvisibleColoursDoNotCount) {
  EXPECT_EQ(compare_images(Image(5, 5, {255, 0, 0, 0}), Image(5, 5, {0, 255, 0, 0})).verdict,
            CompareVerdict::identical);
  EXPECT_EQ(compare_images(Image(5, 5, {0, 0, 0, 0}), Image(5, 5, {0, 0, 0, 9})).verdict,
            CompareVerdict::different);
}

TEST(DifferencePicture, ShowsSmallDifferencesYellowAndLargeOnesRed) {
  Image actual(20, 20, grey);
  actual.set(1, 1, rgb(0x818080));
  actual.set(2, 2, rgb(0xFF8080));
  const Image picture = difference_picture(Image(20, 20, grey), actual);
  EXPECT_EQ(picture.at(1, 1), rgb(0xFAC800));
  EXPECT_EQ(picture.at(2, 2), rgb(0xDC1428));
  EXPECT_GT(brightness(picture.at(3, 3)), 0.8);
}

TEST(SideBySide, HoldsBothPicturesAndTheirDifference) {
  const Image expected(20, 10, rgb(0x112233));
  const Image actual(20, 10, rgb(0x445566));
  Font font;
  const Image sheet = side_by_side(expected, actual, {}, font);
  EXPECT_EQ(sheet.width(), 3 * 20 + 4 * 12);
  EXPECT_EQ(sheet.at(12, 26), rgb(0x112233));
  EXPECT_EQ(sheet.at(12 + 20 + 12, 26), rgb(0x445566));
  EXPECT_EQ(sheet.at(12 + 2 * 32, 26), rgb(0xDC1428));
}

}  // namespace
}  // namespace wuerfel::test
