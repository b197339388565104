// Nearest places without overlap and on closed contacts, and nearest velocities.
#include "core/dynamics/projection.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// Everything that touches, or overlaps, is restricted in the same way.
class Ground {
 public:
  explicit Ground(const Scene& scene) : m(scene), dynamics(m.system, {}) {}

  std::vector<Restricted> restricted(const State& state,
                                     SideUse use,
                                     const std::vector<double>& margins = {}) {
    std::vector<Restricted> parts;
    for (const Island& island : find_islands(m.system, finder.find(m.system, state, 1e-3)))
      parts.push_back({island, std::vector(island.contacts.size(), use), margins});
    return parts;
  }
  Projection project(const ProjectionPolicy& policy, SideUse use) {
    const auto find = [&](const Projection& so_far) { return restricted(so_far.state, use); };
    return project_places(m.system, m.state, policy, find, dynamics);
  }
  double deepest(const State& state) {
    finder.find(m.system, state);
    return finder.deepest().depth;
  }

  Mechanism m;
  IslandDynamics dynamics;
  ContactFinder finder;
};

constexpr double unlimited = std::numeric_limits<double>::infinity();

TEST(Projection, AnOverlappingPairIsPartedByMass) {
  //   +----+
  //   | a +|---+    m = 1 and 3, overlap 1e-4: a moves by 3/4 of it
  //   +---+|b  |
  //       +----+
  Scene scene;
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.0 - 1e-4, 0.0})};
  scene.cubes[1].mass = 3.0;
  Ground g(scene);
  const Projection apart = g.project({.overlap = 1e-12, .rounds = 5}, SideUse::inequality);
  EXPECT_TRUE(apart.moved);
  EXPECT_EQ(apart.rounds, 1);
  EXPECT_EQ(apart.pushing.size(), 2U);
  EXPECT_NEAR(apart.state[0].position.x(), -0.75e-4, 1e-15);
  EXPECT_NEAR(apart.state[1].position.x(), 1.0 - 0.75e-4, 1e-15);
  EXPECT_EQ(apart.state[0].angle, 0.0);
}

TEST(Projection, RoundsOfNewtonsMethodConvergeQuadratically) {
  // A corner in the ground: the cube turns as it is lifted, so that one linear step is not enough.
  const double angle = 0.3;
  const double reach = 0.5 * (std::sin(angle) + std::cos(angle));
  Ground g(on_floor({sized_cube("a", {0.0, reach - 1e-3}, Vec2::Ones(), angle)}));
  double former = 1e-3;
  for (int rounds = 1; rounds <= 2; ++rounds) {
    const Projection up =
        g.project({.overlap = 1e-15, .gap = 1e-15, .rounds = rounds}, SideUse::equality);
    EXPECT_EQ(up.rounds, rounds);
    const double left =
        std::abs(g.restricted(up.state, SideUse::equality)[0].island.contacts[0].gap);
    EXPECT_GT(left, 0.0);
    EXPECT_LT(left, 2.0 * former * former);
    former = left;
  }
  const Projection up = g.project({.gap = 1e-14, .rounds = 9}, SideUse::equality);
  EXPECT_LT(up.rounds, 5);
  EXPECT_LT(g.deepest(up.state), 1e-14);
}

TEST(Projection, WhatFitsIsLeftWhereItIs) {
  Ground g(on_floor({cube("a", {0.0, 0.5 - 1e-6})}));
  const Projection kept = g.project({.overlap = 2e-6, .rounds = 3}, SideUse::inequality);
  EXPECT_FALSE(kept.moved);
  EXPECT_EQ(kept.solves.solved, 0);
  EXPECT_EQ(kept.state[0].position, g.m.state[0].position);
}

TEST(Projection, ClosedContactsAreClosedFromBothSides) {
  Ground g(on_floor({cube("a", {0.0, 0.5 + 1e-5})}));
  const Projection down = g.project({.gap = 1e-13, .rounds = 3}, SideUse::equality);
  EXPECT_TRUE(down.moved);
  EXPECT_TRUE(down.pushing.empty());
  EXPECT_NEAR(down.state[0].position.y(), 0.5, 1e-15);
}

/// A block of width 1 between posts that stand 1 - 2e-4 m apart.
//      +---+
//   ###| a |###
//   ###+---+###
Scene too_narrow() {
  Scene scene;
  scene.fixed = {post("left", {-1.0 + 1e-4, 0.0}, {1.0, 3.0}),
                 post("right", {1.0 - 1e-4, 0.0}, {1.0, 3.0})};
  scene.cubes = {cube("a", {5e-5, 0.0})};
  return scene;
}

