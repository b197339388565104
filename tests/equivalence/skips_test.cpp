// Each skip of work changes no answer: motion with and without it.
#include <cmath>

#include <gtest/gtest.h>

#include "core/time/simulation.h"

namespace wuerfel::test {
namespace {

constexpr double same_motion = 1e-9;

SceneCube cube(const std::string& name,
               const Vec2& position,
               double angle = 0.0,
               double spin = 0.0) {
  SceneCube c;
  c.name = name;
  c.position = position;
  c.angle = angle;
  c.spin = spin;
  return c;
}

/// A standing tower, a toppling pair, a cube that drops onto the tower's neighbour, and one in free
/// flight.
Scene mixed() {
  Scene scene;
  scene.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY(), {}});
  for (int i = 0; i < 4; ++i)
    scene.cubes.push_back(cube("t" + std::to_string(i), {0.1 * (i % 2), 0.5 + i}));
  scene.cubes.push_back(cube("low", {3.0, 0.5}));
  scene.cubes.push_back(cube("high", {3.6, 1.5}));
  scene.cubes.push_back(cube("base", {6.0, 0.5}));
  scene.cubes.push_back(cube("drop", {6.3, 2.0}, 0.2, 0.5));
  scene.cubes.push_back(cube("free", {9.0, 8.0}, 0.1, 2.0));
  return scene;
}

struct Switch {
  const char* name;
  bool Skips::*flag;
};

class Skip : public testing::TestWithParam<Switch> {};

TEST_P(Skip, DoesNotChangeTheMotion) {
  MotionSettings without;
  without.skips.*GetParam().flag = false;
  Simulation a(mixed(), {});
  Simulation b(mixed(), without);
  for (int k = 1; k <= 10; ++k) {
    a.advance_to(0.08 * k);
    b.advance_to(0.08 * k);
    for (std::size_t i = 0; i < a.states().size(); ++i) {
      EXPECT_NEAR((a.states()[i].position - b.states()[i].position).norm(), 0.0, same_motion) << i;
      EXPECT_NEAR(a.states()[i].angle, b.states()[i].angle, same_motion) << i;
      EXPECT_NEAR((a.states()[i].velocity - b.states()[i].velocity).norm(), 0.0, 1e3 * same_motion)
          << i;
    }
  }
  EXPECT_EQ(a.audit().missed_solves, 0);
  EXPECT_EQ(b.audit().missed_solves, 0);
}

INSTANTIATE_TEST_SUITE_P(All,
                         Skip,
                         testing::Values(Switch{"free_bodies", &Skips::free_bodies},
                                         Switch{"islands", &Skips::islands},
                                         Switch{"rest", &Skips::rest},
                                         Switch{"certificate", &Skips::certificate},
                                         Switch{"warm_start", &Skips::warm_start}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Skips, AreCountedByReason) {
  Simulation simulation(mixed(), {});
  simulation.advance_to(0.5);
  EXPECT_GT(simulation.cost().skipped_free, 0);
  EXPECT_GT(simulation.cost().skipped_rest, 0);
  EXPECT_EQ(simulation.cost().qp_skipped(), simulation.cost().skipped_free
                                                + simulation.cost().skipped_rest
                                                + simulation.cost().skipped_certificate);
}

}  // namespace
}  // namespace wuerfel::test
