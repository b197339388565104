#include "core/qp/coulomb/restitution.h"

#include <algorithm>
#include <utility>

namespace wuerfel {
namespace {

constexpr int steps = 1 << 20;            ///< of the factor
constexpr int coarse_steps = steps / 64;  ///< where the law has no solution beyond: none costs most
constexpr double energy_noise = 1e-13;    ///< share of the energy that is rounding

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
  CoulombResult found;
  bool solved = false;
  // The solution is kept: asked again it could be another one.
  const auto allowed = [&](int step) {
    const double factor = static_cast<double>(step) / steps;
    for (std::size_t i = 0; i < friction.contacts.size(); ++i) {
      const int row = friction.contacts[i].normal;
      const double bounce = restitution[i] * std::max(-normal_velocity[i], 0.0);
      program.bound[row] = friction.program.bound[row] + factor * bounce;
    }
    solver.solve({program, friction.contacts, friction.force_unit}, found, keys);
    solved = found.status == QpStatus::optimal;
    const bool passed = solved && energy(program, found.x) <= before * (1.0 + energy_noise);
    if (passed || step == 0) {
      std::swap(result.solution, found);
      result.factor = factor;
    }
    return passed;
  };
  if (allowed(steps)) return;
  int low = 0;
  int high = steps;
  int nearest = solved ? 1 : coarse_steps;
  while (high - low > nearest) {
    const int middle = low + (high - low) / 2;
    const bool passed = allowed(middle);
    if (!passed) nearest = solved ? 1 : coarse_steps;
    (passed ? low : high) = middle;
  }
  if (low == 0) (void)allowed(0);
}

}  // namespace wuerfel
