// Scenes with friction that people know, and what no motion with friction may do.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/check.h"
#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

constexpr double ten_hours = 36000.0;

MotionSettings whole_steps(double step) {
  constexpr double bears_all = 1.0;  // no step is halved
  return {.integrator = Integrator::rattle, .tolerance = bears_all, .step = step};
}

/// Unit cubes one on the other on a slope that rises to the right by `angle`; friction is that of
/// `share` of the slope's tangent over 1.
///
///            [ ]
///           [ ]  .
///          [ ] .'
///            .'
Scene tower_on_slope(int count, double angle, double share) {
  const Vec2 normal(-std::sin(angle), std::cos(angle));
  Scene scene;
  for (int k = 0; k < count; ++k)
    scene.cubes.push_back(cube("c" + std::to_string(k), (0.5 + k) * normal, angle));
  scene.planes = {{"slope", Vec2::Zero(), normal, {}}};
  set_friction(std::tan(angle) / share, scene);
  return scene;
}

/// A slender block on its right foot, about to rock:  /_/
Scene rocking_block(double turn) {
  const Vec2 foot(0.4 * std::cos(turn) + std::sin(turn), 0.4 * std::sin(turn) - std::cos(turn));
  Scene scene = on_floor({sized_cube("block", -foot, {0.8, 2.0}, turn)});
  set_friction(2.0, scene);
  return scene;
}

/// A ladder that slips at the wall and on the floor:  |\.
Scene slipping_ladder(double mu) {
  Scene scene = on_floor({sized_cube("ladder", {1.24, 1.63}, {4.0, 0.1}, -std::atan2(0.8, 0.6))});
  scene.planes.push_back({"wall", Vec2::Zero(), Vec2::UnitX(), {}});
  set_friction(mu, scene);
  return scene;
}

double distance(const State& a, const State& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(
        {worst, (a[i].position - b[i].position).norm(), std::abs(a[i].angle - b[i].angle)});
  }
  return worst;
}

State after(const Scene& scene, double t, const MotionSettings& settings = {}) {
  Simulation simulation(scene, settings);
  simulation.advance_to(t);
  return simulation.states();
}

void expect_same_bits(const State& a, const State& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].position, b[i].position) << i;
    EXPECT_EQ(a[i].angle, b[i].angle) << i;
    EXPECT_TRUE(b[i].velocity.isZero(0.0)) << i;
    EXPECT_EQ(b[i].spin, 0.0) << i;
  }
}

class Creep : public testing::TestWithParam<Integrator> {};

TEST_P(Creep, IsNone) {
  const MotionSettings settings{.integrator = GetParam()};
  for (const Scene& scene : {tower_on_slope(5, 0.12, 0.999), tower_on_slope(1, 0.3, 0.999999)}) {
    Simulation simulation(scene, settings);
    const State start = simulation.states();
    simulation.advance_to(ten_hours);
    expect_same_bits(start, simulation.states());
    EXPECT_LT(simulation.cost().steps, 10);
  }
}

TEST_P(Creep, IsNoneOnceWhatFellHasComeToRest) {
  const MotionSettings settings{.integrator = GetParam()};
  Scene scene = tower_on_slope(5, 0.12, 0.9);
  for (SceneCube& c : scene.cubes)
    c.position += 1e-3 * Vec2::UnitY();
  Simulation simulation(scene, settings);
  simulation.advance_to(2.0);
  const State rest = simulation.states();
  simulation.advance_to(ten_hours);
  expect_same_bits(rest, simulation.states());
}

INSTANTIATE_TEST_SUITE_P(Integrators,
                         Creep,
                         testing::Values(Integrator::automatic, Integrator::rattle),
                         [](const auto& test) {
                           return test.param == Integrator::rattle ? "rattle" : "automatic";
                         });

