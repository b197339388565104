#include "core/dynamics/instant_friction.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/dynamics/friction.h"
#include "core/dynamics/missed_programs.h"
#include "core/dynamics/verdict.h"
#include "core/qp/coulomb/coulomb_stages.h"
#include "core/qp/coulomb/held_blocks.h"
#include "core/qp/coulomb/rest_program.h"

namespace wuerfel {
namespace {

constexpr int newton_factorisations = 8;
constexpr int seeds_from_open = 3;

IslandSolution equilibrium(const ProgramBuilder& builder,
                           const State& state,
                           const Island& island,
                           const std::vector<double>& multiplier) {
  const std::vector<double> zero(builder.program().unknowns(), 0.0);
  IslandSolution solution = read_with_friction(builder, state, island, zero, multiplier);
  solution.twists.assign(island.cubes.size(), {});
  solution.residual = coulomb_residual(builder.friction_program(), zero, multiplier).worst();
  solution.status =
      solution.residual <= CoulombSettings{}.tolerance ? QpStatus::optimal : QpStatus::inaccurate;
  return solution;
}

IslandSolution exact_law(const ProgramBuilder& builder, const State& state, const Island& island) {
  CoulombResult result;
  CoulombSolver().solve(builder.friction_program(), result);
  let_stand(builder.friction_program(), builder.still_blocks(state, island), result);
  if (result.inexact()) MissedProgramListener::tell(builder.friction_program());
  return read_with_friction(builder, state, island, result);
}

/// The multipliers that the law has at the contacts' forces of another solution and its slips.
std::vector<double> with_slips(const ProgramBuilder& builder, const IslandSolution& of) {
  const FrictionProgram friction = builder.friction_program();
  const std::vector<double> x = unknowns_of(of.twists);
  const double scale = CoulombJudge().measure_scales(friction.program).velocity;
  std::vector<double> multiplier(friction.program.rows(), 0.0);
  std::ranges::copy(of.rods, multiplier.begin() + builder.first_rod_row());
  for (std::size_t k = 0; k < of.forces.size(); ++k) {
    const int n = builder.friction_contact()[k];
    if (n < 0) continue;
    const FrictionContact& contact = friction.contacts[n];
    multiplier[contact.normal] = std::max(0.0, of.forces[k]);
    if (contact.tangent < 0) continue;
    const double ut = friction.program.slack(contact.tangent, x);
    if (std::abs(ut) > still_share * scale)
      multiplier[contact.tangent] = std::copysign(contact.mu * multiplier[contact.normal], -ut);
  }
  return multiplier;
}

/// Looks for solutions of one program that are not zero.
class FallSearch {
 public:
  FallSearch(FrictionProgram friction, std::vector<double> start)
      : friction_(std::move(friction)), start_(std::move(start)), stages_(CoulombSettings{}) {
    stages_.prepare(friction_);
    scale_ = CoulombJudge().measure_scales(friction_.program).velocity;
  }

  [[nodiscard]] bool found() {
    const auto newton = [&](CoulombResult& r) {
      return stages_.newton(friction_, newton_factorisations, r);
    };
    const auto path = [&](PathStart start, std::uint64_t seed) {
      return [this, start, seed](CoulombResult& r) {
        return stages_.follow(friction_, start, seed, Pivoting::none, r);
      };
    };
    if (falls(newton) || falls(path(PathStart::here, friction_.contacts.size()))) return true;
    if (friction_.contacts.size() > most_from_open) return false;
    for (int k = 0; k < seeds_from_open; ++k)
      if (falls(path(PathStart::open, friction_.contacts.size() + k))) return true;
    return false;
  }

 private:
  /// Whether a stage, begun at the start, ends in a solution that is a fall.
  template <class Stage>
  bool falls(const Stage& stage) {
    CoulombResult result;
    result.residual.stationarity = unbounded;
    stages_.modes.resize(stages_.form().count());
    stages_.point.reset(stages_.form());
    stages_.take(start_);
    if (!stage(result)) return false;
    for (int i = 0; i < friction_.program.unknowns(); ++i)
      if (std::abs(result.x[i]) * friction_.program.unit(i) > falls_above * scale_) return true;
    return false;
  }

  const FrictionProgram friction_;
  const std::vector<double> start_;
  CoulombStages stages_;
  double scale_ = 0.0;  ///< m/s^2
};

}  // namespace

std::vector<int> known_slips(const System& system,
                             const State& state,
                             const Island& island,
                             double dead_zone) {
  std::vector<int> slides(island.contacts.size(), 0);
  for (std::size_t k = 0; k < slides.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (system.surface(c.on, c.from).friction == 0.0) continue;
    const double slip = slip_rate(system, state, c);
    const double speed = contact_speed(system, c, contact_velocity(system, state, c));
    if (std::abs(slip) > dead_zone * speed) slides[k] = slip > 0.0 ? 1 : -1;
  }
  return slides;
}

RubbingAccelerations accelerations_with_friction(const System& system,
                                                 Formulation formulation,
                                                 const State& state,
                                                 const Island& island,
                                                 std::span<const SideUse> use,
                                                 const std::vector<int>& slides,
                                                 bool still) {
  ProgramBuilder builder(system, formulation);
  builder.acceleration(state, island, use);
  builder.add_friction(state, island, slides);
  RubbingAccelerations found;
  found.friction.slides = slides;
  RestResult rest;
  if (still) rest = RestProgram().solve(builder.friction_program());
  found.friction.equilibrium = rest.equilibrium();
  if (rest.equilibrium()) {
    found.solution = equilibrium(builder, state, island, rest.multiplier);
    return found;
  }
  found.solution = exact_law(builder, state, island);
  found.friction.jams = found.solution.status == QpStatus::infeasible;
  if (!still) return found;
  // Forces that balance are an equilibrium, whatever the convex program has said.
  if (accelerations_vanish(system, island, found.solution, system.gravity.norm())) {
    found.friction.equilibrium = true;
    found.solution.twists.assign(island.cubes.size(), {});
    return found;
  }
  found.friction.unrest = rest.size;
  if (rest.status == QpStatus::optimal) {
    found.friction.certificate = builder.twists(state, island, rest.acceleration);
  } else {
    found.solution.status = QpStatus::inaccurate;  // what moves may have an equilibrium as well
  }
  return found;
}

bool fall_satisfies_law(const System& system,
                        const State& state,
                        const Island& island,
                        const IslandSolution& frictionless) {
  ProgramBuilder builder(system, Formulation::rigid);
  builder.acceleration(state, island);
  builder.add_friction(state, island);
  return FallSearch(builder.friction_program(), with_slips(builder, frictionless)).found();
}

}  // namespace wuerfel
