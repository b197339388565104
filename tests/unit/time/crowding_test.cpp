// Whether events crowd, in frames of L / V / 20.
#include "core/time/crowding.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

constexpr double time_scale = 20.0;  // s: frames of a second

Crowding crowding_of(int cubes, bool only_events = false) {
  Crowding crowding(cubes, only_events);
  crowding.begin(time_scale, 0.0, 1);
  return crowding;
}

TEST(Crowding, TooManyAreMoreThanTwentyFiveInAFrame) {
  Crowding crowding = crowding_of(2);
  crowding.count(0.5, 25, 0);
  EXPECT_FALSE(crowding.crowds());
  crowding.count(0.9, 1, 0);
  EXPECT_TRUE(crowding.crowds());
  crowding.count(1.1, 1, 0);
  EXPECT_FALSE(crowding.crowds()) << "another frame";
}

TEST(Crowding, LargeGroupsAffordFewerEvents) {
  Crowding crowding = crowding_of(100);
  crowding.count(0.5, 3, 0);
  EXPECT_FALSE(crowding.crowds());
  crowding.count(0.5, 1, 0);
  EXPECT_TRUE(crowding.crowds());
}

TEST(Crowding, OnlyFiveHundredAreTooManyWhereNobodySteps) {
  Crowding crowding = crowding_of(100, true);
  crowding.count(0.5, 500, 0);
  EXPECT_FALSE(crowding.crowds());
  crowding.count(0.5, 1, 0);
  EXPECT_TRUE(crowding.crowds());
}

TEST(Crowding, StepsThatGetNowhereAreTooManyWithoutEvents) {
  Crowding crowding = crowding_of(2);
  crowding.count(0.5, 0, 500);
  EXPECT_FALSE(crowding.crowds());
  crowding.count(0.5, 0, 1);
  EXPECT_TRUE(crowding.crowds());
  EXPECT_TRUE(crowding.calm()) << "of events";
}

TEST(Crowding, IsCalmAfterAFrameWithoutTooMany) {
  Crowding crowding = crowding_of(2);
  crowding.count(0.5, 30, 0);
  crowding.count(1.5, 0, 0);
  EXPECT_FALSE(crowding.calm()) << "the frame before";
  crowding.count(2.5, 0, 0);
  EXPECT_TRUE(crowding.calm());
}

TEST(Crowding, AFrameThatWasSkippedHadNoEvents) {
  Crowding crowding = crowding_of(2);
  crowding.count(0.5, 30, 0);
  crowding.count(5.5, 0, 0);
  EXPECT_TRUE(crowding.calm());
}

TEST(Crowding, SteppingThatIsNeededAgainSoonLastsTwiceAsLong) {
  Crowding crowding = crowding_of(2);
  EXPECT_DOUBLE_EQ(crowding.step_from(0.5), 2.0);
  crowding.step_to(2.0);
  EXPECT_DOUBLE_EQ(crowding.step_from(2.5), 5.0);
  crowding.step_to(5.0);
  EXPECT_DOUBLE_EQ(crowding.step_from(5.5), 10.0);
  EXPECT_EQ(crowding.patience(), 8);
  crowding.step_to(10.0);
  EXPECT_DOUBLE_EQ(crowding.step_from(50.5), 52.0) << "after a long time as at first";
}

TEST(Crowding, PatienceEnds) {
  Crowding crowding = crowding_of(2);
  double t = 0.5;
  for (int k = 0; k < 10; ++k) {
    t = crowding.step_from(t) + 0.5;
    crowding.step_to(t - 0.5);
  }
  EXPECT_EQ(crowding.patience(), 32);
}

}  // namespace
}  // namespace wuerfel::test