/// Ratios of what the places at time t change by when steps are halved, from 120 to 1920 a second.
void expect_order_two(const Scene& scene, double t) {
  std::vector<State> ends;
  for (const double rate : {120.0, 240.0, 480.0, 960.0, 1920.0})
    ends.push_back(after(scene, t, whole_steps(1.0 / rate)));
  for (std::size_t k = 2; k < ends.size(); ++k) {
    const double ratio = distance(ends[k - 2], ends[k - 1]) / distance(ends[k - 1], ends[k]);
    EXPECT_NEAR(ratio, 4.0, 0.4) << k;
  }
  EXPECT_LT(distance(ends.back(), after(scene, t)), 1e-5);
}

TEST(FrictionOrder, OfARockingBlockIsTwo) { expect_order_two(rocking_block(-0.2), 0.35); }
TEST(FrictionOrder, OfASlippingLadderIsTwo) { expect_order_two(slipping_ladder(0.2), 0.4); }

TEST(FrictionLimitsInMotion, HardlyAnyIsNone) {
  EXPECT_LE(distance(after(slipping_ladder(0.0), 0.4), after(slipping_ladder(1e-12), 0.4)), 1e-9);
  Scene scene = on_floor(tower(3));
  scene.cubes[0].velocity = Vec2(1.0, 0.0);
  const State none = after(scene, 0.3);
  set_friction(1e-12, scene);
  EXPECT_LE(distance(none, after(scene, 0.3)), 1e-9);
}

TEST(FrictionLimitsInMotion, AnyAmountGoes) {
  // With very much of it a block that is thrown along the floor tips over its front foot.
  Scene scene = on_floor({cube("a", {0.0, 0.5})});
  scene.cubes[0].velocity = Vec2(3.0, 0.0);
  set_friction(1e6, scene);
  Simulation simulation(scene, {});
  simulation.advance_to(5.0);
  EXPECT_TRUE(simulation.states()[0].velocity.isZero(0.0));
  EXPECT_LE(simulation.audit().max_overlap, 1e-9);
  EXPECT_LE(std::abs(simulation.audit().drift()), 1e-6);
}

TEST(FrictionLimitsInMotion, MassesMayDifferByAMillion) {
  for (const double ratio : {1e-6, 1e6}) {
    Scene scene = on_floor({cube("under", {0.0, 0.5}), cube("over", {0.1, 1.5 + 1e-3}, 0.0)});
    scene.cubes[1].mass = ratio;
    scene.cubes[1].velocity = Vec2(1.0, 0.0);
    set_friction(0.5, scene);
    Simulation simulation(scene, {});
    simulation.advance_to(3.0);
    EXPECT_LE(simulation.audit().max_overlap, 1e-9) << ratio;
    EXPECT_LE(simulation.audit().friction_residual, 1e-6) << ratio;
    EXPECT_LE(std::abs(simulation.audit().drift()), 1e-6 * simulation.audit().energy_start)
        << ratio;
    // A heavy cube rocks for a long time on a light one; a light one stops.
    if (ratio > 1.0) continue;
    for (const BodyState& s : simulation.states())
      EXPECT_TRUE(s.velocity.isZero(0.0)) << ratio;
  }
}

TEST(FrictionMotionSymmetry, MirrorImagesMoveAsMirrorImages) {
  Scene scene = on_floor({cube("a", {0.0, 0.9}, 0.3, 1.0), cube("b", {0.4, 2.2}, -0.2)});
  scene.cubes[0].velocity = Vec2(1.5, 0.0);
  set_friction(0.4, scene);
  Scene mirrored = scene;
  for (SceneCube& c : mirrored.cubes) {
    c.position.x() *= -1.0;
    c.velocity.x() *= -1.0;
    c.angle *= -1.0;
    c.spin *= -1.0;
  }
  State left = after(scene, 0.6);
  for (BodyState& s : left) {
    s.position.x() *= -1.0;
    s.angle *= -1.0;
  }
  EXPECT_LE(distance(left, after(mirrored, 0.6)), 1e-8);
}

