#include "core/qp/coulomb/rest_program.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {

RestResult RestProgram::solve(const FrictionProgram& friction) {
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
  return result;
}

}  // namespace wuerfel
