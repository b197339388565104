#include "core/dynamics/gauss.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/dynamics/missed_programs.h"
#include "core/dynamics/verdict.h"
#include "core/model/scales.h"

namespace wuerfel {

namespace {

/// A former answer is taken if its residual is below this share of the tolerance: what a new solve
/// would reach as well.
constexpr double certificate_share = 1e-2;

/// What is above this share of g is no rounding: less than what counts as falling.
constexpr double certain_fall = 0.9 * falls_above;
/// A cube may be left with this many times what the residual leaves of the largest force.
constexpr double left_over_times = 2.0;

/// Impacts of so many cubes are solved exactly.
constexpr std::size_t few_struck_cubes = 64;

}  // namespace

double IslandSolution::largest_force() const {
  double largest = forces.empty() ? 0.0 : std::ranges::max(forces);
  for (const double force : rods)
    largest = std::max(largest, std::abs(force));
  return largest;
}

double IslandSolution::least_pressing() const { return pressing_share * largest_force(); }

IslandSolution read_solution(const ProgramBuilder& builder,
                             const State& state,
                             const Island& island,
                             const std::vector<double>& x,
                             const std::vector<double>& multiplier) {
  IslandSolution solution;
  solution.forces.assign(island.contacts.size(), 0.0);
  solution.slacks.assign(island.contacts.size(), unbounded);
  solution.rods.assign(island.rods.size(), 0.0);
  const QuadraticProgram& program = builder.program();
  const bool known = static_cast<int>(x.size()) == program.unknowns();
  solution.twists = builder.twists(state, island, known ? x : program.target);
  if (!known) return solution;
  std::copy_n(multiplier.begin() + builder.first_rod_row(), solution.rods.size(),
              solution.rods.begin());
  int row = builder.first_contact_row();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (builder.use()[k] == SideUse::none) continue;
    solution.forces[k] = multiplier[row];
    solution.slacks[k] = program.slack(row, x);
    ++row;
  }
  return solution;
}

Vec2 impulse_at(const Contact& c, const IslandSolution& solution, std::size_t k) {
  const double side = solution.tangential.empty() ? 0.0 : solution.tangential[k];
  return solution.forces[k] * c.normal + side * perp(c.normal);
}

IslandDynamics::IslandDynamics(const System& system,
                               const MotionSettings& settings,
                               const ProgramTolerances& tolerances)
    : system_(&system),
      settings_(settings),
      builder_(system, settings.formulation),
      impacts_{few_struck_cubes, {tolerances.impact}, {}},
      corrections_{few_displaced_cubes, {tolerances.correction}, {}},
      placements_{few_displaced_cubes, {tolerances.placement}, {}} {
  accelerations_.settings.by_block = true;
}

bool IslandDynamics::still_passes(Memory& memory, double tolerance) const {
  const QuadraticProgram& program = builder_.program();
  QpResult& former = memory.result;
  if (!settings_.skips.certificate || former.status != QpStatus::optimal) return false;
  if (static_cast<int>(former.x.size()) != program.unknowns()) return false;
  if (static_cast<int>(former.multiplier.size()) != program.rows()) return false;
  const QpResidual residual = optimality_residual(program, former.x, former.multiplier);
  if (residual.worst() > certificate_share * tolerance) return false;
  former.residual = residual;
  return true;
}

void IslandDynamics::solve_anew(const QpSettings& settings, Memory& memory) {
  if (!memory.solver || memory.tolerance != settings.tolerance) {
    memory.solver = make_qp_solver(settings_.solver, settings);
    memory.tolerance = settings.tolerance;
  }
  if (!settings_.skips.warm_start) memory.solver->forget();
  memory.solver->solve(builder_.program(), memory.result);
  const QpStatus status = memory.result.status;
  if (status == QpStatus::unavailable || status == QpStatus::invalid)
    throw SolverError(std::string(memory.solver->trouble()));
}

IslandSolution IslandDynamics::solve(const State& state, const Island& island, Memories& memories) {
  // Ipopt remembers nothing but is expensive to make: one for all.
  Memory& memory =
      memories.of_island[settings_.solver == QpMethod::ipopt ? 0 : island.cubes.front()];
  QpSettings settings = memories.settings;
  if (island.cubes.size() <= memories.few_cubes) settings.tolerance = QpSettings{}.tolerance;
  const bool skipped = still_passes(memory, settings.tolerance);
  if (!skipped) solve_anew(settings, memory);
  const QpResult& result = memory.result;
  if (result.status != QpStatus::optimal && result.status != QpStatus::infeasible)
    MissedProgramListener::tell({builder_.program(), {}});
  // Without an answer nothing is pushed: the caller sees the status and counts it.
  const std::vector<double> none;
  const double residual = result.residual.worst();
  IslandSolution solution = read_solution(
      builder_, state, island, std::isfinite(residual) ? result.x : none, result.multiplier);
  solution.status = result.status;
  solution.residual = residual;
  solution.skipped = skipped;
  solution.iterations = skipped ? 0 : result.iterations;
  return solution;
}

IslandSolution IslandDynamics::accelerations(const State& state, const Island& island) {
  std::vector<SideUse> use;
  for (const Contact& contact : island.contacts) {
    const bool active = contact_motion(*system_, state, contact) != ContactMotion::opening;
    use.push_back(active ? SideUse::inequality : SideUse::none);
  }
  return accelerations(state, island, use);
}

IslandSolution IslandDynamics::accelerations(const State& state,
                                             const Island& island,
                                             std::span<const SideUse> use) {
  builder_.acceleration(state, island, use);
  return solve(state, island, accelerations_);
}

IslandSolution IslandDynamics::impact(const State& state, const Island& island) {
  builder_.velocity(state, island);
  return solve(state, island, impacts_);
}

IslandSolution IslandDynamics::velocities(const State& state,
                                          const Island& island,
                                          std::span<const SideUse> use) {
  builder_.velocity(state, island, use);
  return solve(state, island, velocities_);
}

IslandSolution IslandDynamics::correction(const State& state,
                                          const Island& island,
                                          std::span<const SideUse> use,
                                          std::span<const Twist> targets) {
  builder_.position(state, island, use, targets);
  return solve(state, island, targets.empty() ? corrections_ : placements_);
}

void set_velocities(const Island& island, const std::vector<Twist>& velocities, State& state) {
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    BodyState& s = state[island.cubes[k]];
    s.velocity = velocities[k].linear;
    s.spin = velocities[k].angular;
  }
}

void displace(const Island& island, const std::vector<Twist>& displacements, State& state) {
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    BodyState& s = state[island.cubes[k]];
    s.position += displacements[k].linear;
    s.angle += displacements[k].angular;
  }
}

bool accelerations_vanish(const System& system,
                          const Island& island,
                          const IslandSolution& solution,
                          double gravity) {
  if (solution.status != QpStatus::optimal) return false;
  const double left = solution.residual * solution.largest_force();
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    const Body& body = system.body(island.cubes[k]);
    const double size = size_of(body, solution.twists[k]);
    const double rounding = stands_below * gravity + left_over_times * left / body.mass;
    if (size > std::min(rounding, certain_fall * gravity)) return false;
  }
  return true;
}

}  // namespace wuerfel
