#include "core/dynamics/friction.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/dynamics/missed_programs.h"
#include "core/qp/coulomb/held_blocks.h"
#include "core/qp/coulomb/restitution.h"

namespace wuerfel {
namespace {

/// A name for every contact of an island that is in the program over it.
std::vector<std::uint64_t> keys_of(const ProgramBuilder& builder, const Island& island) {
  std::vector<std::uint64_t> keys;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (builder.use()[k] != SideUse::none)
      keys.push_back(static_cast<std::uint64_t>(island.contacts[k].id()));
  }
  return keys;
}

/// Of what moves, how far accelerations go on before a jam.
constexpr double push_share = 1e-6;

/// |f|_M, the root of twice the energy of a program's target.
double size_of_target(const QuadraticProgram& program) {
  double square = 0.0;
  for (int k = 0; k < program.unknowns(); ++k)
    square += program.mass[k] * program.target[k] * program.target[k];
  return std::sqrt(square);
}

}  // namespace

bool rubs(const System& system, const Island& island) {
  return system.rubs && std::ranges::any_of(island.contacts, [&](const Contact& c) {
           return system.surface(c.on, c.from).friction > 0.0;
         });
}

bool bounces(const System& system, const Island& island) {
  return system.bounces && std::ranges::any_of(island.contacts, [&](const Contact& c) {
           return system.surface(c.on, c.from).restitution > 0.0;
         });
}

bool is_placed_once(const Island& island) {
  return island.rods.empty() && island.cubes.size() > few_displaced_cubes;
}

FrictionDynamics::FrictionDynamics(const System& system, const MotionSettings& settings)
    : system_(&system), settings_(settings), builder_(system, settings.formulation) {}

CoulombSolver& FrictionDynamics::solver_of(const Island& island, Solvers& solvers) const {
  std::unique_ptr<CoulombSolver>& solver = solvers[island.cubes.front()];
  if (!solver) solver = std::make_unique<CoulombSolver>();
  if (!settings_.skips.warm_start) solver->forget();
  return *solver;
}

IslandSolution read_with_friction(const ProgramBuilder& builder,
                                  const State& state,
                                  const Island& island,
                                  const std::vector<double>& x,
                                  const std::vector<double>& multiplier) {
  IslandSolution solution = read_solution(builder, state, island, x, multiplier);
  solution.tangential.assign(island.contacts.size(), 0.0);
  solution.slips.assign(island.contacts.size(), 0.0);
  if (static_cast<int>(x.size()) != builder.program().unknowns()) return solution;
  const FrictionProgram friction = builder.friction_program();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const int n = builder.friction_contact()[k];
    if (n < 0 || friction.contacts[n].tangent < 0) continue;
    const int tangent = friction.contacts[n].tangent;
    solution.slips[k] = friction.program.slack(tangent, x);
    solution.tangential[k] = multiplier[tangent];
  }
  return solution;
}

IslandSolution read_with_friction(const ProgramBuilder& builder,
                                  const State& state,
                                  const Island& island,
                                  const CoulombResult& result) {
  IslandSolution solution = read_with_friction(builder, state, island, result.x, result.multiplier);
  solution.status = result.status;
  solution.residual = result.residual.worst();
  solution.friction_inexact = result.inexact();
  solution.iterations = result.factorisations;
  return solution;
}

/// No force leaves its cone by rounding.
IslandSolution FrictionDynamics::read(const State& state,
                                      const Island& island,
                                      const CoulombResult& result) const {
  IslandSolution solution = read_with_friction(builder_, state, island, result);
  const FrictionProgram friction = builder_.friction_program();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const int n = builder_.friction_contact()[k];
    if (n < 0) continue;
    solution.forces[k] = std::max(0.0, solution.forces[k]);
    const double most = friction.contacts[n].mu * solution.forces[k];
    solution.tangential[k] = std::clamp(solution.tangential[k], -most, most);
  }
  return solution;
}

IslandSolution FrictionDynamics::accelerations(const State& state,
                                               const Island& island,
                                               std::span<const SideUse> use,
                                               std::span<const int> slides) {
  builder_.acceleration(state, island, use);
  builder_.add_friction(state, island, slides);
  CoulombResult result;
  solver_of(island, accelerations_)
      .solve(builder_.friction_program(), result, keys_of(builder_, island));
  let_stand(builder_.friction_program(), builder_.still_blocks(state, island), result);
  IslandSolution solution = read(state, island, result);
  keep_if_missed(solution);
  return solution;
}

