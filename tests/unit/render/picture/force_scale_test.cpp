#include "render/picture/force_scale.h"

#include <gtest/gtest.h>

namespace wuerfel {
namespace {

/// One cube of side 2 m and these forces.
Snapshot snapshot_with(const std::vector<double>& newtons) {
  Snapshot snapshot;
  SnapshotBox box;
  box.size = Vec2(2.0, 2.0);
  snapshot.boxes.push_back(box);
  for (const double force : newtons) {
    snapshot.forces.push_back({Vec2::Zero(), Vec2(0.0, force), ForceKind::contact, 0});
  }
  return snapshot;
}

TEST(RoundDown, GivesTheLargest125NumberNotAbove) {
  EXPECT_DOUBLE_EQ(round_down_125(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_down_125(1.99), 1.0);
  EXPECT_DOUBLE_EQ(round_down_125(4.99), 2.0);
  EXPECT_DOUBLE_EQ(round_down_125(9.99), 5.0);
  EXPECT_DOUBLE_EQ(round_down_125(0.2 / 0.1), 2.0);
  EXPECT_DOUBLE_EQ(round_down_125(0.3), 0.2);
  EXPECT_DOUBLE_EQ(round_down_125(1000.0), 1000.0);
  EXPECT_DOUBLE_EQ(round_down_125(3.4e-7), 2e-7);
}

TEST(ForceRange, MakesTheLargestArrowOneAndAHalfSidesLong) {
  ForceRange range;
  range.include(snapshot_with({10.0, 20.0, 30.0}));
  EXPECT_DOUBLE_EQ(range.scale().metres_per_newton * 30.0, 3.0);
  EXPECT_GT(range.scale().longest, 3.0) << "nothing is cut";
}

TEST(ForceRange, CutsAFewPeaksInsteadOfShrinkingAllOthers) {
  ForceRange range;
  range.include(snapshot_with(std::vector<double>(1000, 10.0)));
  range.include(snapshot_with({5000.0}));
  const ForceScale scale = range.scale();
  const double ordinary = scale.metres_per_newton * 10.0;
  EXPECT_GT(ordinary, 2.0);
  EXPECT_LE(ordinary, 3.0);
  EXPECT_DOUBLE_EQ(scale.longest, 5.0);
}

TEST(ForceRange, HidesWhatIsNegligible) {
  ForceRange range;
  range.include(snapshot_with({100.0}));
  EXPECT_GT(range.scale().hidden_below, 0.01);
  EXPECT_LT(range.scale().hidden_below, 1.0);
}

TEST(ForceRange, WithoutForcesDrawsNoArrows) {
  ForceRange range;
  range.include(snapshot_with({}));
  EXPECT_EQ(range.scale().metres_per_newton, 0.0);
}

TEST(ForceRange, TakesHugeAndTinyForces) {
  ForceRange range;
  range.include(snapshot_with({1e-30, 1e-30}));
  EXPECT_GT(range.scale().metres_per_newton, 0.0);
  ForceRange huge;
  huge.include(snapshot_with({1e30}));
  EXPECT_DOUBLE_EQ(huge.scale().metres_per_newton * 1e30, 3.0);
}

TEST(ForceScale, GivenByTheUserIsKept) {
  ForceRange range;
  range.include(snapshot_with({100.0}));
  const ForceScale scale = fixed_force_scale(0.25, range);
  EXPECT_EQ(scale.metres_per_newton, 0.25);
  EXPECT_EQ(scale.longest, 12.0);
}

}  // namespace
}  // namespace wuerfel
