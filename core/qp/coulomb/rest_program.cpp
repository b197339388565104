#include "core/qp/coulomb/rest_program.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/qp/coulomb/canonical_friction.h"
#include "core/qp/coulomb/coulomb_residual.h"

namespace wuerfel {
namespace {

/// Above this coefficient the rows J_n +- mu J_t of the convex program are so alike that normal parts
/// lose their digits: what can be held with less is asked first.
constexpr double strong_friction = 8.0;
constexpr double maybe_rest = 1e-6;  ///< of the largest |f|, what may be rounding
constexpr double exact_rest = 1e-12;

/// Of a light body under a load the convex program may not see that it rests: forces that balance it exactly show it.
bool balances(const FrictionProgram& friction, RestResult& rest) {
  if (rest.multiplier.empty() || rest.size > maybe_rest) return false;
  const std::vector<double> zero(friction.program.unknowns(), 0.0);
  CanonicalForces least = canonical_friction(friction, zero, rest.multiplier, false);
  if (coulomb_residual(friction, zero, least.multiplier).worst() > exact_rest) return false;
  rest.multiplier = std::move(least.multiplier);
  return true;
}

}  // namespace

/// Forces that balance with less friction balance with more, too, but where it is known to be used up.
RestResult RestProgram::solve(const FrictionProgram& friction) {
  const auto is_strong = [](const FrictionContact& c) {
    return c.slides == 0 && c.mu > strong_friction;
  };
  if (std::ranges::any_of(friction.contacts, is_strong)) {
    std::vector<FrictionContact> weaker(friction.contacts.begin(), friction.contacts.end());
    for (FrictionContact& c : weaker)
      if (is_strong(c)) c.mu = strong_friction;
    RestResult rest = solve_convex({friction.program, weaker});
    if (rest.equilibrium()) return rest;
  }
  return solve_convex(friction);
}

RestResult RestProgram::solve_convex(const FrictionProgram& friction) {
  program_ = friction.program;
  std::fill(program_.bound.begin(), program_.bound.end(), 0.0);
  RestResult result;
  result.status = convex_.solve({program_, friction.contacts});
  if (convex_.x().empty()) return result;
  result.acceleration = convex_.x();
  result.multiplier = convex_.multiplier();
  double largest = 0.0;
  double scale = 0.0;
  for (int j = 0; j < program_.unknowns(); ++j) {
    largest = std::max(largest, std::abs(result.acceleration[j]) * program_.unit(j));
    scale = std::max(scale, std::abs(program_.target[j]) * program_.unit(j));
  }
  result.size = scale > 0.0 ? largest / scale : 0.0;
  if (!result.equilibrium() && balances({program_, friction.contacts}, result)) {
    result.status = QpStatus::optimal;
    result.size = 0.0;
  }
  return result;
}

}  // namespace wuerfel
