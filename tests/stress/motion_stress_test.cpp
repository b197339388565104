// Scenes that break simulators: nothing hangs, overlaps, tunnels or stops being a number.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/time/simulation.h"
#include "tests/support/bin_scene.h"
#include "tests/support/max_norm.h"
#include "tests/support/parameter_names.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// Runs to `t` in looks and checks what must hold at each.
void run_and_check(const Scene& scene, double t, double size = 1.0, MotionSettings settings = {}) {
  Simulation simulation(scene, settings);
  constexpr int looks = 60;
  for (int k = 1; k <= looks; ++k) {
    simulation.advance_to(t * k / looks);
    (void)simulation.snapshot({});
    for (const BodyState& s : simulation.states()) {
      ASSERT_TRUE(s.position.allFinite() && s.velocity.allFinite());
      ASSERT_TRUE(std::isfinite(s.angle) && std::isfinite(s.spin));
    }
  }
  const Audit audit = simulation.audit();
  EXPECT_LE(audit.max_penetration, 1e-9 * size);
  EXPECT_EQ(audit.missed_solves, 0);
  EXPECT_GE(audit.impact_loss, -1e-9 * std::abs(audit.energy_start));
}

TEST(Gallery, ACornerFallsOnACorner) {
  Scene scene = on_floor({cube("low", {0.0, 0.5}), cube("high", {1.0, 2.5})});
  run_and_check(scene, 2.0);
  scene.cubes[1].angle = 0.7853981633974483;
  scene.cubes[1].position.x() = 0.5;
  run_and_check(scene, 2.0);
}

TEST(Gallery, AnEdgeSlidesPastTheEndOfAnEdge) {
  Scene scene = on_floor({cube("low", {0.0, 0.5}), cube("high", {0.0, 1.5})});
  scene.cubes[1].velocity = {1.5, 0.0};
  run_and_check(scene, 2.5);
}

TEST(Gallery, AGridFallsAsOne) {
  Scene scene = on_floor({});
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      scene.cubes.push_back(cube("c" + std::to_string(4 * i + j), {1.0 * i, 1.5 + j}));
  }
  run_and_check(scene, 1.0);
}

// What opens slowly and is closed at once must not push its neighbours into each other.
TEST(Gallery, ACubeOfARowOfHairsGapsIsStruck) {
  Scene scene = on_floor({});
  for (int i = 0; i < 3; ++i)
    scene.cubes.push_back(cube("c" + std::to_string(i), {1.000001 * i, 0.5}));
  scene.cubes[0].velocity = {0.4877030254080905, 1.5077289536308882};
  run_and_check(scene, 2.0);
}

TEST(Gallery, AGridIsStruckAtItsCorner) {
  Scene scene = on_floor({});
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 4; ++i)
      scene.cubes.push_back(cube("c" + std::to_string(4 * j + i), {1.01 * i, 0.5 + 1.01 * j}));
  }
  scene.cubes[0].velocity = {-2.663403401246828, 0.4695798288163546};
  run_and_check(scene, 2.0);
}

TEST(Gallery, AnExactlyFittingBinHoldsItsSquares) {
  Scene scene = on_floor({});
  scene.fixed.push_back({"left", {1.0, 6.0}, {-0.5, 3.0}, 0.0, {}});
  scene.fixed.push_back({"right", {1.0, 6.0}, {3.5, 3.0}, 0.0, {}});
  for (int i = 0; i < 9; ++i) {
    const int row = i / 3;
    scene.cubes.push_back(cube("c" + std::to_string(i), {0.5 + i % 3, 0.5 + 1.001 * row}));
  }
  run_and_check(scene, 1.0);
}

class HairsGap : public testing::TestWithParam<double> {};

