/// The judge of Coulomb's law: reads nothing but the program, the point and the multipliers.
#pragma once

#include <vector>

#include "core/qp/coulomb/friction_program.h"

namespace wuerfel {

/// All relative as QpResidual is: forces to the largest force, velocities to the largest velocity
/// of the data, rows by their norm with the coordinates of a block made alike by the roots of their
/// masses. Complementarity is a smaller-of, not a product.
struct CoulombResidual {
  double stationarity = 0.0;  ///< |M (x - f) - J' lambda|
  double rows = 0.0;          ///< what equalities and inequalities of no contact miss
  double normal = 0.0;        ///< |min(lambda_n, u_n)|
  double cone = 0.0;          ///< |lambda_t| - mu lambda_n
  double slip = 0.0;          ///< min(|u_t|, |mu lambda_n + sign(u_t) lambda_t|)
  [[nodiscard]] double worst() const;
};

/// What residuals are relative to.
struct CoulombScales {
  double velocity = 0.0;         ///< the largest |f| of a coordinate and |b| / |row|
  double weight = 0.0;           ///< the largest |M f|
  std::vector<double> row_norm;  ///< |row|; see replace_zero_norms
};

/// Velocities of a solution up to this share of the largest are zero: neither slip nor opening.
inline constexpr double still_share = 1e-9;

/// Keeps its memory between measurements.
class CoulombJudge {
 public:
  /// Scales of a sound program; valid until the next call.
  const CoulombScales& measure_scales(const QuadraticProgram& program);
  /// The residual under the scales measured last, which must be those of `program`. Infinite where
  /// a number is not one.
  CoulombResidual measure(const FrictionProgram& friction,
                          const std::vector<double>& x,
                          const std::vector<double>& multiplier);

 private:
  /// Force and velocity of a row, relative to the scales, with their signs.
  struct Relative {
    double force, velocity;
  };
  static double complementarity(const Relative& r);
  double apply_rows(const QuadraticProgram& program,
                    const std::vector<double>& x,
                    const std::vector<double>& multiplier);
  [[nodiscard]] Relative relative_row(int row, double multiplier) const;
  void add_contact(const FrictionContact& contact,
                   const std::vector<double>& multiplier,
                   CoulombResidual& residual) const;
  void find_units(const QuadraticProgram& program);

  CoulombScales scales_;
  std::vector<double> mass_;    ///< that the units are of
  std::vector<double> unit_;    ///< sqrt(M_first / M) of a coordinate: makes it one of the first
  std::vector<double> square_;  ///< of the units
  double largest_force_ = 0.0;
  std::vector<double> force_;  ///< M (x - f) - J' lambda
  std::vector<double> slack_;  ///< J x - b
  std::vector<char> of_contact_;
};

/// `x` of size n, `multiplier` of size m.
CoulombResidual coulomb_residual(const FrictionProgram& friction,
                                 const std::vector<double>& x,
                                 const std::vector<double>& multiplier);

}  // namespace wuerfel
