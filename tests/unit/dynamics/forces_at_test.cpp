// Forces at an instant: closed forms, the certificate of rest, and what a second look costs.
#include "core/dynamics/forces_at.h"

#include <bit>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {
namespace {

constexpr double exact = 1e-12;

struct Instant {
  explicit Instant(const Scene& scene) : system(make_system(scene)), state(initial_state(scene)) {}
  System system;
  State state;
};

InstantForces look(const Scene& scene, Detail detail = Detail::uniqueness) {
  const Instant at(scene);
  return forces_at(at.system, {}, at.state, detail);
}

/// Force at the contact of an island at (x, y).
double force_at(const IslandForces& of, double x, double y) {
  double sum = 0.0;
  for (std::size_t k = 0; k < of.island.contacts.size(); ++k) {
    if ((of.island.contacts[k].point - Vec2(x, y)).norm() < 1e-9) sum += of.forces.force[k];
  }
  return sum;
}

//        +-----+
//     +--+--+  |     The upper weight acts at d = 0.3, between the ends of the overlap.
//     |  |  +--+
//     +-----+
//  ---^-----^------
TEST(ForcesAt, OfTwoCubesFollowTheLever) {
  const double d = 0.3;
  const InstantForces found = look(on_floor({cube("low", {0.0, 0.5}), cube("high", {d, 1.5})}));
  ASSERT_EQ(found.islands.size(), 1U);
  const IslandForces& of = found.islands.front();
  EXPECT_NEAR(force_at(of, d - 0.5, 1.0), g * (0.5 - d) / (1.0 - d), exact * g);
  EXPECT_NEAR(force_at(of, 0.5, 1.0), g * 0.5 / (1.0 - d), exact * g);
  EXPECT_NEAR(force_at(of, -0.5, 0.0), 2.0 * g * (0.5 - 0.5 * d), exact * g);
  EXPECT_NEAR(force_at(of, 0.5, 0.0), 2.0 * g * (0.5 + 0.5 * d), exact * g);
  for (const char unique : of.forces.unique)
    EXPECT_EQ(unique, 1);
  EXPECT_TRUE(found.at_rest);
  EXPECT_TRUE(found.solved);
  EXPECT_LE(found.residual, 1e-13);
}

//  ##+--+##   What nothing presses together presses as hard as it likes between two walls, and not at all where it falls away
//  ##|  |##   from the floor: the former forces are not the only ones, the latter are.
//  ##+--+##
TEST(ForcesAt, OfWhatIsNotPressedAreManyOnlyWhereItIsBraced) {
  Scene alone = on_floor({cube("a", {0.0, 0.5})});
  alone.gravity = {0.0, g};
  Scene braced = on_floor({cube("a", {0.0, 0.5})});
  braced.gravity = Vec2::Zero();
  for (const double x : {-1.0, 1.0})
    braced.fixed.push_back(post(x < 0.0 ? "left" : "right", {x, 0.5}, {1.0, 1.0}));
  for (const double mu : {0.0, 0.3}) {
    const InstantForces falling = look(with_friction(alone, mu));
    for (const char unique : falling.islands.front().forces.unique)
      EXPECT_EQ(unique, 1) << mu;
    const InstantForces held = look(with_friction(braced, mu));
    const IslandForces& of = held.islands.front();
    for (std::size_t k = 0; k < of.forces.force.size(); ++k) {
      EXPECT_EQ(of.forces.force[k], 0.0);
      const bool at_floor = of.island.contacts[k].normal.y() != 0.0;
      EXPECT_TRUE(at_floor || of.forces.unique[k] == 0) << mu << ' ' << k;
    }
  }
}

//   +---------------+      A beam of weight 2 P on two cubes of weight W. With a and b the forces of
//   a--+---b  b---+-a      one side, a + b = P, and c and e below (W + P, moments about the cube):
//   |  |      |     |      f = a^2 + b^2 + c^2 + e^2 is least at a = 0.56 P, where e - c = 0.16 P.
//  -c--e------e-----c-
TEST(ForcesAt, OfThreeCubesAreThoseOfLeastSquares) {
  SceneCube beam = cube("beam", {0.0, 1.5});
  beam.size = {2.0, 1.0};
  beam.mass = 3.0;
  const InstantForces found =
      look(on_floor({cube("left", {-0.75, 0.5}), cube("right", {0.75, 0.5}), beam}));
  ASSERT_EQ(found.islands.size(), 1U);
  const IslandForces& of = found.islands.front();
  const double P = 1.5 * g;
  const double W = g;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(force_at(of, 1.0 * side, 1.0), 0.56 * P, exact * P);
    EXPECT_NEAR(force_at(of, 0.25 * side, 1.0), 0.44 * P, exact * P);
    EXPECT_NEAR(force_at(of, 1.25 * side, 0.0), 0.5 * (W + P - 0.16 * P), exact * P);
    EXPECT_NEAR(force_at(of, 0.25 * side, 0.0), 0.5 * (W + P + 0.16 * P), exact * P);
  }
  for (const char unique : of.forces.unique)
    EXPECT_EQ(unique, 0);
  EXPECT_LE(found.residual, 1e-13);
}