TEST(FrictionMotionSymmetry, ScaleAndOrderDoNotMatter) {
  Scene scene = on_floor({cube("a", {0.0, 0.9}, 0.3, 1.0), cube("b", {0.4, 2.2}, -0.2)});
  scene.cubes[0].velocity = Vec2(1.5, 0.0);
  set_friction(0.4, scene);
  const State one = after(scene, 0.6);
  Scene scaled = scene;
  for (SceneCube& c : scaled.cubes) {
    c.position *= 4.0;
    c.size *= 4.0;
    c.velocity *= 2.0;
    c.spin *= 0.5;
    c.mass *= 3.0;
  }
  State large = after(scaled, 1.2);
  for (BodyState& s : large)
    s.position *= 0.25;
  EXPECT_LE(distance(one, large), 1e-8);
  std::swap(scene.cubes[0], scene.cubes[1]);
  const State swapped = after(scene, 0.6);
  EXPECT_LE(distance(one, {swapped[1], swapped[0]}), 1e-8);
}

TEST(RockingBlock, LosesWhatHousnerSays) {
  // Spin after a blow over that before, from the angular momentum about the new foot.
  //                            2 (b^2 + h^2 + ..) : (1 - 3/2 sin^2) with tan = b / h
  const double sine_square = 0.4 * 0.4 / (0.4 * 0.4 + 1.0);
  const double ratio = 1.0 - 1.5 * sine_square;
  Simulation simulation(rocking_block(-0.1), {});
  simulation.advance_to(4.0);
  const std::vector<Event>& events = simulation.events();
  ASSERT_EQ(events.back().kind, EventKind::rest);
  ASSERT_EQ(events[1].kind, EventKind::impact);
  // The energy of each rocking is ratio^2 of the last, and the impulses are in proportion to spins.
  EXPECT_NEAR(events[1].impulse / events[0].impulse, ratio, 1e-8);
  EXPECT_NEAR(events[6].impulse / events[5].impulse, ratio, 1e-8);
  EXPECT_TRUE(simulation.states()[0].velocity.isZero(0.0));
}

// A plank slides on its corner, with so much friction that no acceleration keeps the corner down (beyond mu = 1.3754):
// it jams at once, sticks, and turns about the corner.      \\ <-
TEST(Painleve, JamsAndGoesOnFromEventToEvent) {
  for (const double mu : {1.5, 2.0, 10.0}) {
    const Vec2 centre(0.36447538541943386, 0.9365669722039931);
    Scene scene = on_floor({sized_cube("plank", centre, {0.2, 2.0}, 1.1 - std::acos(0.0))});
    scene.cubes[0].velocity = Vec2(-1.0, 0.0);
    set_friction(mu, scene);
    Simulation simulation(scene, {});
    simulation.advance_to(0.0);
    ASSERT_FALSE(simulation.events().empty());
    EXPECT_EQ(simulation.events().front().kind, EventKind::jam);
    const double inertia = (0.2 * 0.2 + 2.0 * 2.0) / 12.0 + centre.squaredNorm();
    EXPECT_NEAR(simulation.states()[0].spin, centre.y() / inertia, 1e-12);
    simulation.advance_to(0.9);
    EXPECT_EQ(simulation.cost().hand_overs, 0);
    EXPECT_LE(distance(simulation.states(), after(scene, 0.9, {.tolerance = 1e-11})), 1e-8);
    EXPECT_LE(std::abs(simulation.audit().drift()), 1e-9);
  }
}

