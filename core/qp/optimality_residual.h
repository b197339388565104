/// The scales in which the residual of a program is measured.
///
/// Coordinates of one block may have different units (metres and radians of a cube). They are made
/// alike by the square root of their masses, relative to the first coordinate of the block: an
/// angular acceleration counts times the radius of gyration sqrt(I/m), a torque divided by it.
#pragma once

#include <vector>

#include "core/qp/quadratic_program.h"

namespace wuerfel {

struct ResidualScales {
  double acceleration = 0.0;     ///< the largest |f| of a coordinate and |b| / |row|
  double weight = 0.0;           ///< the largest |M f|
  std::vector<double> row_norm;  ///< |row|: the acceleration of a unit of every coordinate, and the
                                 ///< force of a unit multiplier
};

/// Fills `scales`, whose memory is reused. A row of zeros gets the norm of the largest row (or 1).
void measure_scales(const QuadraticProgram& program, ResidualScales& scales);

}  // namespace wuerfel
