#include "render/picture/force_scale.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

/// One cube of side 2 m that weighs so much, on a floor that pushes with these forces.
Snapshot snapshot_with(const std::vector<double>& newtons, double weight = 0.0) {
  Snapshot snapshot;
  SnapshotBox box;
  box.size = Vec2(2.0, 2.0);
  box.mass = 1.0;
  snapshot.gravity = Vec2(0.0, -weight);
  snapshot.boxes.push_back(box);
  snapshot.planes.push_back({"floor", Vec2(0.0, -1.0), Vec2::UnitY()});
  for (const double force : newtons) {
    SnapshotJoint joint;
    joint.body = 0;
    joint.other = 1;
    joint.force = Vec2(0.0, force);
    snapshot.joints.push_back(joint);
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

TEST(ForceRange, MakesATypicalWeightHalfASide) {
  ForceRange range;
  range.include(snapshot_with({10.0}, 10.0));
  EXPECT_DOUBLE_EQ(range.scale().metres_per_newton * 10.0, 1.0);
  EXPECT_DOUBLE_EQ(range.scale().longest, 1.6);
  EXPECT_FALSE(range.cuts(range.scale()));
}

TEST(ForceRange, MakesTheLargestForceFourFifthsOfASide) {
  ForceRange range;
  range.include(snapshot_with({10.0, 20.0, 50.0}, 10.0));
  EXPECT_DOUBLE_EQ(range.scale().metres_per_newton * 50.0, 1.6);
  EXPECT_FALSE(range.cuts(range.scale()));
}

TEST(ForceRange, LetsNoWedgeHideTheWeights) {
  ForceRange range;
  range.include(snapshot_with({10.0, 10.0, 6e4}, 10.0));
  EXPECT_DOUBLE_EQ(range.scale().metres_per_newton * 10.0, 0.3) << "of a side of 2 m";
  EXPECT_TRUE(range.cuts(range.scale()));
}

TEST(ForceRange, CutsAFewPeaksInsteadOfShrinkingAllOthers) {
  ForceRange range;
  range.include(snapshot_with(std::vector<double>(1000, 10.0), 10.0));
  range.include(snapshot_with({30.0}));
  const double ordinary = range.scale().metres_per_newton * 10.0;
  EXPECT_DOUBLE_EQ(ordinary, 1.0);
  EXPECT_TRUE(range.cuts(range.scale()));
}

TEST(ForceRange, HidesWhatIsNegligible) {
  ForceRange range;
  range.include(snapshot_with({100.0}));
  EXPECT_GT(range.scale().hidden_below, 0.01);
  EXPECT_LT(range.scale().hidden_below, 2.0);
}

TEST(ForceRange, WithoutForcesAndWeightsDrawsNoArrows) {
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
  EXPECT_DOUBLE_EQ(huge.scale().metres_per_newton * 1e30, 1.6);
}

TEST(ForceScale, GivenByTheUserIsKept) {
  ForceRange range;
  range.include(snapshot_with({100.0}));
  const ForceScale scale = fixed_force_scale(0.25, range);
  EXPECT_EQ(scale.metres_per_newton, 0.25);
  EXPECT_EQ(scale.longest, 12.0);
}

TEST(ForceScale, CutsNothingForARounding) {
  const ForceScale scale{0.1, 1.0, 0.0};
  EXPECT_FALSE(scale.cuts(10.0 * (1.0 + 1e-8)));
  EXPECT_TRUE(scale.cuts(10.0 * (1.0 + 1e-4)));
}

TEST(JointArrow, EndsAtTheJointAndStaysInsideTheBodyThatPushes) {
  Snapshot snapshot = snapshot_with({100.0});
  SnapshotBox below = snapshot.boxes[0];
  below.center.y() = -2.0;
  below.angle = 3.14159265358979 / 2.0;
  below.size = Vec2(1.0, 2.0);  // turned: one high
  snapshot.boxes.push_back(below);
  snapshot.joints[0].point = Vec2(0.25, -1.5);
  const JointArrow arrow = joint_arrow(snapshot, snapshot.joints[0], {1.0, 50.0, 0.0});
  EXPECT_EQ(arrow.tip, snapshot.joints[0].point);
  EXPECT_NEAR(arrow.length(), 0.8, 1e-12);
  EXPECT_TRUE(arrow.cut);
  EXPECT_EQ(arrow.tail.x(), 0.25);
}

TEST(TypicalSide, OfAThinBodyIsAQuarterOfItsLength) {
  SnapshotBox box;
  box.size = {4.0, 1.0};
  EXPECT_DOUBLE_EQ(typical_side_of(box), 2.0);
  box.size = {2.0, 0.001};
  EXPECT_DOUBLE_EQ(typical_side_of(box), 0.5);
}

}  // namespace
}  // namespace wuerfel::test
