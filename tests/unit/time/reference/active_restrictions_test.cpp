// What touches, hits and rests at a grid point.
#include "core/time/reference/active_restrictions.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// A grid point at the state of a mechanism.
GridPoint point_at(const Mechanism& m, double t = 0.5) {
  GridPoint point;
  point.t = t;
  point.state = m.state;
  return point;
}

TEST(ActiveRestrictions, WhatMeetsIsStruckAndWhatLastsIsNoEvent) {
  //   +---++---+    m = 1, 3; inelastic: v = 1/4
  //   | a || b |
  //   +---++---+
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.0, 0.0})};
  scene.cubes[0].velocity = {1.0, 0.0};
  scene.cubes[1].mass = 3.0;
  const Mechanism m(scene);
  Workspace work(m.system, {});
  Bookkeeping book;
  GridPoint point = point_at(m);
  find_restrictions(point, work, book);
  for (const BodyState& s : point.state)
    EXPECT_NEAR(s.velocity.x(), 0.25, 1e-14);
  EXPECT_NEAR(book.audit.impact_loss, 0.375, 1e-14);
  ASSERT_EQ(book.events.size(), 2U);
  EXPECT_EQ(book.events[0].t, 0.5);
  EXPECT_NEAR(book.events[0].impulse + book.events[1].impulse, 0.75, 1e-14);
  // The same contacts at the next grid time.
  point.state[0].velocity.x() = 0.5;
  find_restrictions(point, work, book);
  EXPECT_EQ(book.events.size(), 2U);
  EXPECT_NEAR(point.state[0].velocity.x(), 0.3125, 1e-14);
}

TEST(ActiveRestrictions, WhatStandsIsFoundAtRestAndFoundOnce) {
  const Mechanism m(on_floor({cube("a", {0.0, 0.5}), cube("free", {5.0, 9.0})}));
  Workspace work(m.system, {});
  Bookkeeping book;
  GridPoint point = point_at(m);
  find_restrictions(point, work, book);
  accelerate(point, work, book);
  EXPECT_EQ(point.resting, (std::vector<char>{1, 0}));
  EXPECT_FALSE(point.at_rest());
  EXPECT_EQ(point.accelerations[0].linear, Vec2::Zero());
  EXPECT_EQ(point.accelerations[1].linear, m.system.gravity);
  EXPECT_EQ(book.cost.qp_solves, 1);
  EXPECT_EQ(book.cost.skipped_free, 1);
  // At the next grid time nothing has changed about the island.
  find_restrictions(point, work, book);
  accelerate(point, work, book);
  EXPECT_EQ(point.resting, (std::vector<char>{1, 0}));
  EXPECT_EQ(book.cost.qp_solves, 1);
  EXPECT_EQ(book.cost.skipped_rest, 1);
}

TEST(ActiveRestrictions, WhoeverComesWakesWhatRested) {
  Scene scene = on_floor({cube("a", {0.0, 0.5}), cube("b", {0.0, 1.5})});
  Mechanism m(scene);
  m.state[1].velocity.y() = -1.0;
  Workspace work(m.system, {});
  Bookkeeping book;
  GridPoint point = point_at(m);
  point.resting = {1, 0};
  find_restrictions(point, work, book);
  EXPECT_EQ(point.resting, (std::vector<char>{0, 0}));
  EXPECT_NEAR(book.audit.impact_loss, 0.5, 1e-13);
}

TEST(ActiveRestrictions, WhatHardlyMovesStands) {
  Mechanism m(on_floor({cube("a", {0.0, 0.5})}));
  Workspace work(m.system, {});
  Bookkeeping book;
  const double zero = rate_tolerance * std::sqrt(9.81);
  for (const double share : {0.9, 1.1}) {
    m.state[0].velocity.x() = share * zero;
    GridPoint point = point_at(m);
    find_restrictions(point, work, book);
    EXPECT_EQ(point.state[0].velocity.x() == 0.0, share < 1.0);
  }
}

TEST(ActiveRestrictions, WithoutIslandsAllIsOneProgram) {
  const Mechanism m(
      on_floor({cube("a", {0.0, 0.5}), cube("b", {5.0, 0.5}), cube("c", {9.0, 9.0})}));
  for (const bool islands : {true, false}) {
    Workspace work(m.system, {.skips = {.islands = islands}});
    Bookkeeping book;
    GridPoint point = point_at(m);
    find_restrictions(point, work, book);
    EXPECT_EQ(point.islands.size(), islands ? 2U : 1U);
  }
}

}  // namespace
}  // namespace wuerfel::test
