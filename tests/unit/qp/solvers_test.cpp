/// Every solver on programs whose exact answers are known, and what all of them promise about bad
/// programs.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "core/qp/qp_solver.h"
#include "tests/support/max_norm.h"
#include "tests/support/qp_zoo.h"
#include "tests/support/reference_program.h"
#include "tests/unit/qp/all_methods.h"

namespace wuerfel::test {
namespace {

class Reference : public testing::TestWithParam<std::tuple<QpMethod, std::string>> {};

TEST_P(Reference, IsReached) {
  const auto& [method, name] = GetParam();
  const ReferenceProgram reference = read_reference_program(name);
  const QpResult result = solve_by(method, reference.program);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_LE(result.residual.worst(), 1e-10);
  // Observed: <= 2e-11 where masses are alike, <= 3e-9 (interior-point) where they differ by 1e6.
  const auto [light, heavy] = std::ranges::minmax(reference.program.mass);
  const double tolerance = heavy / light > 1e4 ? 1e-7 : 1e-9;
  EXPECT_LE(distance(result.x, reference.x), tolerance * largest(reference.program.target));
}

INSTANTIATE_TEST_SUITE_P(Cases,
                         Reference,
                         testing::Combine(testing::Values(QpMethod::automatic,
                                                          QpMethod::newton,
                                                          QpMethod::interior_point),
                                          testing::ValuesIn(reference_program_names())),
                         [](const auto& test_case) {
                           return readable(std::get<0>(test_case.param)) + "_"
                                  + std::get<1>(test_case.param);
                         });

class EverySolver : public testing::TestWithParam<QpMethod> {};

TEST_P(EverySolver, LeavesAProgramWithoutRowsAtItsTarget) {
  const QuadraticProgram program = falling_point();
  const QpResult result = solve_by(GetParam(), program);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_EQ(result.x, program.target);
  EXPECT_TRUE(result.multiplier.empty());
}

TEST_P(EverySolver, LeavesWhatNothingAcceleratesWhereItIs) {
  QuadraticProgram program = falling_point();
  program.target = {0.0, 0.0};
  program.add_inequality(0.0);
  program.add_entry(0, std::array{0.0, 2.0});
  const QpResult result = solve_by(GetParam(), program);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_EQ(result.x, program.target);
  EXPECT_EQ(result.multiplier, std::vector{0.0});
}

TEST_P(EverySolver, AcceptsTheEmptyProgram) {
  const QpResult result = solve_by(GetParam(), QuadraticProgram{});
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_TRUE(result.x.empty());
}

TEST_P(EverySolver, CarriesTheWeightOnOneRow) {
  QuadraticProgram program = falling_point();
  program.add_inequality(0.0);
  program.add_entry(0, std::array{0.0, 2.0});
  const QpResult result = solve_by(GetParam(), program);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_NEAR(result.x[1], 0.0, 1e-9);
  EXPECT_NEAR(result.multiplier[0], 9.81 / 2.0, 1e-9);
}

TEST_P(EverySolver, LetsGoOfARowThatOpens) {
  QuadraticProgram program = falling_point();
  program.add_inequality(-20.0);
  program.add_entry(0, std::array{0.0, 1.0});
  const QpResult result = solve_by(GetParam(), program);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_NEAR(result.x[1], -9.81, 1e-9);
  EXPECT_NEAR(result.multiplier[0], 0.0, 1e-9);
}

/// A point on the floor is pushed sideways by 2; friction holds up to its bound and then only
/// brakes.
TEST_P(EverySolver, HoldsABoundedRowUpToItsBoundAndNoFurther) {
  for (const double bound : {3.0, 0.5}) {
    QuadraticProgram program = falling_point();
    program.target[0] = 2.0;
    program.add_inequality(0.0);
    program.add_entry(0, std::array{0.0, 1.0});
    program.add_row(0.0, -bound, bound);
    program.add_entry(0, std::array{1.0, 0.0});
    const QpResult result = solve_by(GetParam(), program);
    EXPECT_EQ(result.status, QpStatus::optimal);
    EXPECT_NEAR(result.x[0], std::max(2.0 - bound, 0.0), 1e-9);
    EXPECT_NEAR(result.multiplier[1], -std::min(2.0, bound), 1e-9);
  }
}

TEST_P(EverySolver, IgnoresARowWithoutForce) {
  QuadraticProgram program = falling_point();
  program.add_row(5.0, 0.0, 0.0);
  program.add_entry(0, std::array{0.0, 1.0});
  const QpResult result = solve_by(GetParam(), program);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_NEAR(result.x[1], -9.81, 1e-12);
}

TEST_P(EverySolver, IgnoresRowsOfZerosThatHold) {
  QuadraticProgram program = falling_point();
  program.add_inequality(-1.0);
  program.add_inequality(0.0);
  program.add_entry(0, std::array{0.0, 0.0});
  program.add_equality(0.0);
  const QpResult result = solve_by(GetParam(), program);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_NEAR(result.x[1], -9.81, 1e-12);
}

TEST_P(EverySolver, CallsARowOfZerosThatCannotHoldInfeasible) {
  for (const bool with_another : {false, true}) {
    QuadraticProgram program = falling_point();
    program.add_inequality(1.0);
    program.add_entry(0, std::array{0.0, 0.0});
    if (with_another) {
      program.add_inequality(0.0);
      program.add_entry(0, std::array{0.0, 1.0});
    }
    EXPECT_EQ(solve_by(GetParam(), program).status, QpStatus::infeasible);
  }
}

TEST_P(EverySolver, CallsAWedgeInfeasible) {
  QuadraticProgram program = falling_point();
  program.add_inequality(1.0);  // upwards at least 1,
  program.add_entry(0, std::array{0.0, 1.0});
  program.add_inequality(1.0);  // downwards at least 1
  program.add_entry(0, std::array{0.0, -1.0});
  EXPECT_EQ(solve_by(GetParam(), program).status, QpStatus::infeasible);
}

TEST_P(EverySolver, CallsContradictingEqualitiesInfeasible) {
  QuadraticProgram program = falling_point();
  for (const double b : {1.0, 2.0}) {
    program.add_equality(b);
    program.add_entry(0, std::array{1.0, 1.0});
  }
  EXPECT_EQ(solve_by(GetParam(), program).status, QpStatus::infeasible);
}

TEST_P(EverySolver, DoesNotCallAWedgedTowerOptimal) {
  QuadraticProgram program = tower(5);
  // A press: the topmost cube is driven down, the ground does not give.
  program.add_inequality(3.0);
  program.add_entry(4, std::array{0.0, -1.0, 0.0});
  const QpStatus status = solve_by(GetParam(), program).status;
  EXPECT_TRUE(status == QpStatus::infeasible || status == QpStatus::inaccurate)
      << to_string(status);
}

TEST_P(EverySolver, FollowsMoreEqualitiesThanUnknowns) {
  QuadraticProgram program = falling_point();
  for (int k = 1; k <= 4; ++k) {
    program.add_equality(2.0 * k);
    program.add_entry(0, std::array{1.0 * k, 1.0 * k});
    program.add_equality(0.0);
    program.add_entry(0, std::array{1.0 * k, -1.0 * k});
  }
  const QpResult result = solve_by(GetParam(), program);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_NEAR(result.x[0], 1.0, 1e-8);
  EXPECT_NEAR(result.x[1], 1.0, 1e-8);
}

TEST_P(EverySolver, SharesTheWeightAmongCopiesOfARow) {
  const int copies = GetParam() == QpMethod::ipopt ? 100 : 5000;
  QuadraticProgram program = falling_point();
  for (int k = 0; k < copies; ++k) {
    program.add_inequality(0.0);
    program.add_entry(0, std::array{0.0, 1.0});
  }
  const QpResult result = solve_by(GetParam(), program);
  EXPECT_EQ(result.status, QpStatus::optimal);
  double sum = 0.0;
  for (const double lambda : result.multiplier)
    sum += lambda;
  EXPECT_NEAR(sum, 9.81, 1e-7);
  EXPECT_NEAR(result.x[1], 0.0, 1e-9);
}

TEST_P(EverySolver, HandlesBlocksOfAnySize) {
  for (const int size : {1, 2, 3, 4, 7}) {
    QuadraticProgram program;
    program.clear(size);
    const std::vector<double> ones(static_cast<std::size_t>(size), 1.0);
    for (int block = 0; block < 4; ++block)
      program.add_block(ones, std::vector<double>(static_cast<std::size_t>(size), -1.0));
    std::vector<double> coefficients(static_cast<std::size_t>(size), 0.0);
    coefficients.back() = 1.0;
    program.add_inequality(0.0);
    program.add_entry(0, coefficients);
    for (int block = 1; block < 4; ++block) {
      program.add_inequality(0.0);
      program.add_entry(block, coefficients);
      program.add_entry(block - 1, std::vector<double>{[&] {
                          auto c = coefficients;
                          c.back() = -1.0;
                          return c;
                        }()});
    }
    const QpResult result = solve_by(GetParam(), program);
    EXPECT_EQ(result.status, QpStatus::optimal) << size;
    for (int block = 0; block < 4; ++block)
      EXPECT_NEAR(result.x[static_cast<std::size_t>(block * size + size - 1)], 0.0, 1e-9) << size;
    EXPECT_NEAR(result.multiplier[0], 4.0, 1e-9) << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods,
                         EverySolver,
                         testing::ValuesIn(all_methods),
                         [](const auto& test_case) { return readable(test_case.param); });

}  // namespace
}  // namespace wuerfel::test
