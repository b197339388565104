// Kind `rods`: frameworks of points and rods, built straight from Eq. (1) and solved by Gauss'
// program.
#include <gtest/gtest.h>

#include "core/constraints/rod.h"
#include "core/qp/qp_solver.h"
#include "tests/support/qp_least_norm.h"
#include "tests/support/reference_case.h"

namespace wuerfel::test {
namespace {

constexpr double acceleration_tolerance = 1e-9;
constexpr double force_tolerance = 1e-8;

class Truss : public testing::TestWithParam<std::string> {};

/// Rows: rods, then pins (x and y), then floor points.
QuadraticProgram truss_program(const nlohmann::json& data) {
  QuadraticProgram program;
  program.clear(2);
  std::vector<Vec2> p;
  for (std::size_t k = 0; k < data["points"].size(); ++k) {
    p.emplace_back(data["points"][k][0].get<double>(), data["points"][k][1].get<double>());
    const double m = data["masses"][k];
    Vec2 f(0.0, data["gravity_on"].get<bool>() ? -9.81 : 0.0);
    const std::string name = std::to_string(k);
    if (data["loads"].contains(name)) {
      f += Vec2(data["loads"][name][0].get<double>(), data["loads"][name][1].get<double>()) / m;
    }
    program.add_block(std::array{m, m}, std::array{f.x(), f.y()});
  }
  for (const auto& rod : data["rods"]) {
    const int i = rod[0];
    const int j = rod[1];
    const Vec2& p_i = p[static_cast<std::size_t>(i)];
    const Vec2& p_j = p[static_cast<std::size_t>(j)];
    const RodRow row = rod_acceleration_row(p_i, p_j, Vec2::Zero(), Vec2::Zero());
    const Vec2 g = row.g / (p_i - p_j).norm();
    program.add_equality(-row.c);
    program.add_entry(i, std::array{g.x(), g.y()});
    program.add_entry(j, std::array{-g.x(), -g.y()});
  }
  for (const auto& pin : data["pins"]) {
    const int point = pin[0];
    program.add_equality(0.0);
    program.add_entry(point, pin[1] == "x" ? std::array{1.0, 0.0} : std::array{0.0, 1.0});
  }
  for (const auto& point : data["floor_points"]) {
    program.add_inequality(0.0);
    program.add_entry(point.get<int>(), std::array{0.0, 1.0});
  }
  return program;
}

TEST_P(Truss, AccelerationsAndForcesAreExact) {
  const ReferenceCase reference = read_reference_case(GetParam());
  const QuadraticProgram program = truss_program(reference.data);
  QpResult result;
  make_qp_solver(QpMethod::ipopt)->solve(program, result);
  ASSERT_EQ(result.status, QpStatus::optimal);
  const LeastNormMultipliers forces = least_norm_multipliers(program, result.x);
  const std::size_t rods = reference.data["rods"].size();
  for (const auto& expected : reference.data["expected"]) {
    const auto& value = expected["value"];
    if (expected["type"] == "point_accelerations") {
      for (std::size_t k = 0; k < value.size(); ++k) {
        EXPECT_NEAR(result.x[2 * k], value[k][0].get<double>(), acceleration_tolerance);
        EXPECT_NEAR(result.x[2 * k + 1], value[k][1].get<double>(), acceleration_tolerance);
      }
    } else if (expected["type"] == "rod_tensions") {
      for (std::size_t k = 0; k < rods; ++k) {
        EXPECT_NEAR(-forces.multiplier[k], value[k].get<double>(), force_tolerance) << "rod " << k;
      }
    } else if (expected["type"] == "support_forces") {
      for (std::size_t k = 0; k < value.size(); ++k) {
        EXPECT_NEAR(forces.multiplier[rods + k], value[k].get<double>(), force_tolerance)
            << "support " << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Reference,
                         Truss,
                         testing::ValuesIn(reference_case_names("rods")),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace wuerfel::test
