/// Of all forces that Coulomb's law allows at a given motion those nearest to a wish: see canonical_friction.h.
#pragma once

#include <vector>

#include "core/qp/coulomb/contact_form.h"

namespace wuerfel {

/// `wide`: one without edges.
enum class Cone : signed char { nothing, free, half_line, edge, cone, wide };

/// The forces that are sought: in cones, and with G' l = s.
struct ForceProblem {
  ContactForm form;
  std::vector<Cone> cone;
  std::vector<double> slip;  ///< sign of u_t of units that slip
  std::vector<Quad> s;
  double rho = 0.0;
};

/// That of a solution (x, multipliers) of residual about 1e-10. Forces are to balance as its own do, and those of rest (x = 0) exactly.
ForceProblem problem_of(const FrictionProgram& friction,
                        const std::vector<double>& x,
                        const std::vector<double>& multiplier);

/// Misfits up to this are rounding.
inline constexpr double good_balance = 1e-8;

struct NearestForces {
  std::vector<Pair> l;
  double misfit = unbounded;  ///< of G' l = s
};

NearestForces nearest(ForceProblem& p, const std::vector<Pair>& wish);

}  // namespace wuerfel
