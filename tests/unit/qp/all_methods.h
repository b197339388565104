/// What tests of every solver share.
#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "core/qp/qp_solver.h"

namespace wuerfel::test {

inline constexpr std::array all_methods{QpMethod::automatic, QpMethod::newton,
                                        QpMethod::interior_point, QpMethod::ipopt};

inline std::string readable(QpMethod method) {
  std::string name(to_string(method));
  std::ranges::replace(name, '-', '_');
  return name;
}

inline QpResult solve_by(QpMethod method, const QuadraticProgram& program) {
  QpResult result;
  make_qp_solver(method)->solve(program, result);
  return result;
}

/// One block of two unknowns with masses 1 and target (0, -g).
inline QuadraticProgram falling_point() {
  QuadraticProgram program;
  program.clear(2);
  program.add_block(std::array{1.0, 1.0}, std::array{0.0, -9.81});
  return program;
}

}  // namespace wuerfel::test
