/// What EqualitySolver does with few tight rows of cubes: of all solves within smooth motions most are such.
#pragma once

#include <vector>

#include "core/qp/quadratic_program.h"

namespace wuerfel {

inline constexpr int few_rows = 8;
inline constexpr int cube_size = 3;  ///< of the blocks
/// Residuals are refined to this share of the bounds and of J f.
inline constexpr double refined_share = 4e-16;

/// x += M^-1 J' l, multiplier += l, until J x = b to rounding. `factor`: the whole triangle of S = J M^-1 J', row by row in the
/// `order` of the rows; `inverse`: of its diagonal, 0 for rows that depend on others.
void move_onto_few_rows(const QuadraticProgram& p,
                        const std::vector<int>& order,
                        const double* factor,
                        const double* inverse,
                        double* x,
                        double* multiplier);

}  // namespace wuerfel