TEST(ForcesAt, NothingIsSolvedThatIsNotAskedFor) {
  const Scene scene = on_floor({cube("a", {0.0, 0.5}), cube("free", {3.0, 5.0})});
  const InstantForces contacts = look(scene, Detail::contacts);
  EXPECT_EQ(contacts.islands.front().island.contacts.size(), 2U);
  EXPECT_EQ(contacts.cost.qp_solves, 0);
  EXPECT_TRUE(contacts.accelerations.empty());
  const InstantForces accelerations = look(scene, Detail::accelerations);
  EXPECT_EQ(accelerations.cost.qp_solves, 1);
  EXPECT_EQ(accelerations.cost.force_choices, 0);
  EXPECT_EQ(accelerations.cost.skipped_free, 1);
  EXPECT_EQ(accelerations.accelerations[1].linear, Vec2(0.0, -g));
}

TEST(ForcesAt, RestIsCertifiedWhereNothingMovesAndNothingWill) {
  const auto rests = [](const Scene& scene) { return look(scene, Detail::accelerations).at_rest; };
  EXPECT_TRUE(rests(on_floor(tower(5))));
  EXPECT_FALSE(rests(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.6, 1.5})}))) << "tips";
  EXPECT_FALSE(rests(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.0, 9.0})}))) << "falls";
  Scene sliding = on_floor(tower(2));
  sliding.cubes[1].velocity = {1e-300, 0.0};
  EXPECT_FALSE(rests(sliding)) << "slides";
  Scene space;
  space.gravity = Vec2::Zero();
  space.cubes = {cube("a", {0.0, 0.0})};
  EXPECT_TRUE(rests(space));
  space.cubes[0].spin = 1.0;
  EXPECT_FALSE(rests(space)) << "spins";
}

