// The books of a step that is made up by hand, and the closing of gaps when stepping ends.
#include "core/time/stepping/step_books.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/time/stepping/close_gaps.h"
#include "core/time/stepping/step_energy.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// A cube without weight that comes down at 1 m/s from 0.04 m above the ground, and is stopped by
/// half a newton second at either corner, in the first half of a step of 0.1 s.
class Landing {
 public:
  Landing() : m_(scene()) {
    ContactFinder finder;
    std::vector<Contact> contacts;
    finder.find(m_.system, m_.state, contacts, 0.1);
    stride.h = 0.1;
    stride.scales = scales_of(m_.system, m_.state);
    stride.start = stride.half = m_.state;
    stride.half[0].velocity.setZero();
    stride.before = end = stride.half;
    for (const Contact& c : contacts)
      stride.blows[c.id()] = {c, c, {0.0, 0.5}, Vec2::Zero()};
  }
  [[nodiscard]] const System& system() const { return m_.system; }
  Stride stride;
  State end;

 private:
  static Scene scene() {
    Scene scene = on_floor({cube("a", {0.0, 0.54})});
    scene.gravity = Vec2::Zero();
    scene.cubes[0].velocity = {0.0, -1.0};
    return scene;
  }
  Mechanism m_;
};

TEST(StepBooks, WhatClosesLosesWhatItsImpulsesTake) {
  const Landing landing;
  const StepRecord record = record_of(landing.system(), landing.stride, landing.end);
  ASSERT_EQ(record.components.size(), 1U);
  EXPECT_EQ(record.components[0].cubes, std::vector<int>{0});
  EXPECT_NEAR(sum_of(record.components[0].losses), 0.5, 1e-15);
  ASSERT_EQ(record.impulses.size(), 2U);
  for (const StepImpulse& p : record.impulses) {
    EXPECT_NEAR(p.begin, 0.4, 1e-14);
    EXPECT_EQ(p.end, p.begin);
  }
  EXPECT_NEAR(record.impulses[0].turn_on + record.impulses[1].turn_on, 0.0, 1e-16);
}

/// Slower than an impact: 0.1 g h at 0.04 g h^2 from the ground, 0.2 of the step away in free fall.
StepRecord record_of_slow_landing(double opening) {
  Landing landing;
  Stride& stride = landing.stride;
  const double gh = stride.scales.gravity * stride.h;
  stride.start[0].velocity = {0.0, -0.1 * gh};
  landing.end[0].velocity = {0.0, opening * gh};
  for (auto& [id, blow] : stride.blows)
    blow.start.gap = 0.04 * gh * stride.h;
  return record_of(landing.system(), stride, landing.end);
}

TEST(StepBooks, WhatLandsSlowlyActsAndLosesFromThenOn) {
  const StepRecord record = record_of_slow_landing(0.0);
  for (const StepImpulse& p : record.impulses) {
    EXPECT_NEAR(p.begin, 0.2, 1e-14);
    EXPECT_EQ(p.end, 1.0);
  }
  ASSERT_FALSE(record.components[0].losses.empty());
  const StepLoss& loss = record.components[0].losses.front();
  EXPECT_NEAR(loss.by(0.6), 0.5 * loss.energy, 1e-14);
  EXPECT_EQ(loss.by(0.1), 0.0);
  EXPECT_EQ(loss.by(1.0), loss.energy);
}

TEST(StepBooks, WhatBouncesActsAtOnce) {
  for (const StepImpulse& p : record_of_slow_landing(0.1).impulses) {
    EXPECT_NEAR(p.begin, 0.2, 1e-14);
    EXPECT_EQ(p.end, p.begin);
  }
}

TEST(StepBooks, ImpactsHappenWhenTheGapCloses) {
  const Landing landing;
  const std::vector<Event> events = impacts_of(landing.system(), landing.stride, 3.0);
  ASSERT_EQ(events.size(), 2U);
  for (const Event& e : events) {
    EXPECT_NEAR(e.t, 3.04, 1e-14);
    EXPECT_NEAR(e.impulse, 0.5, 1e-16);
    EXPECT_EQ(e.on, "a");
    EXPECT_EQ(e.from, "floor");
  }
}

