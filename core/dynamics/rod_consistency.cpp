#include "core/dynamics/rod_consistency.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/programs.h"
#include "core/dynamics/rod_rows.h"
#include "core/model/scales.h"
#include "core/qp/methods/equality_solver.h"

namespace wuerfel {
namespace {

/// Rows contradict each other that are missed by more than this share of the largest acceleration.
constexpr double missed_share = 1e-6;
constexpr double surely_missed_share = 1e-4;

enum class Fit { independent, redundant, contradicting };

/// Whether accelerations exist that keep the rods of an island without contacts.
Fit fit(const System& system, const State& state, const Island& island) {
  ProgramBuilder builder(system, Formulation::rigid);
  builder.acceleration(state, island);
  const QuadraticProgram& program = builder.program();
  EqualitySolver solver;
  std::vector<double> x;
  std::vector<double> multiplier;
  solver.factorise(program);
  if (solver.dependent_rows() == 0) return Fit::independent;
  solver.solve(program, x, multiplier);
  double scale = system.gravity.norm();
  for (int row = 0; row < program.rows(); ++row)
    scale = std::max(scale, std::abs(program.bound[row]));
  for (int row = 0; row < program.rows(); ++row)
    if (std::abs(program.slack(row, x)) > missed_share * scale) return Fit::contradicting;
  return Fit::redundant;
}

/// Takes rods out as long as the others still contradict each other.
void reduce(const System& system, const State& state, Island& island) {
  for (std::size_t k = 0; k < island.rods.size();) {
    Island without = island;
    without.rods.erase(without.rods.begin() + static_cast<std::ptrdiff_t>(k));
    if (fit(system, state, without) == Fit::contradicting) {
      island = std::move(without);
    } else {
      ++k;
    }
  }
}

}  // namespace

std::vector<std::string> rod_names(const System& system, std::span<const int> rods) {
  std::vector<std::string> names;
  for (const int rod : rods) {
    const std::string& name = system.rods[rod].name;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

bool misses_rods(const System& system, const State& state, const State& accelerated) {
  double scale = system.gravity.norm();
  double worst = 0.0;
  for (const Rod& rod : system.rods) {
    const double c = rod_row(rod, state, Order::acceleration).c;
    scale = std::max(scale, std::abs(c));
    worst = std::max(worst, std::abs(rod_change(rod, state, accelerated) + c));
  }
  return worst > surely_missed_share * scale;
}

RodConsistency rods_of_island(const System& system, const State& state, const Island& island) {
  Island rods{island.cubes, {}, {}, island.rods};
  const Fit fits = fit(system, state, rods);
  if (fits != Fit::contradicting) return {{}, fits == Fit::redundant};
  reduce(system, state, rods);
  return {rods.rods, true};
}

RodConsistency rod_consistency(const System& system, const State& state) {
  RodConsistency found;
  if (system.rods.empty()) return found;
  for (const Island& island : find_islands(system, {})) {
    const RodConsistency rods = rods_of_island(system, state, island);
    found.redundant = found.redundant || rods.redundant;
    found.contradicting = rods.contradicting;
    if (!found.contradicting.empty()) break;
  }
  return found;
}

RodConsistency rod_consistency_of_start(const System& system,
                                        const State& state,
                                        std::span<const Twist> accelerations) {
  State later = state;
  const double time = scales_of(system, state).time;
  const auto rests = [&](int cube) { return is_still(state[cube]); };
  for (const Island& island : find_islands(system, {})) {
    if (!std::ranges::all_of(island.cubes, rests)) continue;
    for (const int cube : island.cubes) {
      later[cube].velocity = time * accelerations[cube].linear;
      later[cube].spin = time * accelerations[cube].angular;
    }
  }
  return rod_consistency(system, later);
}

}  // namespace wuerfel
