// Equilibria, canonical forces and restitution.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/qp/coulomb/canonical_friction.h"
#include "core/qp/coulomb/rest_program.h"
#include "core/qp/coulomb/restitution.h"
#include "tests/support/friction_zoo.h"
#include "tests/support/laid_bricks.h"

namespace wuerfel::test {
namespace {

constexpr double g = 9.81;

void let_gravity_act(FrictionCase& c) {
  for (int j = 0; j < c.program.unknowns(); ++j)
    c.program.target[j] = j % 3 == 1 ? -g : 0.0;
}

/// A box 2 x 1 in a groove of two planes inclined by atan(3/4).
FrictionCase groove(double mu) {
  FrictionBuilder builder({.mu = mu});
  builder.add_body(0.0, 1.25, 2.0, 1.0);
  builder.add_contact(0, ground, -1.0, 0.75, 0.6, 0.8);
  builder.add_contact(0, ground, 1.0, 0.75, -0.6, 0.8);
  FrictionCase c = builder.take();
  c.program.mass = {1.0, 1.0, 5.0 / 12.0};
  let_gravity_act(c);
  return c;
}

/// A unit block between two walls.
FrictionCase shaft(double mu) {
  FrictionBuilder builder({.mu = mu});
  builder.add_body(0.0, 3.0, 1.0, 1.0);
  for (const double y : {2.5, 3.5}) {
    builder.add_contact(0, ground, -0.5, y, 1.0, 0.0);
    builder.add_contact(0, ground, 0.5, y, -1.0, 0.0);
  }
  FrictionCase c = builder.take();
  let_gravity_act(c);
  return c;
}

/// A block clamped between two free ones of three times its mass.
FrictionCase bridge(double mu) {
  FrictionBuilder builder({.mu = mu});
  builder.add_body(-2.0, 1.0, 3.0, 2.0);
  builder.add_body(2.0, 1.0, 3.0, 2.0);
  builder.add_body(0.0, 1.0, 1.0, 1.0);
  for (const int side : {0, 1}) {
    const double x = side == 0 ? -2.0 : 2.0;
    builder.add_contact(side, ground, x - 1.5, 0.0, 0.0, 1.0);
    builder.add_contact(side, ground, x + 1.5, 0.0, 0.0, 1.0);
    for (const double y : {0.5, 1.5})
      builder.add_contact(2, side, side == 0 ? -0.5 : 0.5, y, side == 0 ? 1.0 : -1.0, 0.0);
  }
  FrictionCase c = builder.take();
  for (int j = 0; j < 9; ++j) {
    const bool turns = j % 3 == 2;
    c.program.mass[j] = j < 6 ? (turns ? 13.0 * 3.0 / 12.0 : 3.0) : (turns ? 1.0 / 6.0 : 1.0);
  }
  let_gravity_act(c);
  return c;
}

/// A ladder of no thickness at 60 degrees, or any: rod from the floor to the wall.
FrictionCase ladder(double mu, double angle) {
  const double x = 0.5 * std::cos(angle);
  const double y = 0.5 * std::sin(angle);
  FrictionBuilder builder({.mu = mu});
  builder.add_body(0.0, 0.0, 1.0, 1.0);
  builder.add_contact(0, ground, x, -y, 0.0, 1.0);
  builder.add_contact(0, ground, -x, y, 1.0, 0.0);
  FrictionCase c = builder.take();
  c.program.mass = {1.0, 1.0, 1.0 / 12.0};
  let_gravity_act(c);
  return c;
}

TEST(RestProgram, ThresholdsAreRightToAMillionth) {
  const double bridge_mu = std::sqrt(1.0 / 7.0);
  const double angle = 2.0 * std::atan(2.0) - 2.0 * std::atan(1.0);  // mu = tan(45 deg - angle / 2)
  const double ladder_mu = std::tan(std::atan(1.0) - 0.5 * angle);
  for (const double part : {1.0 - 1e-6, 1.0 + 1e-6}) {
    for (const FrictionCase& c : {bridge(part * bridge_mu), ladder(part * ladder_mu, angle)}) {
      const RestResult r = RestProgram().solve(c.view());
      EXPECT_EQ(r.equilibrium(), part > 1.0) << part;
      if (part > 1.0) {
        EXPECT_LE(r.size, 1e-12);
      } else {
        EXPECT_GE(r.size, 1e-8);
      }
    }
  }
}

TEST(RestProgram, TheCertificateHasNoForceAgainstIt) {
  const FrictionCase c = bridge(0.3);
  const RestResult r = RestProgram().solve(c.view());
  ASSERT_EQ(r.status, QpStatus::optimal);
  ASSERT_FALSE(r.equilibrium());
  const QuadraticProgram& p = c.program;
  double power = 0.0;
  for (int j = 0; j < p.unknowns(); ++j)
    power += p.mass[j] * p.target[j] * r.acceleration[j];
  EXPECT_GT(power, 0.0);
  const auto rate = [&](int row) {
    double sum = 0.0;
    for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e) {
      for (int k = 0; k < 3; ++k)
        sum += p.entry(e)[k] * r.acceleration[3 * p.entry_block[e] + k];
    }
    return sum;
  };
  for (const FrictionContact& contact : c.contacts)
    EXPECT_GE(rate(contact.normal), contact.mu * std::abs(rate(contact.tangent)) - 1e-11);
}

/// What slips has all its friction: 20 times its weight holds no push of 8, which less could.
TEST(RestProgram, WhatSlipsPullsWithAllItsFriction) {
  for (const double push : {8.0, 20.0}) {
    FrictionCase c;
    c.program.clear(3);
    c.program.add_block(std::array{1.0, 1.0, 1.0}, std::array{push, -1.0, 0.0});
    const int normal = c.program.add_inequality(0.0);
    c.program.add_entry(0, std::array{0.0, 1.0, 0.0});
    const int tangent = c.program.add_equality(0.0);
    c.program.add_entry(0, std::array{1.0, 0.0, 0.0});
    c.contacts = {{.normal = normal, .tangent = tangent, .mu = 20.0, .slides = 1}};
    EXPECT_EQ(RestProgram().solve(c.view()).equilibrium(), push == 20.0) << push;
  }
}

TEST(RestProgram, ShaftHoldsByItsSelfStress) {
  const RestResult r = RestProgram().solve(shaft(0.5).view());
  EXPECT_TRUE(r.equilibrium());
  EXPECT_LE(r.size, 1e-12);
}

TEST(CanonicalFriction, GrooveTakesTheLeastSquares) {
  const FrictionCase c = groove(0.5);
  CoulombSolver solver;
  CoulombResult solution;
  solver.solve(c.view(), solution);
  ASSERT_EQ(solution.status, QpStatus::optimal);
  const CanonicalForces forces =
      canonical_friction(c.view(), solution.x, solution.multiplier, true);
  EXPECT_LE(forces.misfit, 1e-12);
  EXPECT_NEAR(forces.multiplier[0], 4.45909090909091, 1e-11);
  EXPECT_NEAR(forces.multiplier[2], 4.45909090909091, 1e-11);
  EXPECT_NEAR(std::abs(forces.multiplier[1]), 2.22954545454545, 1e-11);
  EXPECT_NEAR(std::abs(forces.multiplier[3]), 2.22954545454545, 1e-11);
  EXPECT_FALSE(forces.unique[0]);
  EXPECT_FALSE(forces.unique[1]);
}

TEST(CanonicalFriction, OneCornerIsUnique) {
  FrictionBuilder builder({.mu = 0.5});
  builder.add_body(0.0, 0.5, 1.0, 1.0);
  builder.add_contact(0, ground, 0.0, 0.0, 0.0, 1.0);
  FrictionCase c = builder.take();
  let_gravity_act(c);
  const CanonicalForces forces = canonical_friction(c.view(), {0.0, 0.0, 0.0}, {g, 0.0}, true);
  EXPECT_NEAR(forces.multiplier[0], g, 1e-13);
  EXPECT_TRUE(forces.unique[0]);
}

TEST(CanonicalFriction, WallsBalanceExactly) {
  for (const int size : {3, 10}) {
    FrictionCase c = friction_wall(size, size, {.mu = 0.6});
    let_gravity_act(c);
    CoulombSolver solver;
    CoulombResult solution;
    solver.solve(c.view(), solution);
    ASSERT_EQ(solution.status, QpStatus::optimal);
    const CanonicalForces forces =
        canonical_friction(c.view(), solution.x, solution.multiplier, false);
    EXPECT_LE(forces.misfit, 1e-12) << size;
    EXPECT_LE(coulomb_residual(c.view(), solution.x, forces.multiplier).worst(), 1e-10) << size;
    const auto squares = [](const std::vector<double>& v) {
      double sum = 0.0;
      for (const double lambda : v)
        sum += lambda * lambda;
      return sum;
    };
    EXPECT_LE(squares(forces.multiplier), squares(solution.multiplier) * (1.0 + 1e-9)) << size;
  }
}

/// Random simultaneous impacts: contacts at random places, masses up to 1e4.
FrictionCase random_impact(int index, std::vector<double>& e, std::vector<double>& before) {
  Dice dice(static_cast<std::uint64_t>(index) + 4711);
  FrictionBuilder builder({.mu = dice.uniform(0.0, 2.0)});
  const int bodies = 2 + dice.below(5);
  const int contacts = 1 + dice.below(8);
  const bool heavy = dice.below(3) == 0;
  std::vector<double> mass;
  for (int b = 0; b < bodies; ++b) {
    builder.add_body(dice.uniform(-1.0, 1.0), dice.uniform(-1.0, 1.0), 1.0, 1.0);
    mass.push_back(heavy ? std::pow(10.0, dice.uniform(0.0, 4.0)) : 1.0);
  }
  for (int k = 0; k < contacts; ++k) {
    const int on = dice.below(bodies);
    const int other = dice.below(bodies + 1) - 1;
    const double nx = dice.uniform(-1.0, 1.0);
    const double ny = dice.uniform(-1.0, 1.0);
    builder.add_contact(on, other == on ? ground : other, dice.uniform(-1.0, 1.0),
                        dice.uniform(-1.0, 1.0), nx, ny);
  }
  FrictionCase c = builder.take();
  QuadraticProgram& p = c.program;
  for (int j = 0; j < p.unknowns(); ++j) {
    p.mass[j] *= mass[j / 3];
    p.target[j] = dice.uniform(-1.0, 1.0);
  }
  e.clear();
  before.clear();
  for (const FrictionContact& contact : c.contacts) {
    e.push_back(dice.uniform(0.0, 1.0));
    double un = 0.0;
    for (int k = p.row_start[contact.normal]; k < p.row_start[contact.normal + 1]; ++k) {
      for (int a = 0; a < 3; ++a)
        un += p.entry(k)[a] * p.target[3 * p.entry_block[k] + a];
    }
    before.push_back(un);
  }
  return c;
}

double energy(const QuadraticProgram& p, const std::vector<double>& x) {
  double sum = 0.0;
  for (int j = 0; j < p.unknowns(); ++j)
    sum += 0.5 * p.mass[j] * x[j] * x[j];
  return sum;
}

void expect_no_rise(int count) {
  CoulombSolver solver;
  std::vector<double> e;
  std::vector<double> before;
  int reduced = 0;
  for (int index = 0; index < count; ++index) {
    const FrictionCase c = random_impact(index, e, before);
    ImpactResult r;
    solver.forget();
    impact_with_restitution(solver, c.view(), e, before, r);
    EXPECT_EQ(r.solution.status, QpStatus::optimal) << index;
    EXPECT_LE(energy(c.program, r.solution.x), energy(c.program, c.program.target) * (1.0 + 1e-12))
        << index;
    if (r.factor < 1.0) ++reduced;
  }
  EXPECT_GT(reduced, 0);
  EXPECT_LT(reduced, 0.3 * count);
}

TEST(Restitution, EnergyNeverRisesInRandomImpacts) { expect_no_rise(200); }

// Takes minutes: coulomb_test --gtest_also_run_disabled_tests --gtest_filter='*TenThousand*'
TEST(Restitution, DISABLED_EnergyNeverRisesInTenThousandImpacts) { expect_no_rise(10000); }

TEST(Restitution, BallOnFloor) {
  FrictionBuilder builder({.mu = 0.2});
  builder.add_body(0.0, 0.5, 1.0, 1.0);
  builder.add_contact(0, ground, 0.0, 0.0, 0.0, 1.0);
  FrictionCase c = builder.take();
  c.program.target = {0.0, -2.0, 0.0};
  CoulombSolver solver;
  ImpactResult r;
  const std::array e{0.5};
  const std::array un{-2.0};
  impact_with_restitution(solver, c.view(), e, un, r);
  EXPECT_EQ(r.factor, 1.0);
  EXPECT_NEAR(r.solution.x[1], 1.0, 1e-13);
  // What does not close does not bounce.
  c.program.target = {0.0, 0.0, 0.0};
  const std::array still{0.0};
  impact_with_restitution(solver, c.view(), e, still, r);
  EXPECT_EQ(r.solution.x[1], 0.0);
}

}  // namespace
}  // namespace wuerfel::test
