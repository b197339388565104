#include "app/cli/progress.h"

#include <vector>

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

/// How many lines a job of `total` s gets that goes on evenly and is looked at every `interval` s.
int lines_of(double total, double interval) {
  LogSchedule schedule;
  int lines = 0;
  for (double elapsed = interval; elapsed <= total; elapsed += interval)
    lines += schedule.due(elapsed / total, elapsed) ? 1 : 0;
  return lines;
}

TEST(LogSchedule, HasALinePerTenth) {
  // Tenths of 0.5 s: the first is over before a second is; at 10 s the last is due anyway.
  EXPECT_EQ(lines_of(5.0, 0.125), 9);
  EXPECT_EQ(lines_of(64.0, 0.25), 12);  // tenths of 6.4 s, and lines at 10 and 40 s
}

TEST(LogSchedule, TellsNothingOfWhatIsOverAtOnce) { EXPECT_EQ(lines_of(0.9, 0.01), 0); }

TEST(LogSchedule, HasNoLineTwiceForATenth) {
  LogSchedule schedule;
  EXPECT_TRUE(schedule.due(0.25, 2.0));
  EXPECT_FALSE(schedule.due(0.26, 2.1));
  EXPECT_FALSE(schedule.due(0.29, 9.9));
  EXPECT_TRUE(schedule.due(0.31, 9.95));
}

TEST(LogSchedule, TellsThatItGoesOnWhereATenthTakesLong) {
  LogSchedule schedule;
  std::vector<int> told;
  for (int second = 1; second <= 1000; ++second)
    if (schedule.due(0.0, second)) told.push_back(second);
  EXPECT_EQ(told, (std::vector<int>{10, 40, 160, 640}));
}

TEST(LogSchedule, ALookThatComesLateGetsOneLine) {
  LogSchedule schedule;
  EXPECT_TRUE(schedule.due(0.05, 500.0));  // for 10, 40 and 160 s at once
  EXPECT_FALSE(schedule.due(0.06, 501.0));
  EXPECT_TRUE(schedule.due(0.07, 640.0));
}

}  // namespace
}  // namespace wuerfel::test
