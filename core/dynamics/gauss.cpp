#include "core/dynamics/gauss.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace wuerfel {

namespace {

/// A former answer is taken if its residual is below this share of the tolerance: what a new solve
/// would reach as well.
constexpr double certificate_share = 1e-2;

/// Shares of g: rest is certified below the first; what is above the second is no rounding.
constexpr double rest_acceleration = 1e-10;
constexpr double certain_fall = 9e-10;
/// A cube may be left with this many times what the residual leaves of the largest force.
constexpr double left_over_times = 2.0;

/// What a guess of the pressing contacts must reach to be taken, up to how many cubes one is worth
/// its linear algebra, and the longest pause, in solves, after guesses that failed.
constexpr double guess_tolerance = 1e-11;
constexpr std::size_t most_guessed_cubes = 64;
constexpr int longest_pause = 64;

/// Programs of so many cubes are solved exactly.
constexpr std::size_t few_displaced_cubes = 24;
constexpr std::size_t few_struck_cubes = 64;

/// Small programs whose residual is above this are finished off as well: it costs next to nothing.
constexpr double finished_residual = 1e-13;
constexpr int small_program = 24;

/// Contacts press with more than this share of the largest force.
constexpr double pressing_share = 1e-9;

/// Row times x less its bound.
double slack(const QuadraticProgram& program, std::size_t row, const std::vector<double>& x) {
  double sum = -program.bound[row];
  for (int e = program.row_start[row]; e < program.row_start[row + 1]; ++e) {
    const auto block = static_cast<std::size_t>(program.entry_block[e]);
    const std::span<const double> g = program.entry(e);
    for (std::size_t k = 0; k < g.size(); ++k)
      sum += g[k] * x[block * g.size() + k];
  }
  return sum;
}

void end_without_answer(const QpSolver& solver, QpStatus status) {
  if (status == QpStatus::unavailable || status == QpStatus::invalid)
    throw SolverError(std::string(solver.trouble()));
}

}  // namespace

double IslandSolution::largest_force() const {
  return forces.empty() ? 0.0 : std::ranges::max(forces);
}

double IslandSolution::least_pressing() const { return pressing_share * largest_force(); }

IslandDynamics::IslandDynamics(const System& system,
                               const MotionSettings& settings,
                               const ProgramTolerances& tolerances)
    : system_(&system), settings_(settings), builder_(system, settings.formulation) {
  impacts_ = {few_struck_cubes, tolerances.impact, {}};
  corrections_ = {few_displaced_cubes, tolerances.correction, {}};
  placements_ = {few_displaced_cubes, tolerances.placement, {}};
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

/// Contacts that pressed last time press again, mostly.
bool IslandDynamics::guess(const Island& island, Memory& memory) {
  if (!settings_.skips.warm_start || settings_.solver != QpMethod::automatic
      || island.cubes.size() > most_guessed_cubes || settings_.formulation != Formulation::rigid
      || memory.pressing.empty())
    return false;
  const int pause = std::min((1 << std::min(memory.failed_guesses, 16)) - 1, longest_pause);
  if (memory.since_guess++ < pause) return false;
  memory.since_guess = 0;
  guess_from(island, memory);
  const bool right = guess_.solve(builder_.program(), guess_tolerance, tight_, memory.result);
  memory.failed_guesses = right ? 0 : memory.failed_guesses + 1;
  return right;
}

void IslandDynamics::guess_from(const Island& island, const Memory& memory) {
  tight_.clear();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (use_[k] == SideUse::none) continue;
    tight_.push_back(std::ranges::binary_search(memory.pressing, island.contacts[k].id()) ? 1 : 0);
  }
}

/// Where a solver stops short of its goal it has nearly always found out which contacts press; with
/// them as equalities the rest is one linear system.
void IslandDynamics::finish_off(const Island& island, Memory& memory, double tolerance) {
  if (settings_.solver != QpMethod::automatic || settings_.formulation != Formulation::rigid)
    return;
  remember_pressing(island, memory);
  guess_from(island, memory);
  QpResult finished;
  if (guess_.solve(builder_.program(), tolerance, tight_, finished))
    memory.result = std::move(finished);
}

