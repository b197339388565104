/// Gauss' principle of least constraint, Eq. (9), and Moreau's impact law, island by island.
#pragma once

#include <vector>

#include "core/dynamics/programs.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

/// What a program over an island says.
struct [[nodiscard]] IslandSolution {
  QpStatus status = QpStatus::invalid;
  double residual = 0.0;       ///< QpResidual::worst()
  std::vector<Twist> twists;   ///< per cube: accelerations, or velocities after an impact
  std::vector<double> forces;  ///< per contact: N, or N s; 0 where the contact is not active
};

/// Builds and solves programs; keeps its memory from call to call.
class IslandDynamics {
 public:
  IslandDynamics(const System& system, Formulation formulation, QpSolver& solver)
      : system_(&system), builder_(system, formulation), solver_(&solver) {}

  /// Accelerations (m/s^2, rad/s^2) and contact forces under the contacts that rest.
  IslandSolution accelerations(const State& state, const Island& island);
  /// Velocities after all contacts of the island have hit at once, and their impulses.
  IslandSolution impact(const State& state, const Island& island);
  /// Velocities nearest to those of `state` with the gap rates of all contacts zero.
  IslandSolution tangential_velocities(const State& state, const Island& island);
  /// Displacements (m, rad) to first order that close the gaps of `closed` contacts and open all
  /// negative ones.
  IslandSolution correction(const State& state, const Island& island, std::span<const SideUse> use);

 private:
  IslandSolution solve(const State& state, const Island& island);

  const System* system_;
  ProgramBuilder builder_;
  QpSolver* solver_;
  QpResult result_;
  std::vector<SideUse> use_;
};

/// max over cubes of (|a| + side |alpha|), m/s^2: how far from rest accelerations are.
double largest_acceleration(const System& system,
                            const Island& island,
                            const std::vector<Twist>& twists);

}  // namespace wuerfel
