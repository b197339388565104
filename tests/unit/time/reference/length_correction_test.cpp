// What a step of Algorithm 1 leaves open is put right.
#include "core/time/reference/length_correction.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

std::vector<Contact> contacts_of(const Mechanism& m, double near) {
  return ContactFinder().find(m.system, m.state, near);
}

TEST(LengthCorrection, ClosesWhatWasPressedAndStopsItsGap) {
  Mechanism m(on_floor({cube("a", {0.0, 0.5 + 1e-4})}));
  m.state[0].velocity = {0.5, 0.2};
  Workspace work(m.system, {});
  Bookkeeping book;
  State state = m.state;
  const Push given = correct_lengths(state, contacts_of(m, 1e-3), work, book);
  EXPECT_NEAR(given.linear.y(), -0.2, 1e-14);  // by the floor
  EXPECT_EQ(book.settled.linear, given.linear);
  EXPECT_NEAR(state[0].position.y(), 0.5, 1e-11);
  EXPECT_NEAR(state[0].velocity.y(), 0.0, 1e-14);
  EXPECT_EQ(state[0].velocity.x(), 0.5);
  EXPECT_EQ(book.audit.missed_solves, 0);
}

TEST(LengthCorrection, WhatWasNotPressedMayStayOpen) {
  const Mechanism m(on_floor({cube("a", {0.0, 0.5 + 1e-4})}));
  Workspace work(m.system, {});
  Bookkeeping book;
  State state = m.state;
  correct_lengths(state, {}, work, book);
  EXPECT_EQ(state[0].position.y(), m.state[0].position.y());
  EXPECT_EQ(book.cost.qp_solves, 0);
}

TEST(LengthCorrection, WhatIsPushedOutOfAnOverlapEndsClosed) {
  const Mechanism m(on_floor({sized_cube("a", {0.0, 0.69}, Vec2::Ones(), 0.6)}));
  Workspace work(m.system, {});
  Bookkeeping book;
  State state = m.state;
  correct_lengths(state, {}, work, book);
  const std::vector<Contact> contacts = ContactFinder().find(m.system, state);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].gap, 0.0, 1e-11);
}

}  // namespace
}  // namespace wuerfel::test
