// What rods do at an instant, as events.
#include "core/time/rod_events.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// Two points in a row on rods of 1 m from the origin, the second three times as heavy.
///   o---1---2
Mechanism row() {
  Scene scene;
  scene.points.push_back({"one", 1.0, {1.0, 0.0}, Vec2::Zero(), {}});
  scene.points.push_back({"two", 3.0, {2.0, 0.0}, Vec2::Zero(), {}});
  scene.rods.push_back({"inner", {"one", Vec2::Zero()}, {"", Vec2::Zero()}, 1.0});
  scene.rods.push_back({"outer", {"one", Vec2::Zero()}, {"two", Vec2::Zero()}, 1.0});
  return Mechanism(scene);
}

TEST(RodEvents, AJamTakesTheLargerOfTheMomentaAtTheEndsOfARod) {
  const Mechanism m = row();
  State after = m.state;
  after[0].velocity = {0.0, 2.0};
  after[1].velocity = {0.0, 1.0};
  std::vector<Event> events;
  add_jam_events(m.system, m.state, after, std::vector{0, 1}, 0.75, events);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].kind, EventKind::jam);
  EXPECT_EQ(events[0].t, 0.75);
  EXPECT_EQ(events[0].impulse, 2.0);
  EXPECT_EQ(events[0].on, "one");
  EXPECT_EQ(events[1].impulse, 3.0);
  EXPECT_EQ(events[1].from, "two");
  EXPECT_EQ(events[1].point, Vec2(1.0, 0.0));
}

TEST(RodEvents, ContradictionsNameTheirRods) {
  const Mechanism m = row();
  Bookkeeping book;
  note_contradiction(m.system, std::vector{1}, 0.5, book);
  EXPECT_EQ(book.audit.rods_contradicting, 1);
  ASSERT_EQ(book.breaches.size(), 1U);
  EXPECT_EQ(book.breaches[0].bodies, std::vector<std::string>{"outer"});
}

TEST(RodEvents, LostAreThoseThatAreFartherOffThanPromised) {
  const Mechanism m = row();
  EXPECT_TRUE(lost_rods(m.system, m.state).empty());
  State off = m.state;
  off[1].position.x() += 0.9e-9;
  EXPECT_TRUE(lost_rods(m.system, off).empty());
  off[1].position.x() += 0.2e-9;
  EXPECT_EQ(lost_rods(m.system, off), std::vector<std::string>{"outer"});
}

}  // namespace
}  // namespace wuerfel::test