TEST(StepBooks, WhatAStepAddsToTheEnergyIsTakenBack) {
  Landing landing;
  landing.end[0].velocity = {0.7, 0.3};
  StepRecord record = record_of(landing.system(), landing.stride, landing.end);
  const double lost = sum_of(record.components[0].losses);
  State end = landing.end;
  // Along the ground nothing that the ground does can have changed the motion.
  const Rise rise = restore_energy(landing.system(), landing.stride, false, record, end);
  EXPECT_EQ(rise.unpaid, 0.0);
  EXPECT_NEAR(rise.whole, 0.5 * (0.49 + 0.09) - (0.5 - lost), 1e-14);
  EXPECT_EQ(end[0].velocity.x(), 0.7);
  EXPECT_LT(std::abs(end[0].velocity.y()), 0.3);
  State swaying = landing.end;
  restore_energy(landing.system(), landing.stride, true, record, swaying);
  EXPECT_EQ(swaying[0].velocity.y(), 0.3);
}

/// Without restitution and without weight: it opens at `speed` g h from the ground that it stands on, and comes back.
double loss_of_opening(double speed) {
  Landing landing;
  Stride& stride = landing.stride;
  stride.start[0].position.y() = stride.before[0].position.y() = 0.5;
  stride.start[0].velocity = {0.0, speed * stride.scales.gravity * stride.h};
  stride.half = stride.start;
  stride.before[0].velocity = {0.0, -1.0};
  for (auto& [id, blow] : stride.blows) {
    blow.start.gap = blow.end.gap = 0.0;
    blow.first.setZero();
    blow.second = {0.0, 0.5};
  }
  return sum_of(record_of(landing.system(), stride, landing.end).components.front().losses);
}

TEST(StepBooks, WhatOpensAndLandsIsLostWhatLastsIsSway) {
  EXPECT_NEAR(loss_of_opening(0.1), 0.5, 1e-14);
  EXPECT_EQ(loss_of_opening(1e-3), 0.0);
}

TEST(StepBooks, WhatVelocitiesDoNotTakeBackIsLostByWhatLanded) {
  Landing landing;
  StepRecord record = record_of(landing.system(), landing.stride, landing.end);
  std::vector<StepLoss>& losses = record.components[0].losses;
  losses = {{0.4, 0.4, 0.1}};
  restore_energy(landing.system(), landing.stride, false, record, landing.end);
  ASSERT_EQ(losses.size(), 1U);
  EXPECT_NEAR(losses[0].energy, 0.5, 1e-15);  // it stands still
  losses = {{0.0, 1.0, 0.1, true}};
  restore_energy(landing.system(), landing.stride, false, record, landing.end);
  EXPECT_EQ(sum_of(losses), 0.1);  // nothing landed: a drift, which is not hidden
}

TEST(StepBooks, WhatNoMotionCanPayForIsSaid) {
  Landing landing;
  StepRecord record = record_of(landing.system(), landing.stride, landing.end);
  record.components[0].losses.clear();
  landing.stride.start[0].velocity.setZero();
  landing.end[0].velocity = {0.3, 0.4};
  const Rise rise = restore_energy(landing.system(), landing.stride, false, record, landing.end);
  EXPECT_NEAR(rise.whole, 0.125, 1e-15);
  EXPECT_NEAR(rise.unpaid, 0.045, 1e-15);  // along the ground
  EXPECT_EQ(landing.end[0].velocity.y(), 0.0);
}

TEST(CloseGaps, ClosesThoseThatCarriedLoad) {
  const Mechanism m(on_floor({cube("a", {0.0, 0.5 + 1e-6}), cube("b", {3.0, 0.5 + 1e-6})}));
  ContactFinder finder;
  std::vector<Contact> contacts;
  finder.find(m.system, m.state, contacts, 1e-5);
  std::erase_if(contacts, [](const Contact& c) { return c.on == 1; });
  ClosedContacts closed(m.system);
  State state = m.state;
  close_gaps(contacts, closed, finder, state);
  EXPECT_NEAR(state[0].position.y(), 0.5, 1e-15);
  EXPECT_EQ(state[1].position.y(), 0.5 + 1e-6);
}

TEST(CloseGaps, LeavesWhatCannotBeClosed) {
  //   ###+---+ ###    the posts stand 2e-6 m farther apart than the block is wide
  //   ###| a | ###
  Scene scene;
  scene.fixed = {post("left", {-1.0 - 1e-6, 0.0}, {1.0, 3.0}),
                 post("right", {1.0 + 1e-6, 0.0}, {1.0, 3.0})};
  scene.cubes = {cube("a", {0.0, 0.0})};
  const Mechanism m(scene);
  ContactFinder finder;
  std::vector<Contact> contacts;
  finder.find(m.system, m.state, contacts, 1e-5);
  ASSERT_EQ(contacts.size(), 4U);
  ClosedContacts closed(m.system);
  State state = m.state;
  close_gaps(contacts, closed, finder, state);
  EXPECT_EQ(state[0].position, m.state[0].position);
}

}  // namespace
}  // namespace wuerfel::test
