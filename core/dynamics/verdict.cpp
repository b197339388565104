#include "core/dynamics/verdict.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/forces_at.h"
#include "core/model/scales.h"

namespace wuerfel {
namespace {

/// The largest |a| + side |alpha| of any cube, as a share of g, or of the scale in its place.
double largest_share(const System& system,
                     const State& state,
                     const std::vector<Twist>& a,
                     std::span<const char> watched) {
  double e = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!watched.empty() && watched[i] == 0) continue;
    e = std::max(e, a[i].linear.norm() + system.bodies[i].size.minCoeff() * std::abs(a[i].angular));
  }
  const double g = system.gravity.norm();
  return e / (g > 0.0 ? g : scales_of(system, state).gravity);
}

/// The most that an island at rest which has no equilibrium moves in its certificate, as a share of
/// g.
double largest_unrest(const InstantForces& found, std::span<const char> watched) {
  double e = 0.0;
  for (const IslandForces& of : found.islands) {
    const bool counts = watched.empty() || watched[of.island.cubes.front()] != 0;
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
  return std::max(largest_share(system, state, found.accelerations, watched),
                  largest_unrest(found, watched));
}

Verdict judge(const System& system,
              const State& state,
              const InstantForces& found,
              std::span<const char> watched) {
  const bool moves = std::ranges::any_of(
      state, [](const BodyState& s) { return !s.velocity.isZero(0.0) || s.spin != 0.0; });
  if (moves) return Verdict::moves;
  if (!found.solved) return Verdict::undecided;
  const double e = unrest(system, state, found, watched);
  if (e <= stands_below) return Verdict::stands;
  return e >= falls_above ? Verdict::falls : Verdict::undecided;
}

}  // namespace wuerfel
