// Bounds along the axes of the world.
#include "core/geometry/bounds.h"

#include <cmath>

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

TEST(Bounds, HoldTheirBoxes) {
  const Box a = make_box({1.0, 2.0}, 0.4, {2.0, 0.5});
  const Box b = make_box({3.0, 1.0}, 1.4, {2.0, 0.5});
  const BoundingBox swept = swept_bounds(a, b, 0.1);
  for (const Box& box : {a, b}) {
    const BoundingBox posed = posed_bounds(box, 0.1);
    for (int k = 0; k < Box::corners; ++k) {
      const BoundingBox corner{box.corner(k), box.corner(k)};
      EXPECT_TRUE(posed.overlaps(corner));
    }
    EXPECT_TRUE((swept.low.array() <= posed.low.array()).all());
    EXPECT_TRUE((swept.high.array() >= posed.high.array()).all());
  }
  const BoundingBox way = predicted_bounds({0.0, 1.0}, {2.0, -1.0}, {0.5, 0.25});
  EXPECT_EQ(way.low, Vec2(-0.5, -1.25));
  EXPECT_EQ(way.high, Vec2(2.5, 1.25));
}

TEST(Bounds, OfATurnedBoxAreThoseOfItsCorners) {
  // Turned by the angle whose cosine is 3/5: half extents 1.5 * 3/5 + 0.5 * 4/5 and 1.5 * 4/5 + 0.5 * 3/5.
  const BoundingBox bounds = posed_bounds(make_box({1.0, 2.0}, std::acos(0.6), {3.0, 1.0}), 0.0);
  EXPECT_NEAR((bounds.low - Vec2(1.0 - 1.3, 2.0 - 1.5)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((bounds.high - Vec2(1.0 + 1.3, 2.0 + 1.5)).norm(), 0.0, 1e-15);
}

TEST(Bounds, GrowByWhatTheyAreToHold) {
  BoundingBox bounds = bounds_around({1.0, 1.0}, 0.5);
  bounds.include({{0.75, 3.0}, {1.25, 4.0}});
  EXPECT_EQ(bounds.low, Vec2(0.5, 0.5));
  EXPECT_EQ(bounds.high, Vec2(1.5, 4.0));
}

}  // namespace
}  // namespace wuerfel::test
