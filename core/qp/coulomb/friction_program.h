/// Coulomb's law in the plane, exactly, on programs of velocities, displacements or accelerations.
///
///     M (x - f) = J' lambda,
///     0 <= lambda_n  perp  u_n = J_n x - b_n >= 0,
///     |lambda_t| <= mu lambda_n,   lambda_t = -mu lambda_n sign(u_t)  where  u_t = J_t x - b_t != 0
///
/// for every contact, beside equalities (rods) and inequalities without friction. A solution exists
/// for every mu where x = f + .. can satisfy J_n x >= b_n, J_t x = b_t (at rest: x = 0)
/// [Anitescu, Potra 1997]. It need not be unique, nor is it the minimum of anything. Nothing here
/// knows of cubes.
#pragma once

#include <vector>

#include "core/qp/quadratic_program.h"

namespace wuerfel {

struct FrictionContact {
  int normal = -1;   ///< row of the program, an inequality
  int tangent = -1;  ///< row of the program, its range is not looked at; -1 only where mu = 0
  double mu = 0.0;   ///< >= 0; where it is 0 the tangential multiplier is 0
  /// The direction of slip where it is known, the sign of u_t, so that lambda_t = -mu lambda_n
  /// slides whatever u_t is; 0: free to stick or to slip either way.
  int slides = 0;
};

/// Rows that belong to no contact are equalities or inequalities.
struct FrictionProgram {
  const QuadraticProgram& program;
  std::vector<FrictionContact> contacts;
  /// What forces that hold the same weights grow as from one program to the next, for solvers that remember: h of velocities
  /// and h^2 of displacements in steps of h; 0: as the largest weight does, which what moves changes.
  double force_unit = 0.0;
  /// An answer is asked for only where Newton's method finds it from that of the program before.
  bool refines = false;
};

}  // namespace wuerfel
