#include "core/qp/methods/method_outcome.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {

double size_of(const LeastDistance& problem) {
  double size = 0.0;
  for (std::size_t i = 0; i < problem.h().size(); ++i) {
    if (problem.square()[i] > 0.0 && (problem.h()[i] > 0.0 || problem.force_min()[i] < 0.0))
      size = std::max(size, std::abs(problem.h()[i]) / std::sqrt(problem.square()[i]));
  }
  return size;
}

double worst_row(const LeastDistance& problem,
                 const ResidualScales& scales,
                 const std::vector<double>& rest,
                 const std::vector<double>& lambda) {
  const std::size_t rows = lambda.size();
  const double force = scales.largest_force(lambda);
  const double per_force = force > 0.0 ? 1.0 / force : 0.0;
  const double per_acceleration = scales.acceleration > 0.0 ? 1.0 / scales.acceleration : 0.0;
  double worst = 0.0;
  double nothing = 0.0;  // not a number as soon as something else is not
  for (std::size_t i = 0; i < rows; ++i) {
    const double zero = (rest[i] + lambda[i]) * 0.0;
    nothing += zero;
    const double slack = -rest[i];
    const double distance =
        slack > 0.0 ? lambda[i] - problem.force_min()[i] : problem.force_max()[i] - lambda[i];
    if (distance == 0.0) continue;
    const double gap = std::abs(slack) / scales.row_norm[i] * per_acceleration;
    worst = std::max(worst, std::min(gap, distance * scales.row_norm[i] * per_force));
  }
  return nothing == 0.0 ? worst : unbounded;
}

bool proves_infeasible(const LeastDistance& problem,
                       const ResidualScales& scales,
                       double tolerance,
                       const std::vector<double>& direction,
                       std::vector<double>& v,
                       std::vector<Quad>& scratch) {
  constexpr double beyond = 1e7;
  const double allowed = tolerance * scales.acceleration;
  v = direction;
  double gain = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (problem.force_max()[i] != unbounded) v[i] = std::min(v[i], 0.0);
    if (problem.force_min()[i] != -unbounded) v[i] = std::max(v[i], 0.0);
    if (problem.square()[i] == 0.0) v[i] = 0.0;  // true or false by itself, which is known
    gain += v[i] * problem.h()[i] - std::abs(v[i]) * scales.row_norm[i] * allowed;
  }
  problem.apply_transposed(v.data(), scratch.data());
  double square = 0.0;
  for (const Quad& q : scratch)
    square += q.v[0] * q.v[0] + q.v[1] * q.v[1] + q.v[2] * q.v[2];
  return gain > 0.0 && std::sqrt(square) * beyond * size_of(problem) < gain;
}

}  // namespace wuerfel
