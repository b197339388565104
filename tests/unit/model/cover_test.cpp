// What fixed boxes cover of one another.
#include "core/model/cover.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

// Sides: 0 bottom, 1 right, 2 top, 3 left; alpha runs clockwise, from p_i to p_j.
constexpr int right = 1;
constexpr int top = 2;

/// Eq. (5)'s alpha on the right side of a tile of height 1, `below` its top.
double edge_share(double below) {
  // Corners 1 (low) and 2 (high) are p_j and p_i: alpha grows downwards.
  return below;
}

Box tile(double x, double y, double height = 1.0) {
  return make_box({x, y - 0.5 * height}, 0.0, {2.0, height});
}

Cover cover_of(const Box& box, const Box& other) {
  Cover cover;
  add_cover(box, other, cover);
  return cover;
}

TEST(Cover, OfFlushTilesTheSidesOfTheSeamAndItsCornersAreCovered) {
  const Cover cover = cover_of(tile(0.0, 0.0), tile(2.0, 0.0));
  for (const double alpha : {0.0, 0.5, 1.0})
    EXPECT_TRUE(cover.covers(right, alpha)) << alpha;
  EXPECT_FALSE(cover.covers(top, 0.5));
  EXPECT_TRUE(cover.covers_corner(1));
  EXPECT_TRUE(cover.covers_corner(2));
  EXPECT_FALSE(cover.covers_corner(0));
  EXPECT_FALSE(cover.covers_corner(3));
}

TEST(Cover, WhatStandsOutAboveALowerTileIsFree) {
  //   +---+
  //   |   |---+
  //   +---+---+
  const Cover cover = cover_of(tile(0.0, 0.0), tile(2.0, -0.25, 0.75));
  EXPECT_FALSE(cover.covers_corner(2));
  EXPECT_TRUE(cover.covers_corner(1));
  EXPECT_FALSE(cover.covers(right, edge_share(0.1)));
  EXPECT_TRUE(cover.covers(right, edge_share(0.6)));
}

TEST(Cover, TilesThatOverlapWithTheirTopsAtOneHeightLeaveNoHole) {
  const Cover cover = cover_of(tile(0.0, 0.0), tile(1.5, 0.0));
  for (const double alpha : {0.0, 0.2, 0.5, 0.8, 1.0})
    EXPECT_FALSE(cover.covers(top, alpha)) << alpha;
}

TEST(Cover, ABoxOnAPlaneIsCoveredFromBelow) {
  Cover cover;
  add_cover(tile(0.0, 1.0), Vec2::Zero(), Vec2::UnitY(), cover);
  EXPECT_TRUE(cover.covers(0, 0.5));
  EXPECT_FALSE(cover.covers(right, 0.5));
  EXPECT_FALSE(cover.covers(top, 0.5));
}

}  // namespace
}  // namespace wuerfel::test