// A cube slides on another with so much friction that both would tip backwards and press the less the more they rub: no
// accelerations exist. The upper one sticks at once, and both turn as one about the lower corner ahead.     [] ->
TEST(Painleve, KickedCubeSticksAndTipsTheOneBelow) {
  for (const double mass : {1.0, 4.0}) {
    for (const double ahead : {1.0, -1.0}) {
      Scene scene = on_floor({cube("below", {0.0, 0.5}), cube("kicked", {0.0, 1.5})});
      scene.cubes[1].mass = mass;
      scene.cubes[1].velocity = Vec2(ahead, 0.0);
      set_friction(1.5, scene);
      Simulation simulation(scene, {});
      simulation.advance_to(0.0);
      ASSERT_FALSE(simulation.events().empty());
      EXPECT_EQ(simulation.events().front().kind, EventKind::jam);
      const double inertia = (1.0 / 6.0 + 0.5) + mass * (1.0 / 6.0 + 2.5);
      for (const BodyState& s : simulation.states())
        EXPECT_NEAR(s.spin, -ahead * mass * 1.5 / inertia, 1e-12);
    }
  }
}

TEST(HouseOfCards, StandsUntilItIsStruck) {
  Scene scene = shipped_scene("house_of_cards");
  Simulation struck(scene, {});
  const State start = struck.states();
  struck.advance_to(0.5);
  for (std::size_t i = 0; i + 1 < start.size(); ++i)
    EXPECT_EQ(start[i].position, struck.states()[i].position);
  struck.advance_to(3.0);
  EXPECT_GT(distance(start, struck.states()), 0.1);
  EXPECT_LE(struck.audit().max_overlap, 1e-9);
  scene.cubes.pop_back();  // the pebble
  EXPECT_EQ(check(scene, {}).verdict, Verdict::stands);
  set_friction(0.1, scene);
  EXPECT_EQ(check(scene, {}).verdict, Verdict::falls);
}

TEST(Jenga, StandsWithThePlankAndFallsWithout) {
  Scene scene = shipped_scene("jenga");
  EXPECT_EQ(check(scene, {}).verdict, Verdict::falls);
  SceneCube plank = scene.cubes.front();
  plank.name = "left3";
  plank.position.y() += 1.6;
  scene.cubes.push_back(plank);
  EXPECT_EQ(check(scene, {}).verdict, Verdict::stands);
}

// A crowd comes to rest with gaps that nobody sees. They are closed then, and what that takes is lost.
TEST(Crowd, LosesWhatItTakesToComeToRest) {
  const Scene bin = parse_scene(
      R"({"version": 1, "material": {"friction": 0.6}, "plane": [{}],
          "fixed": [{"size": [1, 18.5], "position": [-6.5, 9.25]}, {"size": [1, 18.5], "position": [6.5, 9.25]}],
          "pile": [{"count": 30, "size": 1, "seed": 2, "region": [-5.99, 0.01, 5.99, 9.25]}]})",
      "bin");
  Simulation simulation(bin, {});
  simulation.advance_to(4.0);
  EXPECT_EQ(simulation.events().back().kind, EventKind::rest);
  EXPECT_LE(std::abs(simulation.audit().drift()), 1e-9);
}

TEST(NewtonsRow, OnlyTheLastCubeLeaves) {
  Simulation simulation(shipped_scene("newton_row"), {});
  simulation.advance_to(1.0);
  const State& states = simulation.states();
  for (std::size_t i = 0; i + 1 < states.size(); ++i)
    EXPECT_LT(states[i].velocity.norm(), 0.3) << i;
  EXPECT_GT(states.back().velocity.x(), 3.0);
}

TEST(Groove, HoldsACubeOnItsCorner) {
  Simulation simulation(shipped_scene("groove"), {});
  const Vec2 keel = simulation.states()[0].position;
  simulation.advance_to(3.0);
  EXPECT_LE((keel - simulation.states()[0].position).norm(), 1e-9);
  EXPECT_LE(simulation.audit().max_overlap, 1e-9);
  EXPECT_LE(std::abs(simulation.audit().drift()), simulation.audit().drift_budget);
}

}  // namespace
}  // namespace wuerfel::test
