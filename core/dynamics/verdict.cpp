#include "core/dynamics/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/dynamics/forces_at.h"
#include "core/model/scales.h"

namespace wuerfel {
namespace {

/// Rounding of single numbers leaves this much of what should cancel.
constexpr double bits = 4.0 * std::numeric_limits<double>::epsilon();
/// A residual above this has been piled up by many of them.
constexpr double piled_up = 1e-14;
/// What falls by less than so many times what is uncertain may as well stand.
constexpr double certain_times = 100.0;

/// What the residual of forces leaves open of a cube's share of g.
struct Doubt {
  /// The most that forces which are wrong by it may change the share by.
  double uncertain = 0.0;
  /// What it leaves of the largest force of the island, as a share of the weight: so little may as well come from far away.
  double carried = 0.0;
};

/// One per cube.
std::vector<Doubt> doubts_of(const System& system, const InstantForces& found, double g) {
  std::vector<Doubt> doubts(system.cubes);
  for (const IslandForces& of : found.islands) {
    const bool shown = !of.forces.force.empty();
    const std::vector<double>& forces = shown ? of.forces.force : of.solution.forces;
    const double residual = std::max(bits, shown ? of.forces.residual : of.solution.residual);
    double largest = 0.0;
    const auto add = [&](int cube, const Vec2& arm, const Vec2& force) {
      if (!system.is_cube(cube)) return;
      const Body& body = system.body(cube);
      const Twist a{force / body.mass, body.inertia > 0.0 ? det(arm, force) / body.inertia : 0.0};
      doubts[cube].uncertain += residual * size_of(body, a) / g;
    };
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const Contact& c = of.island.contacts[k];
      add(c.on, c.arm_k, forces[k] * c.normal);
      add(c.from, c.arm_i + c.alpha * (c.arm_j - c.arm_i), forces[k] * c.normal);
      largest = std::max(largest, forces[k]);
    }
    for (const int cube : of.island.cubes)
      doubts[cube].carried = residual * largest / (system.body(cube).mass * g);
  }
  return doubts;
}

/// How far cubes are from rest, and how well that is known.
struct Unrest {
  double most = 0.0;       ///< the largest share
  bool certain = false;    ///< some share that counts as falling is more than rounding leaves of it
  double uncertain = 0.0;  ///< the largest share that rounding may have piled up to
};

Unrest unrest_of(const System& system,
                 const State& state,
                 const InstantForces& found,
                 std::span<const char> watched) {
  const double g =
      system.gravity.isZero(0.0) ? scales_of(system, state).gravity : system.gravity.norm();
  const std::vector<Doubt> doubts = doubts_of(system, found, g);
  Unrest unrest;
  for (int i = 0; i < system.cubes; ++i) {
    if (!watched.empty() && watched[i] == 0) continue;
    const auto& [uncertain, carried] = doubts[i];
    const double share = size_of(system.body(i), found.accelerations[i]) / g;
    unrest.most = std::max(unrest.most, share);
    unrest.certain =
        unrest.certain
        || (share >= falls_above && share > certain_times * std::max(uncertain, carried));
    // Where forces balance to their last bits nothing has piled up, however large they are.
    if (found.residual > piled_up) unrest.uncertain = std::max(unrest.uncertain, uncertain);
  }
  return unrest;
}

/// The most that an island at rest which has no equilibrium moves in its certificate, as a share of
/// g. An island that cubes belong to which fall anyway has none for their sake.
double largest_unrest(const InstantForces& found, std::span<const char> watched) {
  double e = 0.0;
  for (const IslandForces& of : found.islands) {
    const bool counts = watched.empty() || std::ranges::all_of(of.island.cubes, [&](int cube) {
                          return watched[cube] != 0;
                        });
    if (counts && of.friction && !of.friction->equilibrium) e = std::max(e, of.friction->unrest);
  }
  return e;
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::stands:
      return "stands";
    case Verdict::falls:
      return "falls";
    case Verdict::moves:
      return "moves";
    case Verdict::undecided:
      return "undecided";
  }
  return "?";
}

double unrest(const System& system,
              const State& state,
              const InstantForces& found,
              std::span<const char> watched) {
  return std::max(unrest_of(system, state, found, watched).most, largest_unrest(found, watched));
}

Verdict judge(const System& system,
              const State& state,
              const InstantForces& found,
              std::span<const char> watched) {
  if (!std::ranges::all_of(state, is_still)) return Verdict::moves;
  if (!found.solved) return Verdict::undecided;
  const Unrest own = unrest_of(system, state, found, watched);
  const double certificate = largest_unrest(found, watched);
  if (own.certain || certificate >= falls_above) return Verdict::falls;
  const bool stands = std::max(own.most, certificate) <= stands_below;
  return stands && own.uncertain < falls_above ? Verdict::stands : Verdict::undecided;
}

}  // namespace wuerfel
