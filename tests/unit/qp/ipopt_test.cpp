/// The referee on programs whose exact answers are known.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/qp/qp_solver.h"
#include "tests/support/max_norm.h"
#include "tests/support/qp_least_norm.h"
#include "tests/support/reference_program.h"

namespace wuerfel::test {
namespace {

// Accelerations relative to the largest |f|; observed: <= 2e-12 (mass ratio 1e6), elsewhere <=
// 1e-14.
constexpr double acceleration_tolerance = 1e-10;
// Relative to the largest multiplier; observed: <= 2e-11 (mass ratio 1e6).
constexpr double force_tolerance = 1e-9;

double objective(const QuadraticProgram& program, const std::vector<double>& x) {
  double sum = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j)
    sum += program.mass[j] * (x[j] - program.target[j]) * (x[j] - program.target[j]);
  return sum;
}

class IpoptReference : public testing::TestWithParam<std::string> {};

TEST_P(IpoptReference, ReachesTheExactAnswer) {
  const ReferenceProgram reference = read_reference_program(GetParam());
  const auto solver = make_qp_solver(QpMethod::ipopt);
  QpResult result;
  solver->solve(reference.program, result);
  EXPECT_EQ(result.status, QpStatus::optimal) << solver->trouble();
  EXPECT_LE(result.residual.worst(), 1e-10);
  EXPECT_LE(distance(result.x, reference.x),
            acceleration_tolerance * largest(reference.program.target));
  EXPECT_NEAR(objective(reference.program, result.x), reference.objective,
              1e-10 * std::abs(reference.objective));
}

TEST_P(IpoptReference, LeadsToTheLeastNormMultipliers) {
  const ReferenceProgram reference = read_reference_program(GetParam());
  const auto solver = make_qp_solver(QpMethod::ipopt);
  QpResult result;
  solver->solve(reference.program, result);
  const LeastNormMultipliers least = least_norm_multipliers(reference.program, result.x);
  EXPECT_LE(distance(least.multiplier, reference.least_norm_multipliers),
            force_tolerance * largest(reference.least_norm_multipliers));
  // The reference knows the flag for the whole case only.
  const bool all_unique =
      std::all_of(least.unique.begin(), least.unique.end(), [](bool u) { return u; });
  EXPECT_EQ(all_unique, reference.unique);
}

INSTANTIATE_TEST_SUITE_P(Cases,
                         IpoptReference,
                         testing::ValuesIn(reference_program_names()),
                         [](const auto& test_case) { return test_case.param; });

}  // namespace
}  // namespace wuerfel::test