TEST(Projection, ContradictionsAreTakenOrLeft) {
  Ground g(too_narrow());
  const Projection left = g.project(
      {.gap = 1e-9, .rounds = 3, .contradiction = Contradiction::leave}, SideUse::equality);
  EXPECT_FALSE(left.moved);
  EXPECT_EQ(left.state[0].position, g.m.state[0].position);
  const Projection opened =
      g.project({.overlap = 1e-9, .gap = 1e-9, .rounds = 1, .contradiction = Contradiction::open},
                SideUse::equality);
  EXPECT_EQ(opened.opened.size(), 4U);
  EXPECT_EQ(opened.solves.solved, 2);
}

TEST(Projection, WhoHadToMoveTooFarStays) {
  Ground g(on_floor({cube("a", {0.0, 0.5 - 1e-4})}));
  const auto find = [&](double farthest) {
    return [&g, farthest](const Projection& so_far) {
      std::vector<Restricted> parts = g.restricted(so_far.state, SideUse::inequality);
      parts.at(0).farthest = farthest;
      return parts;
    };
  };
  const ProjectionPolicy policy{.overlap = 1e-9, .rounds = 4};
  EXPECT_FALSE(project_places(g.m.system, g.m.state, policy, find(0.9e-4), g.dynamics).moved);
  EXPECT_TRUE(project_places(g.m.system, g.m.state, policy, find(1.1e-4), g.dynamics).moved);
  EXPECT_TRUE(project_places(g.m.system, g.m.state, policy, find(unlimited), g.dynamics).moved);
}

TEST(Projection, MarginsAreKeptWhereThereIsRoom) {
  Ground free(on_floor({cube("a", {0.0, 0.5 - 1e-5})}));
  Solves unused;
  const std::vector<double> margins{1e-6, 1e-6};
  const Restricted part = free.restricted(free.m.state, SideUse::inequality, margins).at(0);
  const IslandSolution up = nearest_place(free.m.state, part, {}, free.dynamics, unused);
  EXPECT_NEAR(up.twists[0].linear.y(), 1.1e-5, 1e-15);
  EXPECT_EQ(unused.solved, 0);

  // Exactly as wide as the gap, and 1e-5 too far left: no room for margins on both sides.
  Scene scene;
  scene.fixed = {post("left", {-1.0, 0.0}, {1.0, 3.0}), post("right", {1.0, 0.0}, {1.0, 3.0})};
  scene.cubes = {cube("a", {-1e-5, 0.0})};
  Ground tight(scene);
  const Restricted between =
      tight.restricted(tight.m.state, SideUse::inequality, std::vector<double>(4, 1e-6)).at(0);
  ASSERT_EQ(between.island.contacts.size(), 4U);
  const IslandSolution fits = nearest_place(tight.m.state, between, {}, tight.dynamics, unused);
  EXPECT_EQ(fits.status, QpStatus::optimal);
  EXPECT_NEAR(fits.twists[0].linear.x(), 1e-5, 1e-14);
  EXPECT_EQ(unused.solved, 1);
}

TEST(Projection, VelocitiesKeepClosedGapsAndOpenNoOther) {
  Ground g(on_floor({cube("a", {0.0, 0.5})}));
  g.m.state[0].velocity = {0.2, 1.0};
  g.m.state[0].spin = 0.5;
  const auto parts = g.restricted(g.m.state, SideUse::equality);
  const Projection slow =
      project_velocities(g.m.system, g.m.state, parts, Contradiction::leave, g.dynamics);
  EXPECT_NEAR(slow.state[0].velocity.x(), 0.2, 1e-15);
  EXPECT_NEAR(slow.state[0].velocity.y(), 0.0, 1e-15);
  EXPECT_NEAR(slow.state[0].spin, 0.0, 1e-15);
  const Projection again =
      project_velocities(g.m.system, slow.state, parts, Contradiction::leave, g.dynamics);
  EXPECT_FALSE(again.moved);
  EXPECT_EQ(again.solves.solved, 0);
}

TEST(Projection, OntoClosedContactsAloneIsTheSameByOneLinearSystem) {
  Ground g(on_floor({sized_cube("a", {0.0, 0.5 + 1e-6}, Vec2::Ones(), 1e-6)}));
  g.m.state[0].velocity = {0.1, -0.3};
  g.m.state[0].spin = 0.7;
  const std::vector<Restricted> parts = g.restricted(g.m.state, SideUse::equality);
  ClosedContacts closed(g.m.system);
  closed.close(parts.at(0).island.contacts, {});
  State linear = g.m.state;
  project_places(closed, linear);
  project_velocities(closed, linear);
  const Projection placed = g.project({.gap = 1e-12}, SideUse::equality);
  EXPECT_NEAR(linear[0].position.y(), placed.state[0].position.y(), 1e-15);
  EXPECT_NEAR(linear[0].angle, placed.state[0].angle, 1e-15);
  EXPECT_NEAR(linear[0].velocity.x(), 0.1, 1e-15);
  EXPECT_NEAR(linear[0].velocity.y(), 0.0, 1e-12);
  EXPECT_NEAR(linear[0].spin, 0.0, 1e-12);
}

}  // namespace
}  // namespace wuerfel::test
