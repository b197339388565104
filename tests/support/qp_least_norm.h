/// Which of many optimal multipliers to show: those of least sum of squares, and which of them are
/// the only ones possible.
///
/// Dense and cubic in the number of tight rows: for small programs, and the oracle for what is
/// faster.
#pragma once

#include <span>
#include <vector>

#include "core/qp/methods/canonical_multipliers.h"

namespace wuerfel::test {

struct LeastNormSettings {
  double tight = 1e-9;  ///< a row is tight if its slack is at most this, relative as in QpResidual
  double rank = 1e-9;   ///< singular values below this part of the largest count as zero
};

/// Among all lambda with M (x - f) = J' lambda that are optimal at x (zero or at their bound on
/// rows that are not tight, within [force_min, force_max] on tight ones) the one of least sum
/// (weight_i lambda_i)^2. `weight` is empty (all 1) or has m entries
/// >= 0: the row's length gives forces along unit normals. Weight 0 leaves an equality out of the
/// sum (rods, when only contacts are to be balanced); then these take their own least sum of
/// squares afterwards.
LeastNormMultipliers least_norm_multipliers(const QuadraticProgram& program,
                                            const std::vector<double>& x,
                                            std::span<const double> weight = {},
                                            const LeastNormSettings& settings = {});

}  // namespace wuerfel::test