void IslandDynamics::remember_pressing(const Island& island, Memory& memory) const {
  memory.pressing.clear();
  if (static_cast<int>(memory.result.multiplier.size()) != builder_.program().rows()) return;
  auto row = static_cast<std::size_t>(builder_.first_contact_row());
  double largest = 0.0;
  for (const double force : memory.result.multiplier)
    largest = std::max(largest, force);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (use_[k] == SideUse::none) continue;
    if (memory.result.multiplier[row++] > pressing_share * largest)
      memory.pressing.push_back(island.contacts[k].id());
  }
  std::ranges::sort(memory.pressing);
}

IslandSolution IslandDynamics::solve(const State& state, const Island& island, Memories& memories) {
  const QuadraticProgram& program = builder_.program();
  // Ipopt remembers nothing but is expensive to make: one for all.
  Memory& memory =
      memories.of_island[settings_.solver == QpMethod::ipopt ? 0 : island.cubes.front()];
  const double tolerance =
      island.cubes.size() > memories.few_cubes ? memories.tolerance : QpSettings{}.tolerance;
  IslandSolution solution;
  solution.skipped = still_passes(memory, tolerance);
  if (!solution.skipped && !guess(island, memory)) {
    if (!memory.solver || memory.tolerance != tolerance) {
      memory.solver = make_qp_solver(settings_.solver, {.tolerance = tolerance});
      memory.tolerance = tolerance;
    }
    if (!settings_.skips.warm_start) memory.solver->forget();
    memory.solver->solve(program, memory.result);
    end_without_answer(*memory.solver, memory.result.status);
    const double reached = memory.result.residual.worst();
    if (memory.result.status == QpStatus::inaccurate) {
      finish_off(island, memory, tolerance);
    } else if (memory.result.status == QpStatus::optimal && reached > finished_residual
               && program.rows() <= small_program) {
      finish_off(island, memory, 0.1 * reached);
    }
  }
  if (!solution.skipped) remember_pressing(island, memory);
  const QpResult& result = memory.result;
  solution.status = result.status;
  solution.residual = result.residual.worst();
  solution.iterations = solution.skipped ? 0 : result.iterations;
  solution.forces.assign(island.contacts.size(), 0.0);
  solution.slacks.assign(island.contacts.size(), unbounded);
  if (static_cast<int>(result.x.size()) != program.unknowns()
      || !std::isfinite(solution.residual)) {
    // Without an answer nothing is pushed: the caller sees the status and counts it.
    solution.twists = builder_.twists(state, island, program.target);
    return solution;
  }
  solution.twists = builder_.twists(state, island, result.x);
  auto row = static_cast<std::size_t>(builder_.first_contact_row());
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (use_[k] == SideUse::none) continue;
    solution.forces[k] = result.multiplier[row];
    solution.slacks[k] = slack(program, row, result.x);
    ++row;
  }
  return solution;
}

IslandSolution IslandDynamics::accelerations(const State& state, const Island& island) {
  use_.clear();
  for (const Contact& contact : island.contacts) {
    const bool active = contact_motion(*system_, state, contact) != ContactMotion::opening;
    use_.push_back(active ? SideUse::inequality : SideUse::none);
  }
  builder_.acceleration(state, island, use_);
  return solve(state, island, accelerations_);
}

IslandSolution IslandDynamics::accelerations(const State& state,
                                             const Island& island,
                                             std::span<const SideUse> use) {
  use_.assign(use.begin(), use.end());
  builder_.acceleration(state, island, use_);
  return solve(state, island, accelerations_);
}

IslandSolution IslandDynamics::impact(const State& state, const Island& island) {
  use_.assign(island.contacts.size(), SideUse::inequality);
  builder_.velocity(state, island, use_);
  return solve(state, island, impacts_);
}

IslandSolution IslandDynamics::velocities(const State& state,
                                          const Island& island,
                                          std::span<const SideUse> use) {
  use_.assign(use.begin(), use.end());
  builder_.velocity(state, island, use_);
  return solve(state, island, velocities_);
}

IslandSolution IslandDynamics::correction(const State& state,
                                          const Island& island,
                                          std::span<const SideUse> use,
                                          std::span<const Twist> targets) {
  use_.assign(use.begin(), use.end());
  builder_.position(state, island, use_, targets);
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
    const Twist& a = solution.twists[k];
    const double size = a.linear.norm() + body.size.minCoeff() * std::abs(a.angular);
    const double rounding = rest_acceleration * gravity + left_over_times * left / body.mass;
    if (size > std::min(rounding, certain_fall * gravity)) return false;
  }
  return true;
}

}  // namespace wuerfel
