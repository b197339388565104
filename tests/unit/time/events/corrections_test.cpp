// What is put right at an event: least displacements in closed form.
#include "core/time/events/corrections.h"

#include <gtest/gtest.h>

#include "core/time/events/contact_modes.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

TEST(Corrections, AnOverlapIsDividedByMass) {
  Scene scene;
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.0 - 1e-9, 0.0})};
  scene.cubes[1].mass = 3.0;
  const Mechanism m(scene);
  Workspace work(m.system, {});
  const std::vector<Island> islands = islands_at(m.state, touching_tolerance, work);
  const OutOfOverlap apart = out_of_overlap(m.state, islands, {0, 0}, 1e-9, work);
  EXPECT_FALSE(apart.pushed);
  ASSERT_TRUE(apart.moved);
  EXPECT_NEAR(apart.state[0].position.x(), -0.75e-9, 1e-15);
  EXPECT_NEAR(apart.state[1].position.x() - m.state[1].position.x(), 0.25e-9, 1e-15);
}

TEST(Corrections, WhatIsPushedIntoAnotherBodyTakesItAlong) {
  //   +---++---+ +---+    a overlaps b by 5e-9; between b and c there are 1e-9, which is no touching
  //   | a || b | | c |    within 1e-10: without c, b would be pushed into it.
  //   +---++---+ +---+
  Scene scene;
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.0 - 5e-9, 0.0}), cube("c", {2.0 - 4e-9, 0.0})};
  scene.cubes[0].mass = 1000.0;
  const Mechanism m(scene);
  Workspace work(m.system, {});
  const std::vector<Island> islands = islands_at(m.state, 1e-10, work);
  const OutOfOverlap apart = out_of_overlap(m.state, islands, {0, 0, 0}, 1e-10, work);
  EXPECT_TRUE(apart.pushed);
  ASSERT_TRUE(apart.moved);
  work.finder.find(m.system, apart.state, 1e-10);
  EXPECT_LT(work.finder.deepest().depth, 1e-15);
  EXPECT_GT(apart.state[2].position.x() - m.state[2].position.x(), 3e-9);
}

TEST(Corrections, NothingIsMovedThatFits) {
  const Mechanism m(on_floor({cube("a", {0.0, 0.5})}));
  Workspace work(m.system, {});
  const std::vector<Island> islands = islands_at(m.state, touching_tolerance, work);
  EXPECT_FALSE(out_of_overlap(m.state, islands, {0}, 1e-9, work).moved);
  State state = m.state;
  onto_closed(islands.at(0), {1, 0}, state, work);
  EXPECT_EQ(state[0].position, m.state[0].position);
  EXPECT_EQ(state[0].velocity, m.state[0].velocity);
  EXPECT_EQ(work.solves.solved, 0);
}

TEST(Corrections, AClosedContactIsClosedAndTheOtherKeptOpen) {
  Mechanism m(on_floor({cube("a", {0.0, 0.5 + 5e-11})}));
  m.state[0].velocity.y() = 1e-6;
  Workspace work(m.system, {});
  const std::vector<Island> islands = islands_at(m.state, touching_tolerance, work);
  ASSERT_EQ(islands.at(0).contacts.size(), 2U);
  State state = m.state;
  onto_closed(islands.at(0), {1, 0}, state, work);
  Island island = islands.at(0);
  follow(m.system, state, island.contacts);
  const auto rate = [&](const Contact& c) {
    return gap_rate(c, contact_velocity(m.system, state, c));
  };
  EXPECT_NEAR(island.contacts[0].gap, 0.0, 1e-16);
  EXPECT_GE(island.contacts[1].gap, -1e-16);
  EXPECT_NEAR(rate(island.contacts[0]), 0.0, 1e-15);
  EXPECT_GE(rate(island.contacts[1]), -1e-15);
}

}  // namespace
}  // namespace wuerfel::test
