// Looks into a step that is made up by hand.
#include "core/time/stepping/step_look.h"

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

}  // namespace
}  // namespace wuerfel::test
