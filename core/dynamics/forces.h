/// Which forces are shown. Multipliers are forces, but in a hyperstatic stack many multipliers are
/// optimal (the paper, section 2.3, blames elasticity; the reason is that rigid bodies
/// over-determine their supports). Shown is the non-negative distribution of least sum of squares
/// over unit-normal contact forces and rods between bodies together: the limit of equal, vanishing compliance at every contact
/// and rod, both ways where it rubs or is pinned. Rods of cubes follow cube by cube and take least squares of their own.
#pragma once

#include <array>
#include <vector>

#include "core/constraints/islands.h"
#include "core/dynamics/gauss.h"
#include "core/model/points.h"

namespace wuerfel {

enum class Uniqueness { asked, ignored };

struct ContactForces {
  std::vector<double> force;  ///< N, >= 0; one per contact of the island, 0 where it is opening
  std::vector<char>
      unique;  ///< whether no other force here gives the same accelerations; all 0 if ignored
  /// N, along perp(normal) on the body of the corner; empty where nothing rubs.
  std::vector<double> tangential{};
  std::vector<double>
      rods{};  ///< N; one per rod of the island, on the body of place i (rod_rows.h)
  std::vector<char> rods_unique{};  ///< likewise, as `unique`
  /// N; a contact presses where its force is greater than this: as IslandSolution::least_pressing.
  [[nodiscard]] double least_pressing() const;
  /// Of these very forces: QpResidual::worst() with the accelerations, and body by body what they miss
  /// of Newton's law in parts of the largest force on the body (ResidualMeter::imbalance); where
  /// something rubs CoulombResidual::worst().
  double residual = 0.0;
};

/// Contact forces of least sum of squares that give `accelerations`: those of `solution` as they are
/// used (exactly zero in certified rest). Where they cannot be found as exactly as the forces of
/// `solution` balance, these are returned.
ContactForces canonical_forces(const System& system,
                               const State& state,
                               const Island& island,
                               const std::vector<Twist>& accelerations,
                               const IslandSolution& solution,
                               Uniqueness uniqueness);

/// The same of normal and tangential forces together, in an island that rubs; `slides` are the known
/// directions of slip.
ContactForces canonical_forces_with_friction(const System& system,
                                             const State& state,
                                             const Island& island,
                                             const std::vector<int>& slides,
                                             const std::vector<Twist>& accelerations,
                                             const IslandSolution& solution,
                                             Uniqueness uniqueness);

/// Tensions (N, tension positive) of the rods of one cube, in the order of cube_rods: least sum of
/// squares among those that give every point its acceleration under gravity and the forces of contacts and rods
/// on the cube, which are those of `island`.
std::array<double, rods_per_cube> rod_forces(const System& system,
                                             const State& state,
                                             int cube,
                                             const Twist& acceleration,
                                             const Island& island,
                                             const ContactForces& forces);

}  // namespace wuerfel
