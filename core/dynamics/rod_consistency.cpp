#include "core/dynamics/rod_consistency.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/programs.h"
#include "core/dynamics/rod_rows.h"
#include "core/qp/methods/equality_solver.h"

namespace wuerfel {
namespace {

/// Rows contradict each other that are missed by more than this share of the largest acceleration.
constexpr double missed_share = 1e-6;

/// Whether accelerations exist that keep the rods of an island.
bool fit(const System& system, const State& state, const Island& island) {
  ProgramBuilder builder(system, Formulation::rigid);
  builder.acceleration(state, island, {});
  const QuadraticProgram& program = builder.program();
  EqualitySolver solver;
  std::vector<double> x;
  std::vector<double> multiplier;
  solver.factorise(program);
  if (solver.dependent_rows() == 0) return true;
  solver.solve(program, x, multiplier);
  double scale = system.gravity.norm();
  for (int row = 0; row < program.rows(); ++row)
    scale = std::max(scale, std::abs(program.bound[row]));
  for (int row = 0; row < program.rows(); ++row)
    if (std::abs(program.slack(row, x)) > missed_share * scale) return false;
  return true;
}

/// Takes rods out as long as the others still contradict each other.
void reduce(const System& system, const State& state, Island& island) {
  for (std::size_t k = 0; k < island.rods.size();) {
    Island without = island;
    without.rods.erase(without.rods.begin() + static_cast<std::ptrdiff_t>(k));
    if (fit(system, state, without)) {
      ++k;
    } else {
      island = std::move(without);
    }
  }
}

std::vector<std::string> names_of(const System& system, const Island& island) {
  std::vector<std::string> names;
  for (const int rod : island.rods) {
    const std::string& name = system.rods[rod].name;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace

std::vector<std::string> contradicting_rods(const System& system, const State& state) {
  if (system.rods.empty()) return {};
  std::vector<Island> islands;
  find_islands(system, {}, islands);
  for (Island& island : islands) {
    if (fit(system, state, island)) continue;
    reduce(system, state, island);
    return names_of(system, island);
  }
  return {};
}

}  // namespace wuerfel
