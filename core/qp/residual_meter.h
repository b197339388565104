/// The independent judge of answers: reads nothing but the program, the point and the multipliers.
///
/// Coordinates of one block may have different units (metres and radians of a cube). They are made
/// alike by the square root of their masses, relative to the first coordinate of the block: an
/// angular acceleration counts times the radius of gyration sqrt(I/m), a torque divided by it. The
/// norm of a row is taken in these units, so that it turns a slack into an acceleration and a
/// multiplier into a force.
#pragma once

#include <vector>

#include "core/qp/qp_solver.h"
#include "core/qp/quadratic_program.h"

namespace wuerfel {

struct ResidualScales {
  double acceleration = 0.0;     ///< the largest |f| of a coordinate and |b| / |row|
  double weight = 0.0;           ///< the largest |M f|
  std::vector<double> row_norm;  ///< |row|; see replace_zero_norms

  /// The largest of multipliers as forces, at least `weight`.
  [[nodiscard]] double largest_force(const std::vector<double>& multiplier) const;
};

/// Rows of zeros count as long as the normal of a contact, 1, or as the smallest other row: the
/// strictest judge of a bound that no point moves.
void replace_zero_norms(std::vector<double>& norms);

/// sum_j J_j^2 weight_j over a row's coefficients.
double square_of(const QuadraticProgram& program, int row, const std::vector<double>& weight);

/// Answers whose residual is below it are worth moving onto the rows that carry force.
inline constexpr double worth_settling = 1e-4;
/// An error up to here is rounding: work on it gains nothing.
inline constexpr double exact_residual = 1e-13;
/// A row carries force if it is more than this share of the largest, of all or on its bodies: solvers
/// may leave less on rows that carry none.
inline constexpr double loaded_share = 1e-9;

/// Keeps its memory between measurements.
class ResidualMeter {
 public:
  /// The scales of a sound program; valid until the next call.
  const ResidualScales& measure_scales(const QuadraticProgram& program);

  /// Those of the last call.
  [[nodiscard]] const ResidualScales& scales() const { return scales_; }

  /// The residual under the scales measured last, which must be those of `program`. Infinite where
  /// a number is not one.
  QpResidual measure(const QuadraticProgram& program,
                     const std::vector<double>& x,
                     const std::vector<double>& multiplier);

  /// Block by block: the worst |M (x - f) - J' lambda| in parts of the largest force on that block, its
  /// weight M f or a multiplier times its row, but at least of a millionth of all weights. Under the
  /// scales measured last.
  double imbalance(const QuadraticProgram& program,
                   const std::vector<double>& x,
                   const std::vector<double>& multiplier);
  /// The smaller of the largest forces on the blocks of a row, as the last `imbalance` found them.
  [[nodiscard]] double row_scale(const QuadraticProgram& program, int row) const;

 private:
  void find_units(const QuadraticProgram& program);
  double unbalanced_force(const QuadraticProgram& program,
                          const std::vector<double>& x,
                          const std::vector<double>& multiplier);

  ResidualScales scales_;
  // Of the masses seen last.
  std::vector<double> mass_;
  int block_size_ = 0;
  std::vector<double> root_;    ///< sqrt(M / M_first) per coordinate
  std::vector<double> unit_;    ///< 1 / root
  std::vector<double> weight_;  ///< 1 / root^2
  std::vector<double> force_;   ///< M (x - f) - J' lambda
  std::vector<double> slack_;   ///< J x - b
  std::vector<double> scale_;   ///< the largest force per block
};

}  // namespace wuerfel
