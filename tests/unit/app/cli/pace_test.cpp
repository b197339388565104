#include "app/cli/pace.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

/// How many steps of `length` s a motion of 1 s is let go on for, at most `most`.
long steps_until_stopped(double length, std::size_t bodies, long most) {
  Pace pace(1.0, bodies, Integrator::automatic);
  for (long k = 1; k <= most; ++k) {
    try {
      pace.beat(static_cast<double>(k) * length);
    } catch (const EndlessMotion&) {
      return k;
    }
  }
  return most;
}

TEST(Pace, StopsWhatWouldTakeMoreThanABillionSteps) {
  EXPECT_EQ(steps_until_stopped(0.9e-9, 0, 1'000'000), 100'000);
  EXPECT_EQ(steps_until_stopped(0.9e-9, 10, 1'000'000), 200'000) << "bodies may take turns";
  EXPECT_EQ(steps_until_stopped(1.1e-9, 0, 1'000'000), 1'000'000);
}

TEST(Pace, StopsAClockThatStands) { EXPECT_EQ(steps_until_stopped(0.0, 0, 1'000'000), 100'000); }

TEST(Pace, BearsAHaltOfWhatIsFastOtherwise) {
  Pace pace(1.0, 0, Integrator::rattle);
  for (long k = 0; k < 99'999; ++k)
    pace.beat(0.25);
  EXPECT_NO_THROW(pace.beat(0.5));
}

TEST(Pace, DoesNotJudgeStepsOfOneLength) {
  Pace pace(1.0, 0, Integrator::symplectic);
  for (long k = 0; k < 300'000; ++k)
    EXPECT_NO_THROW(pace.beat(1e-12 * static_cast<double>(k)));
}

TEST(Pace, LetsTheEndBeReached) {
  Pace pace(1.0, 0, Integrator::rattle);
  for (long k = 0; k < 300'000; ++k)
    EXPECT_NO_THROW(pace.beat(1.0));
}

}  // namespace
}  // namespace wuerfel::test
