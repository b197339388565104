#include "core/qp/coulomb/restitution.h"

#include <algorithm>

namespace wuerfel {
namespace {

constexpr int steps = 1 << 20;          ///< of the factor
constexpr double energy_noise = 1e-13;  ///< share of the energy that is rounding

double energy(const QuadraticProgram& p, const std::vector<double>& x) {
  double sum = 0.0;
  for (int j = 0; j < p.unknowns(); ++j)
    sum += 0.5 * p.mass[j] * x[j] * x[j];
  return sum;
}

}  // namespace

void impact_with_restitution(CoulombSolver& solver,
                             const FrictionProgram& friction,
                             std::span<const double> restitution,
                             std::span<const double> normal_velocity,
                             ImpactResult& result,
                             std::span<const std::uint64_t> keys) {
  QuadraticProgram program = friction.program;
  const double before = energy(program, program.target);
  const auto allowed = [&](int step) {
    const double factor = static_cast<double>(step) / steps;
    for (std::size_t i = 0; i < friction.contacts.size(); ++i) {
      const int row = friction.contacts[i].normal;
      const double bounce = restitution[i] * std::max(-normal_velocity[i], 0.0);
      program.bound[row] = friction.program.bound[row] + factor * bounce;
    }
    solver.solve({program, friction.contacts}, result.solution, keys);
    result.factor = factor;
    return result.solution.status == QpStatus::optimal
           && energy(program, result.solution.x) <= before * (1.0 + energy_noise);
  };
  if (allowed(steps)) return;
  int low = 0;
  int high = steps;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (allowed(middle) ? low : high) = middle;
  }
  if (low != 0 || result.factor != 0.0) (void)allowed(low);
}

}  // namespace wuerfel
