// Events without an impulse.
#include "core/time/events/contact_changes.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// A block on a shelf, as a phase that keeps one contact at `alpha` of the shelf's top closed.
ContactModes one_contact(double alpha) {
  ContactModes modes;
  Contact c;
  c.on = 0;
  c.from = 1;
  c.alpha = alpha;
  c.point = {alpha, 0.0};
  modes.closed.contacts = {c};
  Touch touch;
  touch.on = 0;
  touch.from = 1;
  modes.closed.touches = {touch};
  modes.touching = modes.closed.touches;
  modes.resting = {0};
  return modes;
}

ContactModes nothing() {
  ContactModes modes;
  modes.resting = {0};
  return modes;
}

System shelf() {
  Scene scene;
  scene.fixed = {post("shelf", {0.0, -0.5}, {4.0, 1.0})};
  scene.cubes = {cube("a", {0.0, 0.5})};
  return make_system(scene);
}

std::vector<Event> changes(const ContactModes& before,
                           const ContactModes& after,
                           std::vector<Event> events = {}) {
  add_contact_changes(shelf(), before, after, 2.0, events);
  return events;
}

TEST(ContactChanges, LettingGoWithinASideIsARelease) {
  const std::vector<Event> events = changes(one_contact(0.4), nothing());
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::release);
  EXPECT_EQ(events[0].t, 2.0);
  EXPECT_EQ(events[0].on, "a");
  EXPECT_EQ(events[0].from, "shelf");
  EXPECT_EQ(events[0].point.x(), 0.4);
}

TEST(ContactChanges, AtTheEndOfASideItIsASlideOff) {
  for (const double end : {0.0, 1.0}) {
    const std::vector<Event> events = changes(one_contact(end), nothing());
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::slide_off);
  }
}

TEST(ContactChanges, BearingAnewIsATouchButNotWhereBodiesTouchedAlready) {
  const std::vector<Event> events = changes(nothing(), one_contact(0.4));
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::touch);
  ContactModes touched = nothing();
  touched.touching = one_contact(0.4).touching;
  EXPECT_TRUE(changes(touched, one_contact(0.4)).empty());
}

TEST(ContactChanges, WhatRestsOrIsNamedAlreadyIsLeftOut) {
  ContactModes rests = nothing();
  rests.resting = {1};
  EXPECT_TRUE(changes(one_contact(0.4), rests).empty());
  const Event impact{2.0, EventKind::impact, "shelf", "a", Vec2::Zero(), 1.0};
  EXPECT_EQ(changes(one_contact(0.4), nothing(), {impact}).size(), 1U);
}

TEST(ContactChanges, StickingAndSlippingAreEventsWhereSomethingRubs) {
  ContactModes slips = one_contact(0.4);
  slips.closed.touches[0].surface.friction = 0.5;
  ContactModes sticks = slips;
  slips.closed.touches[0].slips = 1;
  sticks.closed.touches[0].sticks = true;
  ASSERT_EQ(changes(slips, sticks).size(), 1U);
  EXPECT_EQ(changes(slips, sticks)[0].kind, EventKind::stick);
  EXPECT_EQ(changes(sticks, slips).at(0).kind, EventKind::slip);
  ContactModes back = slips;
  back.closed.touches[0].slips = -1;
  EXPECT_EQ(changes(slips, back).at(0).kind, EventKind::slip);
  EXPECT_TRUE(changes(slips, slips).empty());
}

}  // namespace
}  // namespace wuerfel::test
