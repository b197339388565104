/// The momentum balance: what momenta changed by against what gravity and fixed bodies did.
#pragma once

#include <span>
#include <vector>

#include "core/constraints/islands.h"
#include "core/dynamics/gauss.h"
#include "core/dynamics/push.h"

namespace wuerfel {

/// Centre of mass of the cubes that do not rest (`resting`: one per cube, or empty), m.
Vec2 common_center(const System& system, const State& state, std::span<const char> resting = {});

/// Adds what a fixed body does to the cubes through a contact that pushes the body of its corner by
/// `impulse` (N s, or N). What cubes do to one another has no sum.
void add_push(const System& system,
              const State& state,
              const Vec2& center,
              const Contact& contact,
              const Vec2& impulse,
              Push& sum);

/// The same of a rod or pin, whose multiplier it is.
void add_push(const State& place, const Vec2& center, const Rod& rod, double impulse, Push& sum);

/// The same of all contacts and rods of an island, with the forces (N), or impulses (N s), of a solution.
Push push_of(const System& system,
             const State& state,
             const Island& island,
             const IslandSolution& solution);

/// What of the change of the momenta within `dt` s (none: at once) neither gravity nor `pushes` of fixed bodies
/// account for: N s, and N m s about the common centre. Of the cubes that do not rest.
Push unexplained(const System& system,
                 const State& before,
                 const State& after,
                 double dt = 0.0,
                 const Push& pushes = {},
                 std::span<const char> resting = {});

/// Sums of magnitudes, which changes of momenta are measured by.
struct MomentumScale {
  double linear = 0.0;  ///< N s, sum of m max(|v|, V)
  double angular =
      0.0;  ///< N m s, sum of m r max(|v|, V) about the common centre; r: at least a radius

  /// Makes it the larger of the two.
  void include(const MomentumScale& other);
};
/// `speed`: V, m/s.
MomentumScale momentum_scale(const System& system, const State& state, double speed);

}  // namespace wuerfel
