/// The reference programs of kind `qp`: exact answers to small programs, as data. Format:
/// tests/data/README.md.
#pragma once

#include <string>
#include <vector>

#include "core/qp/quadratic_program.h"

namespace wuerfel::test {

/// minimise sum M_i (x_i - F_i)^2 under the equalities E x = d, which are the first rows, and J x
/// >= b, which follow.
struct ReferenceProgram {
  std::string name;
  QuadraticProgram program;
  std::vector<double> x;
  double objective = 0.0;                      ///< sum M_i (x_i - F_i)^2, without 1/2
  std::vector<double> least_norm_multipliers;  ///< (nu, lambda)
  bool unique = true;  ///< whether all multipliers are the only ones possible
};

/// `stem` is the name of the file without folder and ending. Throws std::runtime_error if it cannot
/// be read.
ReferenceProgram read_reference_program(const std::string& stem);

/// All of them, in order.
std::vector<std::string> reference_program_names();

}  // namespace wuerfel::test
