/// Which of many forces are shown, and which are called the only ones possible.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/qp/methods/canonical_multipliers.h"
#include "core/qp/qp_solver.h"
#include "tests/support/max_norm.h"
#include "tests/support/qp_least_norm.h"
#include "tests/support/qp_non_negative_least_squares.h"
#include "tests/support/qp_zoo.h"
#include "tests/support/reference_program.h"

namespace wuerfel::test {
namespace {

/// A beam of weight 6 held at x = -1 or so by props that push up; one block (y, angle).
QuadraticProgram beam(const std::vector<double>& props) {
  QuadraticProgram program;
  program.clear(2);
  program.add_block(std::array{1.0, 1.0}, std::array{-6.0, 0.0});
  for (const double x : props) {
    program.add_inequality(0.0);
    program.add_entry(0, std::array{1.0, x});
  }
  return program;
}

QpResult solved(const QuadraticProgram& program) {
  QpResult result;
  make_qp_solver(QpMethod::automatic)->solve(program, result);
  EXPECT_EQ(result.status, QpStatus::optimal);
  return result;
}

LeastNormMultipliers least_norm(const QuadraticProgram& program,
                                std::span<const double> weight = {}) {
  return least_norm_multipliers(program, solved(program).x, weight);
}

//  |_____________|
//  ^             ^      two props: statics decides
TEST(LeastNorm, IsUniqueOnTwoProps) {
  const LeastNormMultipliers result = least_norm(beam({-1.0, 2.0}));
  EXPECT_NEAR(result.multiplier[0], 4.0, 1e-12);
  EXPECT_NEAR(result.multiplier[1], 2.0, 1e-12);
  EXPECT_EQ(result.unique, (std::vector{true, true}));
}

TEST(LeastNorm, SharesEquallyAmongThreePropsOfABeam) {
  const LeastNormMultipliers result = least_norm(beam({-1.0, 0.0, 1.0}));
  for (const double force : result.multiplier)
    EXPECT_NEAR(force, 2.0, 1e-12);
  EXPECT_EQ(result.unique, (std::vector{false, false, false}));
}

//  All weight lies on the left end; without the sign the right props would pull.
TEST(LeastNorm, SeesThatForcesHeldAtZeroByTheirSignAreUnique) {
  const LeastNormMultipliers result = least_norm(beam({0.0, 1.0, 2.0}));
  EXPECT_NEAR(result.multiplier[0], 6.0, 1e-12);
  EXPECT_NEAR(result.multiplier[1], 0.0, 1e-12);
  EXPECT_NEAR(result.multiplier[2], 0.0, 1e-12);
  EXPECT_EQ(result.unique, (std::vector{true, true, true}));
}

TEST(LeastNorm, SeesThatAForceAtZeroMayBePossible) {
  // Of props at -1, 1, 1.5 and 40 the last one is better left alone, but could carry some.
  const LeastNormMultipliers result = least_norm(beam({-1.0, 1.0, 1.5, 40.0}));
  EXPECT_NEAR(result.multiplier[3], 0.0, 1e-12);
  EXPECT_EQ(result.unique, (std::vector{false, false, false, false}));
}

TEST(LeastNorm, CountsForcesInTheUnitsOfTheirWeights) {
  // The same prop twice, once written three times as long: equal forces need multipliers 3 : 1.
  QuadraticProgram program = beam({0.0});
  program.add_inequality(0.0);
  program.add_entry(0, std::array{3.0, 0.0});
  const LeastNormMultipliers result = least_norm(program, std::array{1.0, 3.0});
  EXPECT_NEAR(result.multiplier[0], 3.0, 1e-12);
  EXPECT_NEAR(result.multiplier[1], 1.0, 1e-12);
}

TEST(LeastNorm, LeavesRowsOfWeightZeroOutOfTheSum) {
  // Two equal props and an equality that could carry everything.
  QuadraticProgram program = beam({0.0, 0.0});
  program.add_equality(0.0);
  program.add_entry(0, std::array{1.0, 0.0});
  const LeastNormMultipliers result = least_norm(program, std::array{1.0, 1.0, 0.0});
  EXPECT_NEAR(result.multiplier[0], 0.0, 1e-12);
  EXPECT_NEAR(result.multiplier[1], 0.0, 1e-12);
  EXPECT_NEAR(result.multiplier[2], 6.0, 1e-12);
}

TEST(LeastNorm, KeepsBoundedForcesWithinTheirBounds) {
  // Two bounded rows and one free: equal shares would be 2 each, but the first may carry 1 only.
  QuadraticProgram program = beam({});
  for (const double bound : {1.0, 10.0, 10.0}) {
    program.add_row(0.0, -bound, bound);
    program.add_entry(0, std::array{1.0, 0.0});
  }
  const LeastNormMultipliers result = least_norm(program);
  EXPECT_NEAR(result.multiplier[0], 1.0, 1e-11);
  EXPECT_NEAR(result.multiplier[1], 2.5, 1e-11);
  EXPECT_NEAR(result.multiplier[2], 2.5, 1e-11);
  EXPECT_EQ(result.unique, (std::vector{false, false, false}));
}

TEST(LeastNorm, GivesNothingToRowsThatAreOpen) {
  QuadraticProgram program = beam({-1.0, 1.0, 0.0});
  program.bound[2] = -1.0;
  const LeastNormMultipliers result = least_norm(program);
  EXPECT_EQ(result.multiplier[2], 0.0);
  EXPECT_TRUE(result.unique[2]);
}

TEST(NonNegativeLeastSquares, ObeysItsOptimalityConditions) {
  Dice dice(3);
  for (int trial = 0; trial < 50; ++trial) {
    const int rows = 2 + dice.below(12);
    const int columns = 1 + dice.below(16);
    Eigen::MatrixXd A(rows, columns);
    Eigen::VectorXd f(rows);
    for (double& a : A.reshaped())
      a = dice.uniform(-1.0, 1.0);
    for (double& v : f)
      v = dice.uniform(-1.0, 1.0);
    const Eigen::VectorXd u = non_negative_least_squares(A, f);
    const Eigen::VectorXd gradient = A.transpose() * (f - A * u);
    EXPECT_GE(u.minCoeff(), 0.0);
    EXPECT_LE(gradient.maxCoeff(), 1e-11);
    EXPECT_LE((u.array() * gradient.array()).abs().maxCoeff(), 1e-10);
  }
}

class Canonical : public testing::TestWithParam<int> {};

TEST_P(Canonical, AgreesWithTheDenseOracle) {
  int compared = 0;
  for (int index = 50 * GetParam(); index < 50 * (GetParam() + 1); ++index) {
    const ZooProgram zoo = random_program(index);
    // Jammed walls whose masses differ by 1e6 leave the rank of their contacts in doubt.
    const bool doubtful = zoo.name.find("perturbed") != std::string::npos
                          && zoo.name.find("masses") != std::string::npos;
    if (zoo.program.rows() > 300 || doubtful) continue;
    const QpResult result = solved(zoo.program);
    const LeastNormMultipliers fast =
        canonical_multipliers(zoo.program, result.x, result.multiplier, true);
    const LeastNormMultipliers exact = least_norm_multipliers(zoo.program, result.x);
    // Observed: <= 1e-11, and 4e-9 where contacts are nearly dependent.
    EXPECT_LE(distance(fast.multiplier, exact.multiplier), 2e-8 * largest(exact.multiplier))
        << index << ' ' << zoo.name;
    // The oracle measures all forces by the largest and has no eye for those between light bodies.
    const bool light = zoo.name.find("masses") != std::string::npos;
    for (std::size_t row = 0; row < exact.unique.size(); ++row) {
      if (light && exact.multiplier[row] <= 1e-9 * largest(exact.multiplier)) continue;
      EXPECT_EQ(fast.unique[row], exact.unique[row]) << index << ' ' << zoo.name << ' ' << row;
    }
    EXPECT_LE(optimality_residual(zoo.program, result.x, fast.multiplier).worst(), 1e-10)
        << index << ' ' << zoo.name;
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

INSTANTIATE_TEST_SUITE_P(Fifties, Canonical, testing::Range(0, 4));

TEST(Canonical, ReachesTheExactMultipliersOfTheReferenceCases) {
  for (const std::string& name : reference_program_names()) {
    const ReferenceProgram reference = read_reference_program(name);
    QpResult result;
    make_qp_solver(QpMethod::interior_point)->solve(reference.program, result);
    const LeastNormMultipliers found =
        canonical_multipliers(reference.program, result.x, result.multiplier, true);
    // Observed: <= 2e-12 of the forces; forces between light bodies beside heavy ones are exact to
    // 1e-12 of the weights.
    double weight = 0.0;
    for (std::size_t j = 0; j < result.x.size(); ++j)
      weight = std::max(weight, reference.program.mass[j] * std::abs(reference.program.target[j]));
    const double tolerance =
        std::max(1e-9 * largest(reference.least_norm_multipliers), 1e-11 * weight);
    EXPECT_LE(distance(found.multiplier, reference.least_norm_multipliers), tolerance) << name;
    EXPECT_EQ(std::find(found.unique.begin(), found.unique.end(), false) == found.unique.end(),
              reference.unique)
        << name;
  }
}

TEST(Canonical, IsTheSameFromBothMethodsInALargeWall) {
  const QuadraticProgram program = wall(20, 20);
  std::array<LeastNormMultipliers, 2> found;
  for (const std::size_t k : {0U, 1U}) {
    QpResult result;
    make_qp_solver(k == 0 ? QpMethod::newton : QpMethod::interior_point)->solve(program, result);
    ASSERT_EQ(result.status, QpStatus::optimal);
    found[k] = canonical_multipliers(program, result.x, result.multiplier, true);
  }
  EXPECT_LE(distance(found[0].multiplier, found[1].multiplier),
            1e-9 * largest(found[0].multiplier));
  EXPECT_EQ(found[0].unique, found[1].unique);
}

TEST(Residual, MeasuresComplementarityAsTheSmallerOfForceAndSlack) {
  QuadraticProgram program = beam({0.0});
  // Half of the weight carried and open by 3: forces are relative to 6, accelerations to 6.
  const QpResidual residual = optimality_residual(program, {-3.0, 0.0}, {3.0});
  EXPECT_NEAR(residual.stationarity, 0.0, 1e-15);
  EXPECT_NEAR(residual.primal, 0.5, 1e-15);
  program.bound[0] = -6.0;  // now open by 3 and pushing with 3
  EXPECT_NEAR(optimality_residual(program, {-3.0, 0.0}, {3.0}).complementarity, 0.5, 1e-15);
  program.bound[0] = -3.0 - 6e-11;  // open by next to nothing
  EXPECT_NEAR(optimality_residual(program, {-3.0, 0.0}, {3.0}).complementarity, 1e-11, 1e-15);
}

TEST(Residual, IsInfiniteWhereSomethingIsNotANumber) {
  const QuadraticProgram program = beam({0.0});
  EXPECT_EQ(optimality_residual(program, {std::nan(""), 0.0}, {3.0}).worst(), unbounded);
  EXPECT_EQ(optimality_residual(program, {0.0, 0.0}, {std::nan("")}).worst(), unbounded);
  EXPECT_EQ(optimality_residual(program, {0.0}, {3.0}).worst(), unbounded);
}

TEST(Residual, DoesNotDependOnTheLengthOfRows) {
  QuadraticProgram program = beam({0.0});
  const double before = optimality_residual(program, {-3.0, 0.0}, {3.0}).worst();
  for (double& J : program.coefficients)
    J *= 1000.0;
  EXPECT_NEAR(optimality_residual(program, {-3.0, 0.0}, {3e-3}).worst(), before, 1e-15);
}

}  // namespace
}  // namespace wuerfel::test
