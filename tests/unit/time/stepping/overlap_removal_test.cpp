// Cubes are kept apart within a step: clean-up, retreat.
#include "core/time/stepping/overlap_removal.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

TEST(OverlapRemoval, CleansUpByTheLeastThatIsNeeded) {
  const Mechanism m(side_by_side(0.0));
  Workspace work(m.system, {}, step_tolerances(m.system));
  OverlapRemoval removal(work);
  removal.begin(m.state, 0.01);
  State state = m.state;
  state[0].position.x() += 1e-6;
  Bookkeeping book;
  const std::vector<Contact> pushing = removal.clean_up(state, book);
  EXPECT_EQ(pushing.size(), 2U);
  EXPECT_LE(removal.left(), overlap_share);
  EXPECT_GT(book.cost.qp_solves, 0);
  EXPECT_EQ(book.audit.missed_solves, 0);
  // Half of the way each, and 5e-11 m of margin.
  EXPECT_NEAR(state[0].position.x(), 0.5e-6, 1e-10);
  EXPECT_NEAR(state[1].position.x(), 1.0 + 0.5e-6, 1e-10);
  EXPECT_GE(state[1].position.x() - state[0].position.x(), 1.0);
}

TEST(OverlapRemoval, WhatDoesNotOverlapIsLeftAlone) {
  const Mechanism m(side_by_side(0.0));
  Workspace work(m.system, {}, step_tolerances(m.system));
  OverlapRemoval removal(work);
  removal.begin(m.state, 0.01);
  State state = m.state;
  state[0].position.x() += 1e-10;
  Bookkeeping book;
  EXPECT_TRUE(removal.clean_up(state, book).empty());
  EXPECT_EQ(state[0].position.x(), 1e-10);
  EXPECT_EQ(book.cost.qp_solves, 0);
  EXPECT_NEAR(removal.left(), 1e-10, 1e-15);
}

TEST(OverlapRemoval, RetreatHalvesTheWayOfThoseThatOverlap) {
  Scene scene = side_by_side(0.1);
  scene.cubes.push_back(cube("far", {9.0, 0.0}));
  const Mechanism m(scene);
  Workspace work(m.system, {}, step_tolerances(m.system));
  OverlapRemoval removal(work);
  removal.begin(m.state, 0.01);
  State state = m.state;
  state[0].position.x() += 0.3;
  state[0].angle += 0.0;
  state[2].position.x() += 0.3;
  removal.retreat(state);
  // 0.3 and 0.15 are too far, 0.075 is not.
  EXPECT_NEAR(state[0].position.x(), 0.075, 1e-15);
  EXPECT_EQ(state[1].position.x(), m.state[1].position.x());
  EXPECT_EQ(state[2].position.x(), m.state[2].position.x() + 0.3);
  EXPECT_LE(removal.left(), overlap_share);
}

}  // namespace
}  // namespace wuerfel::test
