// What has happened up to the time at which one looks, of books that are ahead of it.
#include "core/time/shown_book.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

void add_event(double t, Bookkeeping& book) {
  Event event;
  event.t = t;
  book.events.push_back(event);
}

TEST(ShownBook, HasTheEventsUpToItsTime) {
  Bookkeeping computed;
  for (const double t : {1.0, 2.0, 3.0})
    add_event(t, computed);
  ShownBook shown;
  shown.advance_to(2.0, computed);
  EXPECT_EQ(shown.book.events.size(), 2U);
  shown.advance_to(2.5, computed);
  EXPECT_EQ(shown.book.events.size(), 2U);
  add_event(4.0, computed);
  shown.advance_to(4.0, computed);
  EXPECT_EQ(shown.book.events.size(), 4U);
}

TEST(ShownBook, AnImpactThatIsStillToComeHasTakenNothing) {
  Bookkeeping computed;
  computed.losses = {{.t = 2.0, .energy = 4.0, .since = 2.0}};
  ShownBook shown;
  shown.advance_to(1.0, computed);
  EXPECT_FALSE(shown.any_under_way(computed));
  EXPECT_EQ(shown.lost(computed, 4.0).impacts, 0.0);
}

TEST(ShownBook, TellsWhatAStepUnderWayHasTakenByWhatIsMissing) {
  Bookkeeping computed;
  computed.losses = {
      {1.0, 5.0, false, 1.0}, {3.0, 6.0, true, 2.0}, {3.0, 2.0, false, 2.5}, {4.0, 9.0, true, 3.0}};
  ShownBook shown;
  shown.advance_to(2.75, computed);
  const auto expect = [&](double missing, double impacts, double friction) {
    const LostEnergy lost = shown.lost(computed, missing);
    EXPECT_EQ(lost.impacts, impacts) << missing;
    EXPECT_EQ(lost.friction, friction) << missing;
  };
  EXPECT_TRUE(shown.any_under_way(computed));
  expect(5.0 + 4.0, 5.0 + 1.0, 3.0);
  expect(4.0, 5.0, 0.0);  // less than was lost before: a drift, which is not hidden
  expect(20.0, 7.0, 6.0);
  shown.advance_to(3.0, computed);
  EXPECT_FALSE(shown.any_under_way(computed));
  expect(20.0, 7.0, 6.0);
}

}  // namespace
}  // namespace wuerfel::test