TEST(ForcesAt, TheResidualIsThatOfTheForcesReported) {
  // A program that was answered with the right accelerations and no forces at all.
  const Instant at(on_floor(tower(3)));
  const InstantForces found = forces_at(at.system, {}, at.state, Detail::forces);
  const IslandForces& of = found.islands.front();
  IslandSolution none = of.solution;
  none.forces.assign(none.forces.size(), 0.0);
  const ContactForces reported =
      canonical_forces(at.system, at.state, of.island, of.accelerations, none, Uniqueness::ignored);
  double sum = 0.0;
  for (const double force : reported.force)
    sum += force;
  // Either forces that carry the weights are found all the same, or the residual says that there are
  // none.
  EXPECT_TRUE(reported.residual <= 1e-10 ? sum > 5.9 * g : reported.residual > 0.1);
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void expect_same_bits(const InstantForces& a, const InstantForces& b) {
  ASSERT_EQ(a.islands.size(), b.islands.size());
  for (std::size_t m = 0; m < a.islands.size(); ++m) {
    const IslandForces& p = a.islands[m];
    const IslandForces& q = b.islands[m];
    ASSERT_EQ(p.island.cubes, q.island.cubes);
    ASSERT_EQ(p.forces.force.size(), q.forces.force.size());
    for (std::size_t k = 0; k < p.forces.force.size(); ++k)
      EXPECT_TRUE(same_bits(p.forces.force[k], q.forces.force[k])) << m << " " << k;
    EXPECT_TRUE(same_bits(p.forces.residual, q.forces.residual));
    EXPECT_EQ(p.rests, q.rests);
  }
}

TEST(ForceFinder, AsksAgainOnlyAboutWhatHasChanged) {
  std::vector<SceneCube> cubes = tower(4);
  cubes.push_back(cube("beside", {5.0, 0.5}));
  Instant at(on_floor(cubes));
  ForceFinder finder(at.system, {});
  EXPECT_EQ(finder.at(at.state, Detail::forces).cost.qp_solves, 2);
  const LookCost again = finder.at(at.state, Detail::forces).cost;
  EXPECT_EQ(again.qp_solves, 0);
  EXPECT_EQ(again.force_choices, 0);
  EXPECT_EQ(again.unchanged, 2);

  at.state[4].position.x() += 0.25;
  const InstantForces moved = finder.at(at.state, Detail::forces);
  EXPECT_EQ(moved.cost.qp_solves, 1) << "of the cube that moved";
  EXPECT_EQ(moved.cost.force_choices, 1);
  EXPECT_EQ(moved.cost.unchanged, 1);
  expect_same_bits(moved, forces_at(at.system, {}, at.state, Detail::forces));

  const LookCost closer = finder.at(at.state, Detail::uniqueness).cost;
  EXPECT_EQ(closer.qp_solves, 0) << "only the forces are looked at again";
  EXPECT_EQ(closer.force_choices, 2);
}

TEST(ForceFinder, ABitThatChangesIsAChange) {
  Instant at(on_floor(tower(2)));
  ForceFinder finder(at.system, {});
  (void)finder.at(at.state, Detail::forces);
  for (double BodyState::*value : {&BodyState::angle, &BodyState::spin}) {
    at.state[1].*value = at.state[1].*value == 0.0 ? 1e-18 : 0.0;
    EXPECT_EQ(finder.at(at.state, Detail::forces).cost.qp_solves, 1);
  }
}

TEST(ForceFinder, AnAnswerDoesNotDependOnWhatWasLookedAtBefore) {
  Instant at(on_floor(tower(6)));
  ForceFinder finder(at.system, {});
  (void)finder.at(at.state, Detail::forces);
  for (int k = 0; k < 5; ++k) {
    for (std::size_t i = 0; i < at.state.size(); ++i)
      at.state[i].position.x() += 0.01 * static_cast<double>(i % 3);
    expect_same_bits(finder.at(at.state, Detail::forces),
                     forces_at(at.system, {}, at.state, Detail::forces));
  }
}

TEST(ForceFinder, ContactsThatCarryLoadAreThereWhetherTheyTouchOrNot) {
  // As between the ends of a step: 1e-6 m above the floor, and on its way.
  Instant at(on_floor({cube("a", {0.0, 0.5 + 1e-6})}));
  at.state[0].velocity = {0.0, 1e-3};
  const std::vector<Contact> loaded =
      ContactFinder().find(at.system, initial_state(on_floor({cube("a", {0.0, 0.5})})));
  ForceFinder finder(at.system, {});
  EXPECT_TRUE(finder.at(at.state, Detail::forces).islands.empty());
  const InstantForces found = finder.at(at.state, Detail::forces, loaded);
  ASSERT_EQ(found.islands.size(), 1U);
  EXPECT_NEAR(found.islands[0].forces.force[0], 0.5 * g, 1e-5);
  EXPECT_NEAR(found.islands[0].forces.force[1], 0.5 * g, 1e-5);
  EXPECT_FALSE(found.at_rest);
}

}  // namespace
}  // namespace wuerfel::test
