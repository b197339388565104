/// What every solver promises about programs that are malformed or of numbers of all sizes.
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/qp_zoo.h"
#include "tests/unit/qp/all_methods.h"

namespace wuerfel::test {
namespace {

class HostileProgram : public testing::TestWithParam<QpMethod> {};

/// Numbers of all sizes, so that rounding eats whatever a method lives on.
QuadraticProgram wild_program(std::uint64_t seed) {
  Dice dice(seed);
  const auto number = [&] { return std::ldexp(dice.below(256) - 128.0, dice.below(200) - 100); };
  QuadraticProgram program;
  program.clear(1 + dice.below(4));
  const auto numbers = [&](double least) {
    std::vector<double> result(program.block_size);
    for (double& v : result)
      v = least > 0.0 ? std::abs(number()) + least : number();
    return result;
  };
  const int blocks = 1 + dice.below(4);
  for (int block = 0; block < blocks; ++block)
    program.add_block(numbers(1e-6), numbers(0.0));
  const int rows = dice.below(9);
  for (int row = 0; row < rows; ++row) {
    const int kind = dice.below(3);
    const double bound = std::abs(number());
    program.add_row(number(),
                    kind == 0   ? -unbounded
                    : kind == 1 ? 0.0
                                : -bound,
                    kind == 2 ? bound : unbounded);
    for (int block = 0; block < blocks; ++block)
      if (dice.below(2) == 0) program.add_entry(block, numbers(0.0));
  }
  return program;
}

/// Newton once went on for ever, with steps of no length, on one in some thousand of these.
TEST_P(HostileProgram, EndsOnNumbersOfAllSizes) {
  if (GetParam() == QpMethod::ipopt) GTEST_SKIP() << "not ours";
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    const QuadraticProgram program = wild_program(seed);
    const QpResult result = solve_by(GetParam(), program);
    EXPECT_NE(result.status, QpStatus::invalid) << seed;
    if (result.status == QpStatus::optimal) {
      EXPECT_LE(optimality_residual(program, result.x, result.multiplier).worst(), 1e-10) << seed;
    }
  }
}

/// 0 >= 40 is false, and 0 >= -40 true, however large other rows are.
TEST_P(HostileProgram, JudgesARowOfZerosByItself) {
  for (const double other : {1.0, 1e10, 1e100}) {
    for (const double bound : {-40.0, 40.0}) {
      QuadraticProgram program;
      program.clear(1);
      program.add_block(std::array{2.0}, std::array{-3.0});
      program.add_equality(0.0);
      program.add_entry(0, std::array{other});
      program.add_inequality(bound);
      program.add_entry(0, std::array{0.0});
      EXPECT_EQ(solve_by(GetParam(), program).status,
                bound > 0.0 ? QpStatus::infeasible : QpStatus::optimal)
          << bound << " beside a row of " << other;
    }
  }
}

/// The second and the fourth row bound the same, apart by less than the tolerance allows of so long a
/// row: what one method solves no other calls infeasible.
TEST_P(HostileProgram, CallsNothingInfeasibleThatPassesForSolved) {
  QuadraticProgram program;
  program.clear(3);
  program.add_block(std::array{235.0, 23.0, 185.25}, std::array{3.0, 19.25, -100.0});
  program.add_inequality(48.0);
  program.add_entry(0, std::array{-128.0, -32.0, -32.0});
  program.add_equality(30.5);
  program.add_entry(0, std::array{-18.0, -5.75764e13, 57.0});
  program.add_inequality(40.0);
  program.add_entry(0, std::array{-100.0, -6.5, 48.0});
  program.add_inequality(106.0);
  program.add_entry(0, std::array{-18.0, -5.75764e13, 57.0});
  EXPECT_NE(solve_by(GetParam(), program).status, QpStatus::infeasible);
}

/// A body between two walls, one of which is out of plumb by 1e-9: it holds the body with 1e9 weights, and rest is a solution.
TEST_P(HostileProgram, CallsNothingInfeasibleThatAllowsRest) {
  QuadraticProgram program;
  program.clear(3);
  program.add_block(std::array{3.0, 3.0, 1.0}, std::array{0.0, -9.81, 0.0});
  const std::array rows{std::array{1.0, 0.0, 0.9}, std::array{1.0, 0.0, 0.3},
                        std::array{-1.0, 0.0, -0.8}, std::array{-1.0, 1e-9, -0.9}};
  for (const std::array<double, 3>& row : rows) {
    program.add_inequality(0.0);
    program.add_entry(0, row);
  }
  ASSERT_TRUE(program.allows_rest());
  EXPECT_NE(solve_by(GetParam(), program).status, QpStatus::infeasible);
}

TEST_P(HostileProgram, NamesWhatIsWrongWithAMalformedProgram) {
  const auto refuses = [](const QuadraticProgram& program) {
    const auto solver = make_qp_solver(GetParam());
    QpResult result;
    solver->solve(program, result);
    EXPECT_EQ(result.status, QpStatus::invalid);
    EXPECT_FALSE(solver->trouble().empty());
    EXPECT_EQ(solver->trouble(), defect(program));
  };
  QuadraticProgram good = falling_point();
  good.add_inequality(0.0);
  good.add_entry(0, std::array{0.0, 1.0});
  EXPECT_TRUE(defect(good).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses_with = [&](auto&& spoil) {
    QuadraticProgram bad = good;
    spoil(bad);
    refuses(bad);
  };
  refuses_with([](auto& p) { p.mass[0] = 0.0; });
  refuses_with([](auto& p) { p.mass[1] = -1.0; });
  refuses_with([&](auto& p) { p.mass[1] = nan; });
  refuses_with([&](auto& p) { p.target[1] = nan; });
  refuses_with([&](auto& p) { p.bound[0] = nan; });
  refuses_with([](auto& p) { p.bound[0] = unbounded; });
  refuses_with([&](auto& p) { p.coefficients[1] = nan; });
  refuses_with([&](auto& p) { p.force_min[0] = nan; });
  refuses_with([](auto& p) { p.force_min[0] = 1.0; });
  refuses_with([](auto& p) { p.force_max[0] = -1.0; });
  refuses_with([](auto& p) { p.entry_block[0] = 1; });
  refuses_with([](auto& p) { p.entry_block[0] = -1; });
  refuses_with([](auto& p) { p.add_entry(0, std::array{1.0, 1.0}); });
  refuses_with([](auto& p) { p.mass.push_back(1.0); });
  refuses_with([](auto& p) { p.target.pop_back(); });
  refuses_with([](auto& p) { p.row_start.back() = 7; });
  refuses_with([](auto& p) { p.row_start.clear(); });
  refuses_with([](auto& p) { p.block_size = 0; });
  refuses_with([](auto& p) { p.coefficients.pop_back(); });
}

TEST_P(HostileProgram, GoesOnAfterAMalformedProgram) {
  const auto solver = make_qp_solver(GetParam());
  QuadraticProgram program = tower(3);
  QpResult result;
  solver->solve(program, result);
  EXPECT_EQ(result.status, QpStatus::optimal);
  program.mass[0] = -1.0;
  solver->solve(program, result);
  EXPECT_EQ(result.status, QpStatus::invalid);
  solver->solve(tower(4), result);
  EXPECT_EQ(result.status, QpStatus::optimal);
}
INSTANTIATE_TEST_SUITE_P(Methods,
                         HostileProgram,
                         testing::ValuesIn(all_methods),
                         [](const auto& test_case) { return readable(test_case.param); });

}  // namespace
}  // namespace wuerfel::test
