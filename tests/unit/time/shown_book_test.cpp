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

TEST(ShownBook, KnowsImpactsFromFriction) {
  Bookkeeping computed;
  computed.losses = {{.t = 1.0, .energy = 5.0},
                     {.t = 2.0, .energy = 3.0, .friction = true, .since = 1.0}};
  ShownBook shown;
  shown.advance_to(2.0, computed);
  EXPECT_EQ(shown.lost(computed).impacts, 5.0);
  EXPECT_EQ(shown.lost(computed).friction, 3.0);
  EXPECT_EQ(shown.lost(computed).under_way, 0.0);
}

TEST(ShownBook, FrictionOfAStepUnderWayHasTakenItsShare) {
  Bookkeeping computed;
  computed.losses = {{.t = 2.0, .energy = 4.0, .friction = true, .since = 1.0},
                     {.t = 3.0, .energy = 7.0, .friction = true, .since = 2.0}};
  ShownBook shown;
  shown.advance_to(1.5, computed);
  EXPECT_DOUBLE_EQ(shown.lost(computed).friction, 2.0);
  EXPECT_EQ(shown.lost(computed).under_way, 4.0);
  EXPECT_EQ(shown.lost(computed).impacts, 0.0);
}

TEST(ShownBook, AnImpactThatIsStillToComeHasTakenNothing) {
  Bookkeeping computed;
  computed.losses = {{.t = 2.0, .energy = 4.0}};
  ShownBook shown;
  shown.advance_to(1.0, computed);
  EXPECT_EQ(shown.lost(computed).impacts, 0.0);
}

}  // namespace
}  // namespace wuerfel::test
