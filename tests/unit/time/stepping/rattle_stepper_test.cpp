// One step of time stepping, in closed form.
#include "core/time/stepping/rattle_stepper.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "core/dynamics/momentum.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

constexpr double h = 0.01;

/// A mechanism and the step that it takes.
struct Stepped {
  explicit Stepped(const Scene& scene, double sway = 0.0)
      : m(scene), stepper(m.system, {}, sway), taken(take()) {}
  Step take() {
    stepper.begin(m.state);
    return stepper.step(m.state, 2.0, h);
  }
  Mechanism m;
  RattleStepper stepper;
  Step taken;
};

/// In space: a flies at 1 m/s towards b, which is 0.005 m away and has three times its mass.
///   +---+  +---+
///   | a |->| b |
///   +---+  +---+
Scene collision() {
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.005, 0.0})};
  scene.cubes[0].velocity = {1.0, 0.0};
  scene.cubes[1].mass = 3.0;
  return scene;
}

TEST(RattleStepper, FreeFlightIsAParabola) {
  Scene scene;
  scene.cubes = {cube("a", {0.0, 5.0})};
  scene.cubes[0].velocity = {2.0, 1.0};
  scene.cubes[0].spin = 3.0;
  const Stepped s(scene);
  const BodyState& end = s.taken.state[0];
  EXPECT_NEAR(end.position.x(), 2.0 * h, 1e-16);
  EXPECT_NEAR(end.position.y(), 5.0 + h - 0.5 * 9.81 * h * h, 1e-15);
  EXPECT_NEAR(end.velocity.y(), 1.0 - 9.81 * h, 1e-15);
  EXPECT_EQ(end.spin, 3.0);
  EXPECT_LT(s.taken.error, 1e-14);
  EXPECT_EQ(s.taken.book.cost.qp_solves, 0);
  EXPECT_TRUE(s.taken.record->impulses.empty());
}

TEST(RattleStepper, WhatEnergyWasAstrayByIsPaidBack) {
  Scene scene = collision();
  for (SceneCube& c : scene.cubes)
    c.material.restitution = 1.0;
  const Mechanism m(scene);
  RattleStepper stepper(m.system, {}, 1e-4);
  stepper.begin(m.state);
  State faster = m.state;
  faster[0].velocity.x() = 1.01;
  EXPECT_NEAR(kinetic_energy(m.system, stepper.step(faster, 0.0, h).state), 0.5, 1e-14);
}

TEST(RattleStepper, WhatIsHaltedStandsWhereItWasAndHasLostItsMotion) {
  Stepped s(collision());
  const Step halted = s.stepper.halt(std::move(s.taken), 2.0);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(halted.state[i].position, s.m.state[i].position);
    EXPECT_TRUE(is_still(halted.state[i]));
  }
  ASSERT_EQ(halted.book.losses.size(), 1U);
  EXPECT_EQ(halted.book.losses[0].energy, 0.5);
  EXPECT_TRUE(halted.book.events.empty());
  EXPECT_EQ(halted.rise.unpaid, 0.0);
  EXPECT_NEAR(halted.book.settled.linear.x(), -1.0, 1e-15);
}

TEST(RattleStepper, TheGroundCarriesTheWeight) {
  const Stepped s(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.0, 1.5})}));
  Vec2 impulse = Vec2::Zero();
  for (const StepImpulse& p : s.taken.record->impulses) {
    if (!s.m.system.is_cube(p.from)) impulse += p.linear;
  }
  EXPECT_NEAR(impulse.x(), 0.0, 1e-15);
  EXPECT_NEAR(impulse.y(), 2.0 * 9.81 * h, 1e-11);
  for (int i = 0; i < 2; ++i) {
    // Gaps are kept open by 5e-11 m each.
    EXPECT_NEAR(s.taken.state[i].position.y(), 0.5 + i, 1.1e-10);
    EXPECT_NEAR(s.taken.state[i].velocity.y(), 0.0, 1e-10);
  }
  EXPECT_TRUE(s.taken.book.events.empty());
  EXPECT_EQ(s.stepper.loaded().size(), 4U);
}

TEST(RattleStepper, AnImpactSharesMomentumAndIsBookedWhenTheGapCloses) {
  const Stepped s(collision());
  EXPECT_NEAR(s.taken.state[0].velocity.x(), 0.25, 1e-14);
  EXPECT_NEAR(s.taken.state[1].velocity.x(), 0.25, 1e-14);
  ASSERT_EQ(s.taken.book.events.size(), 2U);
  double impulse = 0.0;
  for (const Event& e : s.taken.book.events) {
    EXPECT_EQ(e.kind, EventKind::impact);
    EXPECT_NEAR(e.t, 2.0 + 0.5 * h, 1e-14);
    impulse += e.impulse;
  }
  EXPECT_NEAR(impulse, 0.75, 1e-14);
  double lost = 0.0;
  for (const Loss& loss : s.taken.book.losses)
    lost += loss.energy;
  EXPECT_NEAR(lost, 0.375, 1e-14);
  EXPECT_LE(s.taken.overlap, overlap_share);
}

