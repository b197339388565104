// Accelerations and loads under closed contacts, in closed form.
#include "core/time/events/equations_of_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/phases.h"

namespace wuerfel::test {
namespace {

/// The equations of a mechanism's first phase, evaluated at its start.
struct Evaluated {
  explicit Evaluated(const Scene& scene) : b(scene), equations(b.m.system) {
    equations.close(b.now.modes.closed, b.now.modes.resting);
    std::vector<double> y;
    pack(b.now.state, y);
    equations(y, rate);
    equations.find_loads(loads);
  }
  Begun b;
  EquationsOfMotion equations;
  std::vector<double> rate;
  std::vector<double> loads;
};

TEST(EquationsOfMotion, OfFreeFallAreGravity) {
  const Evaluated e(thrown());
  EXPECT_TRUE(e.equations.free());
  EXPECT_EQ(e.rate, (std::vector<double>{1.0, 2.0, 0.0, 0.0, -g, 0.0}));
  EXPECT_TRUE(e.loads.empty());
  EXPECT_EQ(e.equations.pushed().linear, Vec2::Zero());
}

TEST(EquationsOfMotion, OnASlopeOfThreeInFour) {
  const Evaluated e(slide());
  EXPECT_FALSE(e.equations.free());
  EXPECT_TRUE(e.equations.on_fixed());
  EXPECT_FALSE(e.equations.redundant());
  // 0.6 g along (0.8, -0.6), and the two corners share 0.8 m g.
  EXPECT_NEAR(e.rate[3], 0.6 * g * 0.8, 1e-13);
  EXPECT_NEAR(e.rate[4], -0.6 * g * 0.6, 1e-13);
  EXPECT_NEAR(e.rate[5], 0.0, 1e-13);
  ASSERT_EQ(e.loads.size(), 2U);
  EXPECT_NEAR(e.loads[0], 0.4 * g, 1e-13);
  EXPECT_NEAR(e.loads[1], 0.4 * g, 1e-13);
  EXPECT_NEAR((e.equations.pushed().linear - 0.8 * g * Vec2(0.6, 0.8)).norm(), 0.0, 1e-13);
  EXPECT_EQ(e.equations.first_slip(e.loads), 2) << "all of them are forces";
}

TEST(EquationsOfMotion, WhatSlipsIsBrakedAndItsSpeedIsWatched) {
  Scene scene = slide();
  for (Material* m : {&scene.cubes[0].material, &scene.planes[0].material})
    m->friction = 0.25;
  scene.cubes[0].velocity = 2.0 * Vec2(0.8, -0.6);
  const Evaluated e(scene);
  EXPECT_TRUE(e.equations.slips());
  EXPECT_TRUE(e.equations.rubs());
  // (0.6 - 0.25 0.8) g down the slope.
  EXPECT_NEAR(std::hypot(e.rate[3], e.rate[4]), 0.4 * g, 1e-12);
  const int first = e.equations.first_slip(e.loads);
  ASSERT_EQ(first + 1, std::ssize(e.loads));
  EXPECT_NEAR(e.loads[first], 2.0, 1e-14);
}

TEST(EquationsOfMotion, FrictionDrivesWhatSlipsAndIsHeldDown) {
  Scene scene = on_floor({cube("a", {0.0, 0.5})});
  for (Material* m : {&scene.cubes[0].material, &scene.planes[0].material})
    m->friction = 0.25;
  scene.cubes[0].velocity = {2.0, 0.0};
  Evaluated e(scene);
  EXPECT_FALSE(e.equations.friction_drives(1e-9));
  // Corners that go round the centre stay on the floor while that falls by omega^2 / 2.
  State turning = e.b.now.state;
  turning[0].spin = 1.1 * std::sqrt(2.0 * g);
  std::vector<double> y;
  pack(turning, y);
  e.equations(y, e.rate);
  EXPECT_TRUE(e.equations.friction_drives(1e-9));
}

TEST(EquationsOfMotion, ContactsContradictWhereWhatCarriesAPlankTurns) {
  // A plank on three cubes that slide along the floor: two of them would do.
  Scene scene = on_floor({cube("a", {-2.0, 0.5}), cube("b", {0.0, 0.5}), cube("c", {2.0, 0.5}),
                          cube("plank", {0.0, 1.5})});
  scene.planes[0].material.friction = 0.25;
  for (SceneCube& c : scene.cubes) {
    c.material.friction = 1.0;
    c.velocity = {2.0, 0.0};
  }
  scene.cubes.back().size = {6.0, 1.0};
  Evaluated e(scene);
  EXPECT_TRUE(e.equations.redundant());
  EXPECT_FALSE(e.equations.contradict());
  // The top of what turns on the floor falls by omega^2.
  State turning = e.b.now.state;
  turning[1].spin = 0.1;
  std::vector<double> y;
  pack(turning, y);
  e.equations(y, e.rate);
  EXPECT_TRUE(e.equations.contradict());
}

TEST(EquationsOfMotion, ARodKeepsItsLengthToSecondOrder) {
  // A pendulum at 30 degrees from below, turning at 2 rad/s: -g sin across, v^2 / l along the rod.
  Scene scene;
  const Vec2 down(0.5, -std::sqrt(0.75));
  scene.points.push_back({"bob", 2.0, down, 2.0 * perp(down), {}});
  scene.rods.push_back({"rod", {"bob", Vec2::Zero()}, {"", Vec2::Zero()}, 1.0});
  const Evaluated e(scene);
  const Vec2 a(e.rate[3], e.rate[4]);
  EXPECT_NEAR(a.dot(perp(down)), -0.5 * g, 1e-13);
  EXPECT_NEAR(a.dot(down), -4.0, 1e-13);
  EXPECT_FALSE(e.equations.free());
}

}  // namespace
}  // namespace wuerfel::test
