/// Programs whose tight rows are known or guessed.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/qp/methods/active_set_method.h"
#include "tests/support/max_norm.h"
#include "tests/support/qp_zoo.h"

namespace wuerfel::test {
namespace {

/// The marked rows of a program as equalities, and no others.
QuadraticProgram reduced(const QuadraticProgram& p, const std::vector<char>& tight) {
  QuadraticProgram result;
  result.clear(p.block_size);
  result.mass = p.mass;
  result.target = p.target;
  for (int row = 0; row < p.rows(); ++row) {
    if (tight[row] == 0) continue;
    result.add_equality(p.bound[row]);
    for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e)
      result.add_entry(p.entry_block[e], p.entry(e));
  }
  return result;
}

TEST(Equality, TakesMarkedRowsAsIfTheOthersWereNotThere) {
  const QuadraticProgram program = pile(30);
  std::vector<char> tight(program.bound.size());
  for (std::size_t row = 0; row < tight.size(); ++row)
    tight[row] = row % 3 != 0 ? 1 : 0;
  EqualitySolver masked;
  EqualitySolver whole;
  std::vector<double> x, forces, reduced_x, reduced_forces;
  masked.factorise(program, &tight);
  masked.solve(program, x, forces);
  const QuadraticProgram rest = reduced(program, tight);
  whole.factorise(rest);
  whole.solve(rest, reduced_x, reduced_forces);
  EXPECT_EQ(x, reduced_x);
  std::size_t next = 0;
  for (std::size_t row = 0; row < tight.size(); ++row)
    EXPECT_EQ(forces[row], tight[row] != 0 ? reduced_forces[next++] : 0.0);
}

TEST(Equality, LeavesOutRowsThatDependOnOthers) {
  QuadraticProgram program = tower(3);
  const int rows = program.rows();
  for (int copy = 0; copy < 2; ++copy) {
    program.add_inequality(program.bound[0]);
    for (int e = program.row_start[0]; e < program.row_start[1]; ++e)
      program.add_entry(program.entry_block[e], program.entry(e));
  }
  EqualitySolver solver;
  std::vector<double> x, forces;
  solver.factorise(program);
  EXPECT_EQ(solver.dependent_rows(), 2);
  solver.solve(program, x, forces);
  for (int row = 0; row < program.rows(); ++row)
    EXPECT_NEAR(program.slack(row, x), 0.0, 1e-14);
  const std::array shares{forces[0], forces[rows], forces[rows + 1]};
  EXPECT_EQ(std::ranges::count(shares, 0.0), 2);
}

TEST(ActiveSet, FindsTheRowsFromAGuess) {
  for (const QuadraticProgram& program : {tower(10), pile(20)}) {
    QpResult expected;
    make_qp_solver(QpMethod::newton)->solve(program, expected);
    std::vector<char> tight(program.bound.size());
    for (std::size_t row = 0; row < tight.size(); ++row)
      tight[row] = expected.multiplier[row] > 1e-9 * largest(expected.multiplier) ? 1 : 0;
    ActiveSetMethod method;
    QpResult result;
    ASSERT_TRUE(method.solve(program, 1e-12, tight, result));
    EXPECT_LE(distance(result.x, expected.x), 1e-10);
    tight[0] = tight[0] != 0 ? 0 : 1;  // one row wrong
    ASSERT_TRUE(method.solve(program, 1e-12, tight, result));
    EXPECT_LE(distance(result.x, expected.x), 1e-10);
  }
}

//   A feather of 1e-9 kg between two bodies of 1 kg that fall onto it: what holds it in balance is
//   1e-9 of the forces on it.
TEST(ActiveSet, RefinesLightBodiesBesideHeavyOnes) {
  QuadraticProgram program;
  program.clear(1);
  const std::array masses{1.0, 1e-9, 1.0};
  const std::array targets{3.0, -9.81, -1.0};
  for (std::size_t i = 0; i < masses.size(); ++i)
    program.add_block(std::array{masses[i]}, std::array{targets[i]});
  for (const int i : {0, 1}) {
    program.add_inequality(0.0);  // x_{i+1} >= x_i
    program.add_entry(i, std::array{-1.0});
    program.add_entry(i + 1, std::array{1.0});
  }
  const double together = (3.0 - 9.81e-9 - 1.0) / (2.0 + 1e-9);
  QpResult rough;
  rough.x = {together, together + 1e-5, together};
  rough.multiplier = {3.0 - together, together + 1.0};
  rough.residual = optimality_residual(program, rough.x, rough.multiplier);
  ResidualMeter meter;
  meter.measure_scales(program);
  ActiveSetMethod().refine(program, rough);
  EXPECT_LE(rough.residual.worst(), 1e-15);
  EXPECT_LE(meter.imbalance(program, rough.x, rough.multiplier), 1e-15);
  for (const double x : rough.x)
    EXPECT_NEAR(x, together, 1e-15);
}

TEST(Imbalance, IsRelativeToTheForcesOnEveryBody) {
  QuadraticProgram program;
  program.clear(1);
  program.add_block(std::array{1.0}, std::array{-1.0});
  program.add_block(std::array{1e-4}, std::array{-1.0});
  for (const int i : {0, 1}) {
    program.add_inequality(0.0);
    program.add_entry(i, std::array{1.0});
  }
  ResidualMeter meter;
  meter.measure_scales(program);
  EXPECT_EQ(meter.imbalance(program, {0.0, 0.0}, {1.0, 1e-4}), 0.0);
  EXPECT_NEAR(meter.imbalance(program, {0.0, 0.0}, {1.0, 0.9e-4}), 0.1, 1e-12);
  EXPECT_LE(optimality_residual(program, {0.0, 0.0}, {1.0, 0.9e-4}).worst(), 1.1e-5);
  program.mass[1] = 1e-9;  // so light that the heavy one's millionth is its scale
  meter.measure_scales(program);
  EXPECT_NEAR(meter.imbalance(program, {0.0, 0.0}, {1.0, 0.0}), 1e-3, 1e-8);
}

}  // namespace
}  // namespace wuerfel::test
