// Bounces without end, and when they are over: geometric series.
#include "core/time/events/bounce_series.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

/// Takes note of bounces at these times, one instant each; returns the last one's events.
std::vector<Event> bounce(BounceSeries& series, const std::vector<double>& times, double most) {
  std::vector<Event> events;
  for (const double t : times) {
    events = {{t, EventKind::impact, "a", "floor", Vec2::Zero(), 1.0},
              {t, EventKind::rest, "a", "floor", Vec2::Zero(), 0.0}};
    series.note(
        events, [](const auto&) { return false; }, most);
  }
  return events;
}

TEST(BounceSeries, ARestIsDatedWhereTheSeriesOfBouncesEnds) {
  // Bounces at 0, 1, 1.5, 1.75, 1.875, 1.9375: they end at 2.
  BounceSeries series;
  double t = 0.0;
  double interval = 1.0;
  std::vector<Event> events;
  for (int k = 0; k < 6; ++k) {
    events = {{t, EventKind::impact, "a", "floor", Vec2::Zero(), 1.0}};
    if (k == 5) events.push_back({t, EventKind::rest, "a", "floor", Vec2::Zero(), 0.0});
    series.note(
        events, [](const auto&) { return false; }, 0.1);
    EXPECT_EQ(series.goes_on(), k >= 4) << k;
    t += interval;
    interval *= 0.5;
  }
  EXPECT_EQ(events[0].t, 1.9375);
  EXPECT_NEAR(events[1].t, 2.0, 1e-15);
}

TEST(BounceSeries, PairsThatMoveOnTouchWhereItEnds) {
  BounceSeries series;
  double t = 0.0;
  double interval = 1.0;
  std::vector<Event> events;
  for (int k = 0; k < 6; ++k) {
    events = {{t, EventKind::impact, "a", "floor", Vec2::Zero(), 1.0}};
    const BounceSeries::NamePair pair{"a", "floor"};
    series.note(
        events, [&](const auto& names) { return names == pair; }, 0.1);
    t += interval;
    interval *= 0.5;
  }
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].kind, EventKind::touch);
  EXPECT_NEAR(events[1].t, 2.0, 1e-15);
}

TEST(BounceSeries, WhoseRatiosDisagreeIsNone) {
  BounceSeries series;
  // Intervals 1, 1/2, 1/4, 1/8, then 1/10.
  EXPECT_EQ(bounce(series, {0.0, 1.0, 1.5, 1.75, 1.875}, 0.2)[1].t, 2.0);
  EXPECT_TRUE(series.goes_on());
  EXPECT_EQ(bounce(series, {1.975}, 0.2)[1].t, 1.975);
  EXPECT_FALSE(series.goes_on());
}

TEST(BounceSeries, WhoseIntervalsGrowIsNone) {
  BounceSeries series;
  bounce(series, {0.0, 1.0, 3.0, 7.0, 15.0, 31.0}, 100.0);
  EXPECT_FALSE(series.goes_on());
}

TEST(BounceSeries, ThatLastsTooLongEndsWhereItIsSeen) {
  BounceSeries series;
  EXPECT_EQ(bounce(series, {0.0, 1.0, 1.5, 1.75, 1.875}, 0.12)[1].t, 1.875);
  EXPECT_TRUE(series.goes_on());
}

TEST(BounceSeries, OfAPairDoesNotGoOnByTheBouncesOfAnother) {
  BounceSeries series;
  bounce(series, {0.0, 1.0, 1.5, 1.75, 1.875}, 0.0);
  std::vector<Event> other = {{1.9375, EventKind::impact, "b", "floor", Vec2::Zero(), 1.0},
                              {1.9375, EventKind::impact, "a", "floor", Vec2::Zero(), 1.0}};
  series.note(
      other, [](const auto&) { return false; }, 0.0);
  EXPECT_FALSE(series.goes_on());
}

}  // namespace
}  // namespace wuerfel::test
