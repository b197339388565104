// Which contacts stay closed, on mechanisms whose answer is known.
#include "core/time/events/contact_modes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// The one island of a mechanism and its modes.
struct Modes {
  Island island;
  IslandModes modes;
  bool rests = false;

  /// Whether the contact near a place stays closed.
  [[nodiscard]] bool closed_at(const Vec2& place) const {
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      if ((island.contacts[k].point - place).norm() < 1e-6) return modes.closed[k] != 0;
    }
    ADD_FAILURE() << "no contact at " << place.transpose();
    return false;
  }
  [[nodiscard]] int closed() const { return static_cast<int>(std::ranges::count(modes.closed, 1)); }
};

Modes modes_of(const Mechanism& m, bool after_impact = false) {
  Workspace work(m.system, {});
  const std::vector<Island> islands = islands_at(m.state, ContactLimits{}.touching, work);
  EXPECT_EQ(islands.size(), 1U);
  const Scales scales = scales_of(m.system, m.state);
  Modes result;
  result.island = islands.at(0);
  result.rests = rests(result.island, m.state, scales, {}, work);
  result.modes = find_modes(result.island, m.state, scales, after_impact, work);
  return result;
}

TEST(ContactModes, ABlockBeyondTheEdgeTipsAboutIt) {
  //      +-------------+
  //      |      .      |        centre at x = 0.2
  //   +--o------x------+
  //   |  opens  stays
  //   | table   | x = 0
  Scene scene;
  scene.fixed.push_back(post("table", {-1.0, -0.5}, {2.0, 1.0}));
  scene.cubes = {sized_cube("a", {0.2, 0.5}, {2.0, 1.0})};
  const Modes found = modes_of(Mechanism(scene));
  EXPECT_FALSE(found.rests);
  EXPECT_FALSE(found.closed_at({-0.8, 0.0}));
  EXPECT_TRUE(found.closed_at({0.0, 0.0}));
}

TEST(ContactModes, ABlockWithItsCentreOverTheEdgeStands) {
  Scene scene;
  scene.fixed.push_back(post("table", {-1.0, -0.5}, {2.0, 1.0}));
  scene.cubes = {sized_cube("a", {0.0, 0.5}, {2.0, 1.0})};
  const Modes found = modes_of(Mechanism(scene));
  EXPECT_TRUE(found.rests);
  EXPECT_EQ(found.closed(), 2);
}

TEST(ContactModes, ARiderWhoseCentrePassesTheEdgeBeginsToTip) {
  //      +---------+
  //      |    .--> |     centre over the edge, moving out: neither force nor acceleration says yet
  //   +--o----x----+     that the left end opens
  //   | table |
  Scene scene;
  scene.fixed.push_back(post("table", {-1.0, -0.5}, {2.0, 1.0}));
  scene.cubes = {cube("a", {0.0, 0.5})};
  Mechanism m(scene);
  for (const double speed : {0.1, 1.0}) {
    m.state[0].velocity.x() = speed;
    const Modes out = modes_of(m);
    EXPECT_FALSE(out.closed_at({-0.5, 0.0}));
    EXPECT_TRUE(out.closed_at({0.0, 0.0}));
    m.state[0].velocity.x() = -speed;
    EXPECT_EQ(modes_of(m).closed(), 2) << "moving in it stays flat";
  }
}

TEST(ContactModes, ABeamOnTwoPostsStandsAndOneWithItsCentreOutsideTips) {
  //   +-----------------+
  //   +--x-----------x--+
  //     |p|         |q|
  Scene scene;
  scene.fixed = {post("p", {-1.0, -0.5}, {0.2, 1.0}), post("q", {1.0, -0.5}, {0.2, 1.0})};
  scene.cubes = {sized_cube("beam", {0.0, 0.1}, {3.0, 0.2})};
  const Modes stands = modes_of(Mechanism(scene));
  EXPECT_TRUE(stands.rests);
  EXPECT_EQ(stands.closed(), 4);
  scene.cubes[0].position.x() = 1.2;
  const Modes tips = modes_of(Mechanism(scene));
  EXPECT_FALSE(tips.rests);
  EXPECT_TRUE(tips.closed_at({1.1, 0.0})) << "the outer edge of q";
  EXPECT_EQ(tips.closed(), 1);
}

