// Looks into a step that is made up by hand.
#include "core/time/stepping/step_look.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// A cube without weight comes down at 1 m/s and is stopped by two blows, at 0.4 and at 0.6 of a step of 0.1 s.
///
///     0.55  \        |
///     0.51   \_      |
///     0.50     \____ |
///     share  0 .4 .6 1
TEST(StepLook, FliesFromBlowToBlow) {
  Scene scene = on_floor({cube("a", {0.0, 0.55})});
  scene.gravity = Vec2::Zero();
  scene.cubes[0].velocity = {0.0, -1.0};
  const Mechanism m(scene);
  const State from = m.state;
  State to = from;
  to[0].position.y() = 0.5;
  to[0].velocity.setZero();
  StepRecord record;
  for (const double share : {0.4, 0.6})
    record.impulses.push_back({0, 1, {0.0, 0.5}, 0.0, 0.0, share, share});
  record.components = {{{0}, {Vec2::UnitY()}, {{0.4, 0.4, 0.375}, {0.6, 0.6, 0.125}}}};
  StepLook look(m.system, {});
  const auto expect = [&](double share, double height, double velocity) {
    const State state = look.at(from, to, 0.1, share, record);
    EXPECT_NEAR(state[0].position.y(), height, 1e-10) << share;
    EXPECT_NEAR(state[0].velocity.y(), velocity, 1e-10) << share;
  };
  expect(0.2, 0.53, -1.0);
  expect(0.5, 0.505, -0.5);
  expect(0.8, 0.5, 0.0);
}

/// a strikes b, which passes the blow on to c: what comes from both sides at 0.3 and 0.7 of the step is one blow, in which b is
/// never as fast as by the first part alone, 10 m/s.
///
///     [a]-> [b][c]
TEST(StepLook, PassesABlowOnAtOnce) {
  Scene scene;
  scene.gravity = Vec2::Zero();
  for (const double x : {-0.1, 1.0, 2.0})
    scene.cubes.push_back(cube("c" + std::to_string(scene.cubes.size()), {x, 0.0}));
  scene.cubes[0].velocity = {14.0, 0.0};
  const Mechanism m(scene);
  State to = m.state;
  const double velocities[] = {4.0, 0.1, 9.9};
  for (int i = 0; i < 3; ++i) {
    to[i].velocity = {velocities[i], 0.0};
    to[i].position.x() += 0.01 * velocities[i];
  }
  StepRecord record;
  record.impulses = {{1, 0, {10.0, 0.0}, 0.0, 0.0, 0.3, 0.3},
                     {1, 2, {-9.9, 0.0}, 0.0, 0.0, 0.7, 0.7}};
  record.components = {{{0, 1, 2}, {}, {{0.7, 0.7, 41.0}}}};
  StepLook look(m.system, {});
  for (const double share : {0.2, 0.5, 0.8}) {
    const State state = look.at(m.state, to, 0.01, share, record);
    EXPECT_NEAR(state[0].velocity.x() + state[1].velocity.x() + state[2].velocity.x(), 14.0, 1e-12);
    EXPECT_LE(std::abs(state[1].velocity.x()), 0.11) << share;
  }
}

}  // namespace
}  // namespace wuerfel::test
