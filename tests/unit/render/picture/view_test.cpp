#include "render/picture/view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/error.h"

namespace wuerfel::test {
namespace {

constexpr double rounding = 1e-9;

SnapshotBox unit_box(const Vec2& center, double angle = 0.0) {
  SnapshotBox box;
  box.center = center;
  box.angle = angle;
  return box;
}

TEST(View, PutsTheWorldsCentreInTheMiddleWithYUp) {
  const View view = fixed_view(Vec2(2.0, 3.0), 8.0, 800, 600);
  EXPECT_EQ(view.to_pixel(Vec2(2.0, 3.0)), Vec2(400.0, 300.0));
  EXPECT_EQ(view.to_pixel(Vec2(3.0, 4.0)), Vec2(500.0, 200.0));
}

TEST(View, PixelsAndWorldAreInverse) {
  const View view = fixed_view(Vec2(-1.0, 0.5), 3.7, 641, 361);
  const Vec2 world(0.3, -0.8);
  EXPECT_LT((view.to_world(view.to_pixel(world)) - world).norm(), rounding);
}

TEST(View, FittedShowsAllWithinTheInsets) {
  Bounds bounds;
  bounds.include(Vec2(-3.0, -1.0));
  bounds.include(Vec2(5.0, 7.0));
  const Insets insets{10.0, 40.0, 20.0, 30.0};
  const View view = fit_view(bounds, 640, 360, insets);
  const Vec2 low = view.to_pixel(bounds.min);
  const Vec2 high = view.to_pixel(bounds.max);
  EXPECT_GE(low.x(), insets.left - rounding);
  EXPECT_LE(high.x(), 640 - insets.right + rounding);
  EXPECT_GE(high.y(), insets.top - rounding);
  EXPECT_LE(low.y(), 360 - insets.bottom + rounding);
  EXPECT_NEAR(low.y() - high.y(), 360 - insets.top - insets.bottom, rounding)
      << "and fills the height";
}

TEST(View, FittedOfNothingOrAPointIsFinite) {
  EXPECT_GT(fit_view(Bounds(), 640, 360, {}).pixels_per_metre, 0.0);
  Bounds point;
  point.include(Vec2(3.0, 3.0));
  const View view = fit_view(point, 640, 360, {});
  EXPECT_TRUE(std::isfinite(view.pixels_per_metre));
  EXPECT_TRUE(view.center.allFinite());
}

TEST(Bounds, OfATurnedBoxReachToItsCorners) {
  Bounds bounds;
  bounds.include(unit_box(Vec2(1.0, 1.0), std::atan(1.0)));
  EXPECT_NEAR(bounds.max.x(), 1.0 + std::sqrt(0.5), rounding);
  EXPECT_NEAR(bounds.min.y(), 1.0 - std::sqrt(0.5), rounding);
}

TEST(Bounds, IncludeTheTipsOfArrows) {
  Snapshot snapshot;
  snapshot.boxes.push_back(unit_box(Vec2::Zero()));
  snapshot.forces.push_back({Vec2(0.5, -0.5), Vec2(0.0, 100.0), ForceKind::contact, 0});
  Bounds bounds;
  bounds.include(snapshot, {0.02, 5.0, 0.0});
  EXPECT_NEAR(bounds.max.y(), 1.5, rounding);
}

TEST(Bounds, IncludeCutArrowsOnlyAsFarAsTheyAreDrawn) {
  Snapshot snapshot;
  snapshot.boxes.push_back(unit_box(Vec2::Zero()));
  snapshot.forces.push_back({Vec2(0.5, -0.5), Vec2(0.0, 1e6), ForceKind::contact, 0});
  Bounds bounds;
  bounds.include(snapshot, {0.02, 5.0, 0.0});
  EXPECT_NEAR(bounds.max.y(), 4.5, rounding);
}

TEST(Bounds, LeaveRoomForTheLongestArrowInTheGround) {
  Snapshot snapshot;
  snapshot.boxes.push_back(unit_box(Vec2(0.0, 0.5)));
  snapshot.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY()});
  Bounds bounds;
  bounds.include(snapshot, {0.02, 0.8, 0.0});
  EXPECT_NEAR(bounds.min.y(), -0.8, rounding) << "whatever is pushed now";
  Bounds without_arrows;
  without_arrows.include(snapshot, {});
  EXPECT_NEAR(without_arrows.min.y(), 0.0, rounding);
}

TEST(Bounds, ReachTheNearGroundButNotTheFarOne) {
  Snapshot snapshot;
  snapshot.boxes.push_back(unit_box(Vec2(0.0, 1.5)));
  snapshot.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY()});
  snapshot.planes.push_back({"wall", Vec2(100.0, 0.0), -Vec2::UnitX()});
  Bounds bounds;
  bounds.include(snapshot);
  EXPECT_NEAR(bounds.min.y(), 0.0, rounding);
  EXPECT_NEAR(bounds.max.x(), 0.5, rounding);
}

// The foot of a body on a plane is on it but for rounding, which is as large as the body.
TEST(Bounds, ReachTheGroundBelowBodiesOfEverySize) {
  for (const double size : {1e-9, 1.0, 1e9}) {
    for (const double slope : {0.1, 0.2, 0.3, 0.4, 0.5}) {
      Snapshot snapshot;
      const Vec2 normal = Vec2(-slope, 1.0).normalized();
      snapshot.planes.push_back({"ground", Vec2::Zero(), normal});
      snapshot.boxes.push_back(unit_box(0.5 * size * normal, std::atan(slope)));
      snapshot.boxes.front().size = Vec2(size, size);
      Bounds bounds;
      bounds.include(snapshot, ForceScale{.metres_per_newton = size, .longest = 0.8 * size});
      EXPECT_NEAR(bounds.min.y(), -0.8 * size * normal.y(), 1e-9 * size) << size << ' ' << slope;
    }
  }
}

}  // namespace
}  // namespace wuerfel::test
