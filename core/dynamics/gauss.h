/// Gauss' principle of least constraint, Eq. (9), and Moreau's impact law, island by island.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/dynamics/programs.h"
#include "core/qp/qp_solver.h"
#include "core/qp/residual_meter.h"

namespace wuerfel {

/// A contact presses where its force is greater than this share of the largest.
inline constexpr double pressing_share = loaded_share;

/// What a program over an island says.
struct [[nodiscard]] IslandSolution {
  QpStatus status = QpStatus::invalid;
  double residual = 0.0;       ///< QpResidual::worst()
  bool skipped = false;        ///< the island's former answer passed the test: nothing was solved
  int iterations = 0;          ///< of the solver
  std::vector<Twist> twists;   ///< per cube: accelerations, or velocities after an impact
  std::vector<double> forces;  ///< per contact: N, or N s; 0 where the contact is not active
  std::vector<double>
      rods{};  ///< per rod of the island: N, or N s, on the body of place i (rod_rows.h)
  /// Per contact: N, or N s, along perp(normal) on the body of the corner; empty where nothing rubs.
  std::vector<double> tangential;
  bool friction_inexact = false;    ///< Coulomb's law was missed by `residual`
  double restitution_factor = 1.0;  ///< what all coefficients were multiplied by
  /// Per contact: J x - b, which is the gap's second rate (m/s^2), its rate or the gap itself;
  /// infinite where the contact is not active.
  std::vector<double> slacks;
  /// Likewise along the side: J_t x - b_t; 0 where a contact does not rub.
  std::vector<double> slips;

  /// 0 where there is no contact.
  [[nodiscard]] double largest_force() const;
  /// A contact presses where its force is greater than this.
  [[nodiscard]] double least_pressing() const;
};

/// What a point x of the builder's program and its multipliers say of an island; of none (another number of unknowns), that its
/// cubes move as if nothing touched them.
IslandSolution read_solution(const ProgramBuilder& builder,
                             const State& state,
                             const Island& island,
                             const std::vector<double>& x,
                             const std::vector<double>& multiplier);

/// The impulse (N s), or force (N), of a solution on the body of the corner of its contact k.
Vec2 impulse_at(const Contact& contact, const IslandSolution& solution, std::size_t k);

/// How exactly programs of more than a few cubes are solved: bounds of QpResidual::worst(). Small
/// ones are always exact, which costs them nothing.
struct ProgramTolerances {
  double impact = QpSettings{}.tolerance;
  double correction = QpSettings{}.tolerance;  ///< displacements nearest to none
  double placement = QpSettings{}.tolerance;   ///< displacements nearest to targets
};

/// Displacements of so many cubes are solved exactly.
inline constexpr std::size_t few_displaced_cubes = 24;

/// Builds and solves programs. Remembers, island by island, what a solver can start from; an island
/// is known by its first cube. Throws SolverError where a solver is missing or a program malformed (a
/// state that is not a number, say).
class IslandDynamics {
 public:
  IslandDynamics(const System& system,
                 const MotionSettings& settings,
                 const ProgramTolerances& tolerances = {});

  /// Accelerations (m/s^2, rad/s^2) and contact forces under the contacts that do not open.
  IslandSolution accelerations(const State& state, const Island& island);
  /// The same with active contacts as `use` says, one entry per contact.
  IslandSolution accelerations(const State& state,
                               const Island& island,
                               std::span<const SideUse> use);
  /// Velocities after all contacts of the island have hit at once, and their impulses.
  IslandSolution impact(const State& state, const Island& island);
  /// Velocities nearest to those of `state` with gap rates that are zero where `use` says equality
  /// and not negative where it says inequality.
  IslandSolution velocities(const State& state, const Island& island, std::span<const SideUse> use);
  /// Displacements (m, rad), to first order, that make gaps zero where `use` says equality and not
  /// negative where it says inequality; nearest to `targets` (one per cube of the island), or to
  /// zero.
  IslandSolution correction(const State& state,
                            const Island& island,
                            std::span<const SideUse> use,
                            std::span<const Twist> targets = {});

 private:
  /// The last program of an island: its answer, and the solver with what that remembers.
  struct Memory {
    std::unique_ptr<QpSolver> solver;
    double tolerance = 0.0;  ///< of the solver
    QpResult result;
  };
  /// Of programs of one kind, by the first cube of the island.
  struct Memories {
    std::size_t few_cubes = 0;  ///< of an island that is solved exactly all the same
    QpSettings settings;        ///< of larger ones
    std::map<int, Memory> of_island;
  };

  IslandSolution solve(const State& state, const Island& island, Memories& memories);
  [[nodiscard]] bool still_passes(Memory& memory, double tolerance) const;
  void solve_anew(const QpSettings& settings, Memory& memory);

  const System* system_;
  MotionSettings settings_;
  ProgramBuilder builder_;
  Memories accelerations_;
  Memories impacts_;
  Memories velocities_;
  Memories corrections_;
  Memories placements_;
};

/// Takes the velocities of an island's cubes over into the state.
void set_velocities(const Island& island, const std::vector<Twist>& velocities, State& state);

/// Moves an island's cubes.
void displace(const Island& island, const std::vector<Twist>& displacements, State& state);

/// Whether the accelerations of an island under its forces are zero but for rounding: |a| + side
/// |alpha| of every cube at most 1e-10 g (design, "Verdict") and what the residual leaves of the
/// largest force, but always less than what counts as falling (1e-9 g). `gravity` is g, m/s^2, or
/// the scale in its place.
bool accelerations_vanish(const System& system,
                          const Island& island,
                          const IslandSolution& solution,
                          double gravity);

}  // namespace wuerfel
