// What a step of Algorithm 1 leaves open is put right, and steps between grid times leave no trace.
#include "core/time/reference/length_correction.h"

#include <gtest/gtest.h>

#include "core/time/reference/fixed_step_motion.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

std::vector<Contact> contacts_of(const Mechanism& m, double near) {
  ContactFinder finder;
  std::vector<Contact> contacts;
  finder.find(m.system, m.state, contacts, near);
  return contacts;
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
  ContactFinder finder;
  std::vector<Contact> contacts;
  finder.find(m.system, state, contacts);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].gap, 0.0, 1e-11);
}

TEST(FixedStepMotion, LooksBetweenGridTimesAreStepsAside) {
  const Mechanism m(on_floor({sized_cube("a", {0.0, 1.2}, Vec2::Ones(), 0.2)}));
  MotionSettings settings;
  settings.integrator = Integrator::symplectic;
  settings.step = 0.01;
  FixedStepMotion seldom(m.system, settings, m.state);
  FixedStepMotion often(m.system, settings, m.state);
  for (int k = 1; k <= 100; ++k) {
    often.advance_to(0.004 * k);
    EXPECT_FALSE(often.state().empty());
  }
  seldom.advance_to(0.4);
  EXPECT_EQ(seldom.state()[0].position, often.state()[0].position);
  EXPECT_EQ(seldom.state()[0].angle, often.state()[0].angle);
  EXPECT_EQ(seldom.book().cost.steps, 40);
  EXPECT_EQ(often.book().cost.steps, 40);
}

TEST(FixedStepMotion, BetweenGridTimesTheFallGoesOn) {
  const Mechanism m(on_floor({cube("a", {0.0, 9.0})}));
  MotionSettings settings;
  settings.integrator = Integrator::symplectic;
  settings.step = 0.125;
  FixedStepMotion motion(m.system, settings, m.state);
  motion.advance_to(0.1875);
  // One whole step and a half one, each with the new velocity.
  const double v_1 = -9.81 * 0.125;
  const double v_2 = v_1 - 9.81 * 0.0625;
  EXPECT_NEAR(motion.state()[0].velocity.y(), v_2, 1e-14);
  EXPECT_NEAR(motion.state()[0].position.y(), 9.0 + 0.125 * v_1 + 0.0625 * v_2, 1e-14);
}

}  // namespace
}  // namespace wuerfel::test