TEST_P(HairsGap, ACubeDropsFlatOnTwoOthers) {
  const double gap = GetParam();
  Scene scene = on_floor({cube("left", {-0.5 - gap / 2, 0.5}), cube("right", {0.5 + gap / 2, 0.5}),
                          cube("top", {0.0, 1.5 + gap})});
  run_and_check(scene, 1.0);
  scene.cubes[2].position.y() = 2.0;
  run_and_check(scene, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Gaps,
                         HairsGap,
                         testing::Values(0.0, 1e-14, 1e-12, 1e-10, 1e-9, 1e-8, 1e-6),
                         name_of_number<double>);

TEST(Gallery, ASquareThatSpinsHitsACorner) {
  Scene scene = on_floor({cube("low", {0.0, 0.5}), cube("spinning", {0.9, 2.3})});
  scene.cubes[1].spin = 1000.0;
  run_and_check(scene, 1.0);
}

TEST(Gallery, NothingTunnelsAtTwoHundredMetresPerSecond) {
  for (const bool fixed : {true, false}) {
    for (const Integrator integrator : {Integrator::automatic, Integrator::rattle}) {
      Scene scene;
      scene.gravity = Vec2::Zero();
      scene.cubes.push_back(sized_cube("bullet", {0.0, 0.0}, {0.1, 0.1}));
      scene.cubes[0].velocity = {200.0, 0.0};
      if (fixed) {
        scene.fixed.push_back({"wall", {0.02, 5.0}, {5.0, 0.0}, 0.0, {}});
      } else {
        scene.cubes.push_back(cube("wall", {5.0, 0.0}));
        scene.cubes[1].size = {0.02, 5.0};
        scene.cubes[1].mass = 1000.0;
      }
      Simulation simulation(scene, {.integrator = integrator});
      simulation.advance_to(0.1);
      const double wall = fixed ? 5.0 : simulation.states()[1].position.x();
      EXPECT_LE(simulation.states()[0].position.x(), wall - 0.06 + 1e-9) << to_string(integrator);
      EXPECT_LE(simulation.audit().max_penetration, 1e-11);
    }
  }
}

/// A tower that leans and falls on a block, and a tilted drop.
Scene some_motion(double scale = 1.0, const Vec2& shift = Vec2::Zero(), bool mirrored = false) {
  Scene scene;
  const double m = mirrored ? -1.0 : 1.0;
  const auto at = [&](double x, double y) -> Vec2 {
    return Vec2(m * x * scale, y * scale) + shift;
  };
  scene.planes.push_back({"floor", shift, Vec2::UnitY(), {}});
  for (int i = 0; i < 3; ++i) {
    scene.cubes.push_back(
        sized_cube("c" + std::to_string(i), at(0.375 * i, 0.5 + i), {scale, scale}));
  }
  scene.cubes.push_back(sized_cube("drop", at(3.0, 2.0), {scale, scale}));
  scene.cubes[3].angle = m * 0.25;
  return scene;
}

State final_state(const Scene& scene, double t, double tolerance = 1e-8) {
  Simulation simulation(scene, {.tolerance = tolerance});
  simulation.advance_to(t);
  return simulation.states();
}

constexpr double end = 0.9;

TEST(Invariance, ScaledScenesGiveTheScaledMotion) {
  const State unit = final_state(some_motion(), end);
  for (const double scale : {0x1p-20, 0x1p-10, 0x1p10, 0x1p20}) {
    State scaled = final_state(some_motion(scale), end * std::sqrt(scale));
    for (BodyState& s : scaled)
      s.position /= scale;
    EXPECT_LE(distance(unit, scaled), 1e-8) << scale;
  }
}

TEST(Invariance, MirroredScenesGiveTheMirroredMotion) {
  const State right = final_state(some_motion(), end);
  State left = final_state(some_motion(1.0, Vec2::Zero(), true), end);
  for (BodyState& s : left) {
    s.position.x() = -s.position.x();
    s.angle = -s.angle;
  }
  EXPECT_LE(distance(right, left), 1e-8);
}

TEST(Invariance, OrderOfBodiesDoesNotMatter) {
  const State before = final_state(some_motion(), end);
  Scene scene = some_motion();
  std::reverse(scene.cubes.begin(), scene.cubes.end());
  State after = final_state(scene, end);
  std::reverse(after.begin(), after.end());
  EXPECT_LE(distance(before, after), 1e-8);
}

TEST(Invariance, AMillionMetresAwayTheMotionIsTheSame) {
  const Vec2 shift(1e6, 1e6);
  const State here = final_state(some_motion(), end, 1e-6);
  State there = final_state(some_motion(1.0, shift), end, 1e-6);
  for (BodyState& s : there)
    s.position -= shift;
  EXPECT_LE(distance(here, there), 1e-6);
}

TEST(Invariance, GravityMayPointAnywhere) {
  Scene turned = some_motion();
  turned.gravity = {9.81, 0.0};
  turned.planes[0].normal = -Vec2::UnitX();
  for (SceneCube& c : turned.cubes)
    c.position = {-c.position.y(), c.position.x()};
  State sideways = final_state(turned, end);
  for (BodyState& s : sideways)
    s.position = {s.position.y(), -s.position.x()};
  EXPECT_LE(distance(final_state(some_motion(), end), sideways), 1e-8);
}

TEST(Invariance, WithoutGravityMomentumStays) {
  Scene scene;
  scene.gravity = Vec2::Zero();
  for (int i = 0; i < 6; ++i) {
    scene.cubes.push_back(cube("c" + std::to_string(i), {1.3 * i, 0.2 * (i % 2)}));
    scene.cubes.back().velocity = {2.0 - i, 0.0};
    scene.cubes.back().angle = 0.3 * i;
  }
  Vec2 before = Vec2::Zero();
  for (const SceneCube& c : scene.cubes)
    before += c.mass * c.velocity;
  const State state = final_state(scene, 3.0);
  Vec2 after = Vec2::Zero();
  for (std::size_t i = 0; i < state.size(); ++i)
    after += scene.cubes[i].mass * state[i].velocity;
  EXPECT_LE((after - before).norm(), 1e-10);
}

class Bin : public testing::TestWithParam<int> {};

TEST_P(Bin, OfRandomSquaresNeverOverlaps) {
  run_and_check(bin_scene(12, 4.0, 14.0, GetParam()), 3.0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Bin, testing::Range(1, 9), name_of_number<int>);

}  // namespace
}  // namespace wuerfel::test
