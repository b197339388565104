/// Programs with friction over islands: Coulomb's law in velocities and in displacements, exactly.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "core/dynamics/gauss.h"
#include "core/qp/coulomb/coulomb_solver.h"
#include "core/qp/coulomb/rest_program.h"

namespace wuerfel {

/// Whether contacts of the island rub, or bounce.
bool rubs(const System& system, const Island& island);
bool bounces(const System& system, const Island& island);
/// Whether the second placement of a step, which makes its order two, is left out where it is dear: many cubes without rods.
bool is_placed_once(const Island& island);

/// read_solution with what a program with friction says of forces along sides and slips.
IslandSolution read_with_friction(const ProgramBuilder& builder,
                                  const State& state,
                                  const Island& island,
                                  const std::vector<double>& x,
                                  const std::vector<double>& multiplier);
/// The same of an answer, and how good that is.
IslandSolution read_with_friction(const ProgramBuilder& builder,
                                  const State& state,
                                  const Island& island,
                                  const CoulombResult& result);

/// Builds and solves them. Remembers, island by island, which contacts stuck and slipped; an island
/// is known by its first cube.
class FrictionDynamics {
 public:
  FrictionDynamics(const System& system, const MotionSettings& settings);
  /// Impacts and placements to come belong to steps of h s.
  void begin_step(double h) { step_ = h; }

  /// Accelerations and forces under the contacts that `use` says, one entry per contact. `slides`:
  /// known directions of slip, else 0. May be infeasible where some are known (Painleve). Where solutions differ cubes that stand
  /// still stay so, if all of them can.
  IslandSolution accelerations(const State& state,
                               const Island& island,
                               std::span<const SideUse> use,
                               std::span<const int> slides);
  /// Velocities after all contacts of the island have hit at once, and their impulses: Coulomb's law
  /// and Newton's law of restitution on total impulses [Glocker 2013]. Velocities below `slow` (m/s)
  /// do not bounce.
  IslandSolution impact(const State& state, const Island& island, double slow);
  /// Impact without collision, where no accelerations exist (Painleve): the impulses that stop what
  /// slips, contacts sticking where they can. [Brogliato 1999]
  IslandSolution jam(const State& state, const Island& island);
  /// Whether the island can stay at rest where it is: an equilibrium exists [friction's cone is the
  /// dual of the motions that it cannot hold, qp/coulomb/rest_program.h].
  bool rests(const State& still, const Island& island);
  /// Whether the contacts that `use` says have forces under which the cubes accelerate as given, one of each per cube: what slips
  /// rubs against its slip, `slides`. `most`: what forces may miss, relative to the largest acceleration.
  bool bears(const State& state,
             const Island& island,
             std::span<const SideUse> use,
             std::span<const int> slides,
             std::span<const Twist> accelerations,
             double most);
  /// Impulses of the contacts that take away at once all the velocities that blows have given to an island at rest; none where
  /// there are no such impulses.
  std::optional<IslandSolution> stopping(const State& pushed, const Island& island);
  /// Displacements from `state` nearest to `targets` (one per cube, m and rad) under Coulomb's law
  /// in displacements: no gap below zero, friction against the way that a corner slides. `again`: gaps
  /// have been measured anew since the last one; of more than a few cubes without rods an answer is
  /// asked for only where it is near.
  IslandSolution placement(const State& state,
                           const Island& island,
                           std::span<const Twist> targets,
                           bool again = false);
  /// What is remembered of the motions of an island.
  void forget(const Island& island) { motions_.erase(island.cubes.front()); }
  /// Lets the last program be kept if the solution that is used misses Coulomb's law. Of placements the caller knows whether
  /// it is; the others do so themselves.
  void keep_if_missed(const IslandSolution& solution) const;

 private:
  using Solvers = std::map<int, std::unique_ptr<CoulombSolver>>;
  CoulombSolver& solver_of(const Island& island, Solvers& solvers) const;
  RestResult rest(const State& state, const Island& island, Order order);
  [[nodiscard]] IslandSolution read(const State& state,
                                    const Island& island,
                                    const CoulombResult& result) const;

  const System* system_;
  MotionSettings settings_;
  double step_ = 0.0;  ///< s; 0: none
  ProgramBuilder builder_;
  std::unique_ptr<RestProgram> rest_;  ///< made when first needed
  Solvers accelerations_;
  Solvers motions_;  ///< velocities and displacements: what sticks in one does so in the other
};

}  // namespace wuerfel
