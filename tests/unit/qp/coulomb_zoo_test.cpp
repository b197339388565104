// Random programs of stacks, piles and punched towers, every answer judged by the exact law.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/qp/coulomb/coulomb_solver.h"
#include "tests/support/friction_zoo.h"

namespace wuerfel::test {
namespace {

constexpr double exact = 1e-10;

FrictionCase random_case(int index) {
  Dice dice(static_cast<std::uint64_t>(index) + 77);
  constexpr std::array mus{0.1, 0.3, 0.6, 0.8, 1.0, 2.0};
  FrictionOptions options;
  options.mu = mus[dice.below(6)];
  options.zoo.seed = static_cast<std::uint64_t>(index) + 1;
  if (dice.below(2) == 0) options.zoo.shift = 1e-3;
  if (dice.below(2) == 0) options.zoo.turn = 0.05;
  if (dice.below(3) == 0) options.punch = dice.uniform(-5.0, 5.0);
  if (dice.below(3) == 0) options.spin = dice.uniform(-5.0, 5.0);
  if (dice.below(3) == 0) options.incline = options.mu * dice.uniform(0.8, 1.2);
  options.tumble = dice.below(4) == 0;
  const int size = 1 + dice.below(5);
  switch (dice.below(5)) {
    case 0:
      return friction_tower(size * 3, options);
    case 1:
      return friction_wall(size, 1 + dice.below(4), options);
    case 2:
      return friction_pyramid(size, options);
    case 3:
      return friction_dominoes(size * 3, options);
    default:
      return friction_pile(size * 6, options);
  }
}

double worst(const FrictionCase& c, const CoulombResult& result) {
  return coulomb_residual(c.view(), result.x, result.multiplier).worst();
}

TEST(CoulombZoo, EveryAnswerSatisfiesTheLaw) {
  for (int index = 0; index < 200; ++index) {
    const FrictionCase c = random_case(index);
    CoulombSolver solver;
    CoulombResult result;
    solver.solve(c.view(), result);
    EXPECT_EQ(result.status, QpStatus::optimal) << index;
    EXPECT_LE(worst(c, result), exact) << index << " " << to_string(result.stage);
  }
}

TEST(CoulombZoo, PilesThatTumbleWithStrongFriction) {
  // What interior points came no nearer than 1e-2 to.
  struct Pile {
    int count;
    unsigned seed;
    double mu;
  };
  for (const auto& [count, seed, mu] : {Pile{100, 2, 2.0}, Pile{100, 4, 2.0}, Pile{100, 5, 1.5},
                                        Pile{100, 6, 2.0}, Pile{100, 12, 2.0}, Pile{300, 1, 1.0}}) {
    FrictionOptions options{.mu = mu, .tumble = true};
    options.zoo.seed = seed;
    const FrictionCase c = friction_pile(count, options);
    CoulombSolver solver;
    CoulombResult result;
    solver.solve(c.view(), result);
    EXPECT_EQ(result.status, QpStatus::optimal) << seed;
    EXPECT_LE(worst(c, result), exact) << seed;
  }
}

TEST(CoulombZoo, EnergyNeverRises) {
  const auto energy = [](const QuadraticProgram& p, const std::vector<double>& x) {
    double sum = 0.0;
    for (int j = 0; j < p.unknowns(); ++j)
      sum += 0.5 * p.mass[j] * x[j] * x[j];
    return sum;
  };
  for (int index = 0; index < 100; ++index) {
    const FrictionCase c = random_case(index);
    CoulombSolver solver;
    CoulombResult result;
    solver.solve(c.view(), result);
    const double before = energy(c.program, c.program.target);
    EXPECT_LE(energy(c.program, result.x), before * (1.0 + 1e-9)) << index;
  }
}

TEST(CoulombZoo, TheSameAnswerTheSecondTimeAndAfterForgetting) {
  const FrictionCase c = random_case(7);
  CoulombSolver solver;
  CoulombResult first;
  CoulombResult again;
  solver.solve(c.view(), first);
  solver.solve(random_case(8).view(), again);
  solver.forget();
  solver.solve(c.view(), again);
  EXPECT_EQ(first.x, again.x);
  EXPECT_EQ(first.multiplier, again.multiplier);
}

TEST(CoulombZoo, AlmostNoFrictionIsNoFriction) {
  for (int index = 0; index < 30; ++index) {
    FrictionCase c = random_case(index);
    for (FrictionContact& contact : c.contacts)
      contact.mu = 1e-12;
    CoulombSolver solver;
    CoulombResult rubbing;
    solver.solve(c.view(), rubbing);
    EXPECT_LE(worst(c, rubbing), exact);
    QuadraticProgram plain = c.program;
    for (const FrictionContact& contact : c.contacts)
      plain.force_min[contact.tangent] = plain.force_max[contact.tangent] = 0.0;
    QpResult smooth;
    make_qp_solver(QpMethod::automatic)->solve(plain, smooth);
    ASSERT_EQ(smooth.status, QpStatus::optimal);
    double size = 0.0;
    for (const double f : c.program.target)
      size = std::max(size, std::abs(f));
    for (int j = 0; j < plain.unknowns(); ++j)
      EXPECT_NEAR(rubbing.x[j], smooth.x[j], 1e-9 * size) << index;
  }
}

TEST(CoulombZoo, HugeFriction) {
  for (int index = 0; index < 40; ++index) {
    FrictionCase c = random_case(index);
    for (FrictionContact& contact : c.contacts)
      contact.mu = 1e6;
    CoulombSolver solver;
    CoulombResult result;
    solver.solve(c.view(), result);
    EXPECT_LE(worst(c, result), exact) << index << " " << to_string(result.stage);
  }
}

TEST(CoulombZoo, MassesThatDifferByAMillion) {
  for (int index = 0; index < 12; ++index) {
    FrictionOptions options{.mu = 0.1 + 0.15 * index};
    options.zoo.masses = index % 2 == 0 ? Masses::alternating_1e6 : Masses::random_to_1e6;
    options.zoo.seed = static_cast<std::uint64_t>(index) + 1;
    if (index % 3 == 0) options.punch = 2.0;
    const FrictionCase c = friction_tower(4 + index, options);
    CoulombSolver solver;
    CoulombResult result;
    solver.solve(c.view(), result);
    EXPECT_LE(worst(c, result), exact) << index << " " << to_string(result.stage);
  }
}

/// Another order of bodies and contacts: unique motions stay what they are.
FrictionCase permuted(const FrictionCase& c, std::vector<int>& body) {
  const QuadraticProgram& p = c.program;
  body.resize(p.blocks());
  std::iota(body.begin(), body.end(), 0);
  std::reverse(body.begin(), body.end());
  FrictionCase other;
  other.program.clear(3);
  for (int b = 0; b < p.blocks(); ++b) {
    const int from = 3 * (p.blocks() - 1 - b);
    other.program.add_block({p.mass.data() + from, 3}, {p.target.data() + from, 3});
  }
  const std::vector reversed(c.contacts.rbegin(), c.contacts.rend());
  for (const auto& contact : reversed) {
    const int first = other.program.rows();
    for (const int row : {contact.normal, contact.tangent}) {
      other.program.add_row(p.bound[row], p.force_min[row], p.force_max[row]);
      for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e)
        other.program.add_entry(body[p.entry_block[e]], p.entry(e));
    }
    other.contacts.push_back({.normal = first, .tangent = first + 1, .mu = contact.mu});
  }
  return other;
}

TEST(CoulombZoo, PermutationOfBodiesAndContacts) {
  for (int index = 0; index < 20; ++index) {
    const FrictionCase c = friction_tower(2 + index, {.mu = 0.4, .punch = 2.0});
    std::vector<int> body;
    const FrictionCase other = permuted(c, body);
    CoulombSolver solver;
    CoulombResult a;
    CoulombResult b;
    solver.solve(c.view(), a);
    solver.forget();
    solver.solve(other.view(), b);
    for (int j = 0; j < c.program.unknowns(); ++j)
      EXPECT_NEAR(a.x[j], b.x[3 * body[j / 3] + j % 3], 1e-8) << index;
  }
}

TEST(CoulombZoo, MirrorImage) {
  for (int index = 0; index < 20; ++index) {
    const FrictionCase c = friction_tower(2 + index, {.mu = 0.4, .punch = 2.0});
    FrictionCase mirror = c;
    QuadraticProgram& p = mirror.program;
    const auto turn = [](std::vector<double>& v, double first, double last) {
      for (std::size_t j = 0; j < v.size(); j += 3) {
        v[j] *= first;
        v[j + 2] *= last;
      }
    };
    turn(p.target, -1.0, -1.0);
    turn(p.coefficients, -1.0, -1.0);
    // Tangents are the normals turned left, so that they turn about.
    for (const FrictionContact& contact : c.contacts) {
      for (int k = 3 * p.row_start[contact.tangent]; k < 3 * p.row_start[contact.tangent + 1]; ++k)
        p.coefficients[k] *= -1.0;
    }
    CoulombSolver solver;
    CoulombResult a;
    CoulombResult b;
    solver.solve(c.view(), a);
    solver.forget();
    solver.solve(mirror.view(), b);
    turn(b.x, -1.0, -1.0);
    for (int j = 0; j < p.unknowns(); ++j)
      EXPECT_NEAR(a.x[j], b.x[j], 1e-8) << index;
  }
}

}  // namespace
}  // namespace wuerfel::test