/// In space: a flies at 5 m/s towards b, turns and strikes it off its middle.
Scene glancing_blow(double mu, double e) {
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.4}, 0.3, 6.0), cube("b", {1.17, 0.0}, 0.0, -2.0)};
  scene.cubes[0].velocity = {5.0, -1.0};
  scene.cubes[1].mass = 3.0;
  for (SceneCube& c : scene.cubes)
    c.material = {mu, e};
  return scene;
}

struct Totals {
  Totals(const System& system, const State& state)
      : sums(momentum_of(system, state, std::vector{0, 1})),
        turning(sums.angular + det(sums.center, sums.linear)),
        in_motion(energy(system, state)) {}
  Momentum sums;
  double turning;  // about the origin
  double in_motion;
};

TEST(RattleStepper, WhatBouncesKeepsItsMomentaAndTheBooksClose) {
  for (const double mu : {0.0, 0.5}) {
    for (const double e : {0.0, 0.3, 0.9, 1.0}) {
      const Stepped s(glancing_blow(mu, e));
      ASSERT_FALSE(s.taken.book.events.empty());
      const Totals start(s.m.system, s.m.state);
      const Totals end(s.m.system, s.taken.state);
      EXPECT_LT((end.sums.linear - start.sums.linear).norm(), 1e-14);
      EXPECT_NEAR(end.turning, start.turning, 1e-13);
      double lost = 0.0;
      for (const Loss& loss : s.taken.book.losses)
        lost += loss.energy;
      EXPECT_NEAR(end.in_motion + lost, start.in_motion, 1e-13);
      EXPECT_GE(lost, -1e-13);
      if (mu == 0.0 && e == 1.0) {
        EXPECT_NEAR(lost, 0.0, 1e-13);
      }
    }
  }
}

/// A tilted cube in the corner of a floor and a wall that rub: it leans against the wall with one corner and stands on
/// the next one.
Scene corner(double mu) {
  const double center = 0.4 * (std::cos(0.4) + std::sin(0.4));
  Scene scene = on_floor({sized_cube("a", {center, center}, {0.8, 0.8}, -0.4)});
  scene.planes.push_back({"wall", Vec2::Zero(), Vec2::UnitX(), {}});
  for (ScenePlane& plane : scene.planes)
    plane.material.friction = mu;
  scene.cubes[0].material.friction = mu;
  return scene;
}

TEST(RattleStepper, GapsAreNotOpenedAgainstFriction) {
  for (const double mu : {1.0, 10.0, 1e6}) {
    const Stepped s(corner(mu));
    EXPECT_EQ(s.taken.book.audit.friction_inexact, 0);
    EXPECT_NEAR(s.taken.state[0].angle, -0.4, 1e-12);
    EXPECT_LT(s.taken.state[0].velocity.norm(), 1e-10);
  }
}

TEST(RattleStepper, NoStepIsLongerThanHalfTheThinnestBody) {
  const Mechanism m(collision());
  const RattleStepper stepper(m.system, {}, 0.0);
  EXPECT_NEAR(stepper.longest_step(m.state), 0.25, 1e-15);
  Scene falling = on_floor({cube("a", {0.0, 3.0})});
  const Mechanism f(falling);
  const double longest = RattleStepper(f.system, {}, 0.0).longest_step(f.state);
  EXPECT_NEAR(9.81 * longest * longest, 0.25, 1e-15);
}

TEST(RattleStepper, StoppedShortNothingOverlaps) {
  Stepped s(collision());
  const Step stopped = s.stepper.stop_short(s.taken, 2.0);
  EXPECT_LE(stopped.overlap, overlap_share);
  const Vec2 momentum = stopped.state[0].velocity + 3.0 * stopped.state[1].velocity;
  EXPECT_NEAR(momentum.x(), 1.0, 1e-14);
}

TEST(RattleStepper, GapsUnderLoadAreClosedAtTheEnd) {
  Stepped s(on_floor({cube("a", {0.0, 0.5})}));
  State lifted = s.taken.state;
  lifted[0].position.y() = 0.5 + 1e-6;
  s.stepper.close_gaps(lifted);
  EXPECT_NEAR(lifted[0].position.y(), 0.5, 1e-15);
}

}  // namespace
}  // namespace wuerfel::test
