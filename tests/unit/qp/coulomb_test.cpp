// The exact solver on programs whose answers are known in closed form.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "core/qp/coulomb/contact_memory.h"
#include "core/qp/coulomb/coulomb_solver.h"
#include "core/qp/coulomb/dice.h"
#include "tests/support/friction_zoo.h"
#include "tests/support/laid_bricks.h"

namespace wuerfel::test {
namespace {

/// A box on two corners on the floor, velocity given.
FrictionCase box_on_floor(double mu, double width, double height, std::array<double, 3> velocity) {
  FrictionBuilder builder({.mu = mu});
  builder.add_body(0.0, 0.5 * height, width, height);
  builder.add_contact(0, ground, -0.5 * width, 0.0, 0.0, 1.0);
  builder.add_contact(0, ground, 0.5 * width, 0.0, 0.0, 1.0);
  FrictionCase c = builder.take();
  const double mass = 1.0;
  const double inertia = (width * width + height * height) / 12.0;
  c.program.mass = {mass, mass, inertia};
  c.program.target.assign(velocity.begin(), velocity.end());
  return c;
}

/// The unit square in the 3-4-5 pose, one corner on the floor.
FrictionCase square_on_corner(double mu, double vx, double vy) {
  FrictionBuilder builder({.mu = mu});
  builder.add_body(0.1, 0.7, 1.0, 1.0);
  builder.add_contact(0, ground, 0.0, 0.0, 0.0, 1.0);
  FrictionCase c = builder.take();
  c.program.target = {vx, vy, 0.0};
  return c;
}

CoulombResult solved(const FrictionCase& c) {
  CoulombSolver solver;
  CoulombResult result;
  solver.solve(c.view(), result);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_LE(coulomb_residual(c.view(), result.x, result.multiplier).worst(), 1e-10);
  return result;
}

TEST(Coulomb, FlatImpactSlipsAndKeepsFlat) {
  const CoulombResult r = solved(box_on_floor(0.4, 2.0, 1.0, {3.0, -2.0, 0.0}));
  EXPECT_NEAR(r.x[0], 2.2, 1e-12);
  EXPECT_NEAR(r.x[1], 0.0, 1e-12);
  EXPECT_NEAR(r.x[2], 0.0, 1e-12);
  EXPECT_NEAR(r.multiplier[2], 1.2, 1e-12);
  EXPECT_NEAR(r.multiplier[0], 0.8, 1e-12);
}

TEST(Coulomb, CornerSlips) {
  const CoulombResult r = solved(square_on_corner(0.2, 3.0, -2.0));
  EXPECT_NEAR(r.x[0], 2.65034965034965, 1e-13);
  EXPECT_NEAR(r.x[1], -0.251748251748252, 1e-13);
  EXPECT_NEAR(r.x[2], -2.51748251748252, 1e-13);
  EXPECT_NEAR(r.multiplier[0], 1.74825174825175, 1e-13);
}

TEST(Coulomb, CornerSticks) {
  const CoulombResult r = solved(square_on_corner(0.9, 0.5, -2.0));
  EXPECT_NEAR(r.x[0], 0.5775, 1e-13);
  EXPECT_NEAR(r.x[1], -0.0825, 1e-13);
  EXPECT_NEAR(r.x[2], -0.825, 1e-13);
  EXPECT_NEAR(r.multiplier[0], 1.9175, 1e-13);
  // The tangent is the normal turned left: -x.
  EXPECT_NEAR(r.multiplier[1], -0.0775, 1e-13);
}

TEST(Coulomb, BlockOnInclineSticksBelowTheAngleAndSlipsAbove) {
  const double mu = 0.5;
  for (const double part : {1.0 - 1e-6, 1.0 + 1e-6}) {
    // Gravity leans by atan(part mu); the block is flat.
    const double g = 9.81;
    const double across = g * part * mu;
    const CoulombResult r = solved(box_on_floor(mu, 1.0, 1.0, {across, -g, 0.0}));
    EXPECT_NEAR(r.x[0], std::max(across - mu * g, 0.0), 1e-12);
    EXPECT_NEAR(r.x[1], 0.0, 1e-12);
    EXPECT_NEAR(r.multiplier[0] + r.multiplier[2], g, 1e-12);
  }
}

TEST(Coulomb, SlipIsStoppedButNotReversed) {
  const CoulombResult r = solved(box_on_floor(0.5, 2.0, 1.0, {0.3, -1.0, 0.0}));
  EXPECT_NEAR(r.x[0], 0.0, 1e-14);
  EXPECT_NEAR(r.multiplier[1] + r.multiplier[3], 0.3, 1e-13);
}

TEST(Coulomb, ContactsThatOpenCarryNothing) {
  const CoulombResult r = solved(box_on_floor(0.5, 2.0, 1.0, {0.3, 1.0, 0.1}));
  EXPECT_NEAR(r.x[0], 0.3, 1e-15);
  for (const double lambda : r.multiplier)
    EXPECT_EQ(lambda, 0.0);
}

TEST(Coulomb, KnownDirectionOfSlipKeepsItsForce) {
  FrictionCase c = box_on_floor(0.5, 2.0, 1.0, {0.0, -9.81, 0.0});
  // Sliding to +x, that is against the tangent: acceleration -mu g.
  for (FrictionContact& contact : c.contacts)
    contact.slides = -1;
  const CoulombResult r = solved(c);
  EXPECT_NEAR(r.x[0], -0.5 * 9.81, 1e-12);
  EXPECT_NEAR(r.x[1], 0.0, 1e-12);
}

/// The 0.2 x 2 plank at 1.1 rad of Painleve: slips on one corner, friction presses it into the floor.
FrictionCase plank(double mu) {
  FrictionBuilder builder({.mu = mu});
  const double x = 0.36447538541943386;
  const double y = 0.9365669722039931;
  builder.add_body(x, y, 0.2, 2.0);
  builder.add_contact(0, ground, 0.0, 0.0, 0.0, 1.0);
  FrictionCase c = builder.take();
  c.program.mass = {1.0, 1.0, (0.04 + 4.0) / 12.0};
  c.program.target = {0.0, -9.81, 0.0};
  c.contacts[0].slides = 1;  // to -x, the tangent
  return c;
}

TEST(Coulomb, PainleveBelowAndAbove) {
  const double critical = 1.3754248121687305;
  const CoulombResult below = solved(plank(critical * (1.0 - 1e-3)));
  EXPECT_NEAR(below.multiplier[0] / 7034.3703490592425, 1.0, 1e-9);
  for (const double part : {1.0 - 1e-7, 1.0 + 1e-3, 2.0}) {
    CoulombSolver solver;
    CoulombResult result;
    solver.solve(plank(critical * part).view(), result);
    EXPECT_EQ(result.status, QpStatus::infeasible) << part;
  }
}

TEST(Coulomb, WithoutFrictionNoTangentialForce) {
  const CoulombResult r = solved(box_on_floor(0.0, 2.0, 1.0, {3.0, -2.0, 0.0}));
  EXPECT_NEAR(r.x[0], 3.0, 1e-15);
  EXPECT_EQ(r.multiplier[1], 0.0);
}

TEST(Coulomb, RodsTakePart) {
  // A block that a rod holds against sliding.
  FrictionCase c = box_on_floor(0.1, 2.0, 1.0, {3.0, -2.0, 0.0});
  c.program.add_equality(0.0);
  c.program.add_entry(0, std::array{1.0, 0.0, 0.0});
  const CoulombResult r = solved(c);
  EXPECT_NEAR(r.x[0], 0.0, 1e-13);
  EXPECT_NEAR(r.x[1], 0.0, 1e-13);
}

TEST(Coulomb, MalformedProgramsAreRefused) {
  FrictionCase c = box_on_floor(0.5, 1.0, 1.0, {1.0, -1.0, 0.0});
  CoulombSolver solver;
  CoulombResult result;
  const auto refused = [&] {
    solver.solve(c.view(), result);
    return result.status == QpStatus::invalid;
  };
  const FrictionContact sound = c.contacts[0];
  c.contacts[0].mu = -0.1;
  EXPECT_TRUE(refused());
  c.contacts[0] = sound;
  c.contacts[0].tangent = c.contacts[0].normal;
  EXPECT_TRUE(refused());
  c.contacts[0] = sound;
  c.contacts[0].tangent = 17;
  EXPECT_TRUE(refused());
  c.contacts[0] = sound;
  c.program.target[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(refused());
}

TEST(Coulomb, SecondTimeIsACertificate) {
  const FrictionCase c = box_on_floor(0.5, 2.0, 1.0, {0.3, -1.0, 0.0});
  CoulombSolver solver;
  CoulombResult first;
  CoulombResult second;
  solver.solve(c.view(), first);
  solver.solve(c.view(), second);
  EXPECT_EQ(second.stage, CoulombStage::certificate);
  EXPECT_EQ(first.multiplier, second.multiplier);
}

/// A punched tower, and the solver that remembers its contacts by keys.
struct SolvedTower {
  SolvedTower() { solver.solve(c.view(), result, keys); }
  FrictionCase c = friction_tower(3, {.mu = 0.5, .punch = 3.0});
  CoulombSolver solver;
  CoulombResult result;
  std::vector<std::uint64_t> keys{11, 3, 7, 5, 2, 9};
};

TEST(Coulomb, KeysFindContactsAgain) {
  auto [c, solver, result, keys] = SolvedTower();
  const std::vector<double> before = result.multiplier;
  const std::vector<std::uint64_t> turned{9, 2, 5, 7, 3, 11};
  std::reverse(c.contacts.begin(), c.contacts.end());
  solver.solve(c.view(), result, turned);
  EXPECT_EQ(result.stage, CoulombStage::certificate);
  EXPECT_EQ(before, result.multiplier);
}

// Velocities and displacements of one step differ by its length.
TEST(Coulomb, ForcesFollowTheScaleOfTheProgram) {
  auto [c, solver, result, keys] = SolvedTower();
  std::vector<double> expected = result.multiplier;
  for (auto* numbers : {&c.program.target, &c.program.bound, &expected}) {
    for (double& number : *numbers)
      number /= 256.0;
  }
  solver.solve(c.view(), result, keys);
  EXPECT_EQ(result.stage, CoulombStage::certificate);
  EXPECT_EQ(expected, result.multiplier);
}

TEST(Coulomb, WhatOnlyRefinesIsFoundWhereItIsNear) {
  auto [c, solver, result, keys] = SolvedTower();
  for (double& bound : c.program.bound)
    bound -= 1e-6;
  FrictionProgram again = c.view();
  again.refines = true;
  solver.solve(again, result, keys);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_EQ(result.stage, CoulombStage::newton);
}

// And leaves what is remembered as it was where it is not.
TEST(Coulomb, WhatOnlyRefinesIsGivenUpWhereItIsFar) {
  const FrictionCase c = friction_pile(30, {.mu = 0.6, .tumble = true});
  CoulombSolver solver;
  CoulombResult result;
  FrictionProgram again = c.view();
  again.refines = true;
  solver.solve(again, result);
  EXPECT_EQ(result.status, QpStatus::inaccurate);
  EXPECT_TRUE(result.x.empty());
  CoulombResult fresh;
  solver.solve(c.view(), result);
  CoulombSolver().solve(c.view(), fresh);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_EQ(result.multiplier, fresh.multiplier);
}

// What is near in a placement need not touch where velocities are found.
TEST(Coulomb, ModesOutliveProgramsWithoutTheirContact) {
  const FrictionCase c = friction_tower(2, {.mu = 0.5});
  ContactForm form;
  form.prepare(c.view(), CoulombJudge().measure_scales(c.program));
  const std::vector<std::uint64_t> keys{11, 3, 7, 5};
  const std::vector<std::uint64_t> others{2, 4};
  const std::vector<ContactMode> modes{ContactMode::open, ContactMode::slip_back,
                                       ContactMode::stick, ContactMode::slip_forward};
  ContactMemory memory;
  memory.remember(keys, 1.0, modes, std::vector<Pair>(4, Pair{2.0, 0.5}));
  for (int k = 0; k < 4; ++k)
    memory.remember(others, 1.0, {ContactMode::stick, ContactMode::stick}, {{}, {}});
  const std::vector<ContactMode> unknown(4, ContactMode::stick);
  std::vector<ContactMode> recalled = unknown;
  std::vector<Pair> forces(4);
  EXPECT_TRUE(memory.recall(form, keys, 1.0, recalled, forces));
  EXPECT_EQ(recalled, modes);
  for (const Pair& l : forces)
    EXPECT_EQ(l.n, 0.0);  // of another program
  memory.remember(others, 1.0, {ContactMode::stick, ContactMode::stick}, {{}, {}});
  recalled = unknown;
  EXPECT_TRUE(memory.recall(form, keys, 1.0, recalled, forces));
  EXPECT_EQ(recalled, unknown);  // too long ago
}

TEST(StartingPoints, AreFactorsOfTheExponentialFunction) {
  wuerfel::Dice dice(3);
  wuerfel::Dice same(3);
  for (const double spread : {0.0, 0.5, 3.0, 8.0}) {
    for (int k = 0; k < 100; ++k) {
      const double expected = std::exp(spread * (2.0 * same.next() - 1.0));
      EXPECT_NEAR(dice.next_factor(spread) / expected, 1.0, 1e-7);
    }
  }
}

}  // namespace
}  // namespace wuerfel::test