IslandSolution FrictionDynamics::impact(const State& state, const Island& island, double slow) {
  builder_.velocity(state, island);
  builder_.add_friction(state, island);
  std::vector<double> restitution;
  std::vector<double> closing;
  for (const Contact& c : island.contacts) {
    const double rate = gap_rate(c, contact_velocity(*system_, state, c));
    closing.push_back(rate);
    restitution.push_back(rate < -slow ? system_->surface(c.on, c.from).restitution : 0.0);
  }
  ImpactResult result;
  FrictionProgram friction = builder_.friction_program();
  friction.force_unit = step_;
  CoulombSolver& solver = solver_of(island, motions_);
  if (std::ranges::all_of(restitution, [](double e) { return e == 0.0; })) {
    solver.solve(friction, result.solution, keys_of(builder_, island));
  } else {
    impact_with_restitution(solver, friction, restitution, closing, result,
                            keys_of(builder_, island));
  }
  IslandSolution solution = read(state, island, result.solution);
  solution.restitution_factor = result.factor;
  keep_if_missed(solution);  // nothing bounces then, so that bounds are those of the program
  return solution;
}

/// The velocity program asks nothing of what slides on and neither opens nor closes: no impulses are a solution as well. They are
/// none of what accelerations would have to be for an instant, so that is asked first, and leaves the modes that jump.
IslandSolution FrictionDynamics::jam(const State& state, const Island& island) {
  builder_.acceleration(state, island);
  builder_.add_friction(state, island);
  const QuadraticProgram asked = builder_.program();
  builder_.velocity(state, island);
  builder_.add_friction(state, island);
  const FrictionProgram exact = builder_.friction_program();
  QuadraticProgram pushed = exact.program;
  const double pull = size_of_target(asked);
  const double h = pull > 0.0 ? push_share * size_of_target(pushed) / pull : 0.0;
  for (int k = 0; k < pushed.unknowns(); ++k)
    pushed.target[k] += h * asked.target[k];
  for (int row = 0; row < pushed.rows(); ++row)
    pushed.bound[row] += h * asked.bound[row];
  CoulombSolver solver;
  CoulombResult result;
  const std::vector<std::uint64_t> keys = keys_of(builder_, island);
  solver.solve({pushed, exact.contacts}, result, keys);
  solver.solve(exact, result, keys);
  IslandSolution solution = read(state, island, result);
  keep_if_missed(solution);
  return solution;
}

bool FrictionDynamics::rests(const State& still, const Island& island) {
  return rest(still, island, Order::acceleration).equilibrium();
}

/// Forces that do this hold at rest what is pulled the other way besides.
bool FrictionDynamics::bears(const State& state,
                             const Island& island,
                             std::span<const SideUse> use,
                             std::span<const int> slides,
                             std::span<const Twist> accelerations,
                             double most) {
  ProgramBuilder builder(*system_, Formulation::rigid);
  builder.acceleration(state, island, use);
  builder.add_friction(state, island, slides);
  QuadraticProgram program = builder.program();
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    const Twist& a = accelerations[k];
    program.target[3 * k] -= a.linear.x();
    program.target[3 * k + 1] -= a.linear.y();
    program.target[3 * k + 2] -= a.angular;
  }
  if (!rest_) rest_ = std::make_unique<RestProgram>();
  const RestResult held = rest_->solve({program, builder.friction_program().contacts});
  return held.status == QpStatus::optimal && held.size <= most;
}

std::optional<IslandSolution> FrictionDynamics::stopping(const State& pushed,
                                                         const Island& island) {
  RestResult found = rest(pushed, island, Order::velocity);
  if (!found.equilibrium()) return {};
  CoulombResult stopped;
  stopped.status = found.status;
  stopped.x.assign(builder_.program().unknowns(), 0.0);
  stopped.multiplier = std::move(found.multiplier);
  stopped.residual = {};
  return read(pushed, island, stopped);
}

RestResult FrictionDynamics::rest(const State& state, const Island& island, Order order) {
  order == Order::velocity ? builder_.velocity(state, island)
                           : builder_.acceleration(state, island);
  builder_.add_friction(state, island);
  if (!rest_) rest_ = std::make_unique<RestProgram>();
  return rest_->solve(builder_.friction_program());
}

IslandSolution FrictionDynamics::placement(const State& state,
                                           const Island& island,
                                           std::span<const Twist> targets,
                                           bool again) {
  builder_.position(state, island, {}, targets);
  builder_.add_friction(state, island);
  FrictionProgram friction = builder_.friction_program();
  friction.force_unit = step_ * step_;
  friction.refines = again && is_placed_once(island);
  CoulombResult result;
  solver_of(island, motions_).solve(friction, result, keys_of(builder_, island));
  return read(state, island, result);
}

void FrictionDynamics::keep_if_missed(const IslandSolution& solution) const {
  if (solution.friction_inexact) MissedProgramListener::tell(builder_.friction_program());
}

}  // namespace wuerfel