/// A thin ladder without friction between a wall (x = 0) and the floor, at `angle` above the floor,
/// sliding as energy says when it started from rest at `start`.
///
///   |\            Its middle moves on a circle: N_wall = m l/2 cos(a) (3/2 sin(a) - sin(start)) w,
///   | \           which vanishes at sin(a) = 2/3 sin(start), whatever its inertia.
///   |__\__
Mechanism ladder(double angle, double start) {
  const double length = 2.0;
  const double width = 1e-4;
  Scene scene;
  scene.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY(), {}});
  scene.planes.push_back({"wall", Vec2::Zero(), Vec2::UnitX(), {}});
  const Vec2 up(std::sin(angle), std::cos(angle));
  const Vec2 middle(0.5 * length * std::cos(angle), 0.5 * length * std::sin(angle));
  scene.cubes = {sized_cube("ladder", middle + 0.5 * width * up, {length, width}, -angle)};
  Mechanism m(scene);
  const Body& body = m.system.body(0);
  const double inertia = body.inertia + 0.25 * body.mass * length * length;
  const double rate =
      std::sqrt(body.mass * 9.81 * length * (std::sin(start) - std::sin(angle)) / inertia);
  // The angle falls, so the body turns counter-clockwise; the lower side's middle moves along it.
  BodyState& s = m.state[0];
  s.spin = rate;
  s.velocity =
      0.5 * length * rate * Vec2(std::sin(angle), -std::cos(angle)) + rate * perp(0.5 * width * up);
  return m;
}

TEST(ContactModes, ALadderLeavesTheWallAtTwoThirdsOfItsHeight) {
  const double start = 1.0;
  const double leaves = std::asin(2.0 / 3.0 * std::sin(start));
  EXPECT_EQ(modes_of(ladder(leaves + 1e-2, start)).closed(), 2);
  const Modes below = modes_of(ladder(leaves - 1e-2, start));
  EXPECT_EQ(below.closed(), 1);
  EXPECT_FALSE(below.closed_at({0.0, 2.0 * std::sin(leaves - 1e-2)}));
}

/// Bricks in running bond:
///
///     +---+---+
///   +-+-+-+-+-+-+
///   +---+---+---+
std::vector<SceneCube> bricks(int rows) {
  std::vector<SceneCube> cubes;
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < 3 - row % 2; ++k) {
      const double x = 2.0 * k + 1.0 * (row % 2);
      cubes.push_back(sized_cube("b" + std::to_string(cubes.size()), {x, 0.5 + row}, {2.0, 1.0}));
    }
  }
  return cubes;
}

TEST(ContactModes, ARedundantWallStandsWithAllItsContacts) {
  const Modes found = modes_of(Mechanism(on_floor(bricks(3))));
  EXPECT_TRUE(found.rests);
  EXPECT_EQ(found.closed(), static_cast<int>(found.island.contacts.size()));
  EXPECT_FALSE(found.modes.wedged);
}

TEST(ContactModes, NoGapOfARedundantWallWouldOpen) {
  const Mechanism m(on_floor(bricks(3)));
  Workspace work(m.system, {});
  work.finder.find(m.system, m.state);
  EXPECT_FALSE(would_open(m.state, work.finder.touches(), 1e-9, work));
  EXPECT_GT(work.solves.solved, 0);
}

TEST(ContactModes, AGapOfAWallWithAHeavyOverhangWouldOpen) {
  std::vector<SceneCube> cubes = bricks(2);
  cubes.push_back(sized_cube("over", {-1.2, 2.5}, {3.0, 1.0}));
  const Mechanism m(on_floor(cubes));
  Workspace work(m.system, {});
  work.finder.find(m.system, m.state);
  EXPECT_TRUE(would_open(m.state, work.finder.touches(), 0.1, work));
}

TEST(ContactModes, AfterAnImpactWhatOpensSlowlyUnderLoadIsClosed) {
  Mechanism m(on_floor({cube("a", {0.0, 0.5})}));
  m.state[0].spin = 1e-7;
  m.state[0].velocity = {0.0, 0.5e-7};
  EXPECT_EQ(modes_of(m, true).closed(), 2) << "the right end would rise by 1e-15 m and come back";
  m.state[0].spin = 1e-2;
  m.state[0].velocity = {0.0, 0.5e-2};
  EXPECT_EQ(modes_of(m, true).closed(), 1);
}

TEST(ContactModes, WhatMovesDoesNotRest) {
  Mechanism m(on_floor({cube("a", {0.0, 0.5})}));
  m.state[0].velocity.x() = 1e-6;
  EXPECT_FALSE(modes_of(m).rests);
  m.state[0].velocity.x() = 1e-10;
  EXPECT_TRUE(modes_of(m).rests);
}

TEST(ContactModes, AllWouldRestWhereEachIslandDoesAndNothingFalls) {
  const auto would = [](const Scene& scene) {
    const Mechanism m(scene);
    Workspace work(m.system, {});
    return would_rest(m.state, {}, work);
  };
  EXPECT_TRUE(
      would(on_floor({cube("a", {0.0, 0.5}), cube("b", {3.0, 0.5}), cube("c", {3.2, 1.5})})));
  EXPECT_FALSE(
      would(on_floor({cube("a", {0.0, 0.5}), cube("b", {3.0, 0.5}), cube("c", {3.6, 1.5})})));
  EXPECT_FALSE(would(on_floor({cube("a", {0.0, 0.5}), cube("b", {3.0, 2.5})})));
  Scene moves = on_floor({cube("a", {0.0, 0.5}), cube("b", {3.0, 0.5})});
  moves.cubes[1].velocity = {1e-3, 0.0};
  EXPECT_FALSE(would(moves));
}

}  // namespace
}  // namespace wuerfel::test
