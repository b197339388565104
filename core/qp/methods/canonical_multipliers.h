/// The multipliers to show, for programs of any size: of all optimal ones those of least sum of
/// squares, and which of them are the only ones possible.
///
/// Values: LeastNormMethod on the rows that may carry force. Flags: a row has one possible multiplier
/// if it is at the same bound in all of them, or has no part in any vector v with G' v = 0 on the
/// others. The latter is seen from projections of two arbitrary vectors onto that space.
#pragma once

#include <vector>

#include "core/qp/quadratic_program.h"

namespace wuerfel {

struct LeastNormMultipliers {
  std::vector<double> multiplier;  ///< m
  std::vector<bool> unique;        ///< m: whether no other optimal multiplier of this row exists
  double misfit = 0.0;             ///< ResidualMeter::imbalance of these very multipliers
};

/// From a solution, x and multipliers. Rows of the program count with their own length: write them
/// with unit normals. Where the least norm cannot be found as exactly as the multipliers given
/// balance x, these are returned. `with_unique` false leaves the flags false and saves half of the
/// time.
LeastNormMultipliers canonical_multipliers(const QuadraticProgram& program,
                                           const std::vector<double>& x,
                                           const std::vector<double>& multiplier,
                                           bool with_unique);

}  // namespace wuerfel
