#include "core/check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/dynamics/forces_at.h"
#include "core/dynamics/friction.h"
#include "core/dynamics/impact.h"
#include "core/model/scales.h"
#include "core/time/reference/active_restrictions.h"
#include "core/time/start_state.h"

namespace wuerfel {
namespace {

/// Shares of g (design, "Verdict"): below the first a cube stands, above the second it falls.
constexpr double stands_below = 1e-10;
constexpr double falls_above = 1e-9;

/// Rounding of single numbers leaves this much of what should cancel.
constexpr double bits = 4.0 * std::numeric_limits<double>::epsilon();

/// |a| + side |alpha| as a share of g, or of the scale in its place.
double share_of(const Body& body, const Twist& a, double g) {
  return (a.linear.norm() + body.size.minCoeff() * std::abs(a.angular)) / g;
}

/// The most that forces which are wrong by `residual` of themselves may change these shares by, one
/// per cube.
std::vector<double> uncertain_shares(const System& system, const InstantForces& found, double g) {
  std::vector<double> shares(system.cubes, 0.0);
  for (const IslandForces& of : found.islands) {
    const bool shown = !of.forces.force.empty();
    const std::vector<double>& forces = shown ? of.forces.force : of.solution.forces;
    const double residual = std::max(bits, shown ? of.forces.residual : of.solution.residual);
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const Contact& c = of.island.contacts[k];
      const auto add = [&](int cube, const Vec2& arm) {
        if (!system.is_cube(cube)) return;
        const Body& body = system.body(cube);
        const Twist a{forces[k] / body.mass * c.normal, forces[k] * det(arm, c.normal) / body.inertia};
        shares[cube] += residual * share_of(body, a, g);
      };
      add(c.on, c.arm_k);
      add(c.from, c.arm_i + c.alpha * (c.arm_j - c.arm_i));
    }
  }
  return shares;
}

/// How far the cubes are from rest, and how well that is known.
struct Unrest {
  double most = 0.0;       ///< the largest share
  bool certain = false;    ///< some share that counts as falling is more than rounding leaves
  double uncertain = 0.0;  ///< the largest share by which those may be wrong that rounding piled up in
};

Unrest unrest_of(const System& system, const State& state, const InstantForces& found) {
  const double g =
      system.gravity.isZero(0.0) ? scales_of(system, state).gravity : system.gravity.norm();
  const std::vector<double> uncertain = uncertain_shares(system, found, g);
  Unrest unrest;
  for (int i = 0; i < system.cubes; ++i) {
    const double share = share_of(system.body(i), found.accelerations[i], g);
    unrest.most = std::max(unrest.most, share);
    unrest.certain = unrest.certain || (share >= falls_above && share > uncertain[i]);
    // Where forces balance to their last bits nothing has piled up, however large they are.
    if (found.residual > bits) unrest.uncertain = std::max(unrest.uncertain, uncertain[i]);
  }
  return unrest;
}

/// The most that an island at rest which has no equilibrium moves in its certificate, as a share of
/// g.
double largest_unrest(const InstantForces& found) {
  double e = 0.0;
  for (const IslandForces& of : found.islands)
    if (of.friction && !of.friction->equilibrium) e = std::max(e, of.friction->unrest);
  return e;
}

Verdict judge(const System& system, const State& state, const InstantForces& found) {
  const bool moves = std::ranges::any_of(
      state, [](const BodyState& s) { return !s.velocity.isZero(0.0) || s.spin != 0.0; });
  if (moves) return Verdict::moves;
  if (!found.solved) return Verdict::undecided;
  const Unrest unrest = unrest_of(system, state, found);
  const double certificate = largest_unrest(found);
  if (unrest.certain || certificate >= falls_above) return Verdict::falls;
  const bool stands = std::max(unrest.most, certificate) <= stands_below;
  return stands && unrest.uncertain < falls_above ? Verdict::stands : Verdict::undecided;
}

void add_contact_forces(const System& system, const IslandForces& of, Check& check) {
  for (std::size_t k = 0; k < of.island.contacts.size(); ++k) {
    const Contact& c = of.island.contacts[k];
    check.contacts.push_back(
        {system.body(c.on).name, system.body(c.from).name, c.point, c.normal, of.forces.force[k],
         of.forces.tangential.empty() ? 0.0 : of.forces.tangential[k], of.forces.unique[k] != 0});
  }
}

/// Impacts at the start of islands that rub or bounce.
void strike(const System& system, const MotionSettings& settings, State& state, Bookkeeping& book) {
  std::vector<Contact> contacts;
  ContactFinder().find(system, state, contacts);
  std::vector<Island> islands;
  find_islands(system, contacts, islands);
  const double slow = rate_tolerance * scales_of(system, state).speed;
  for (const Island& island : islands) {
    if (!rubs(system, island) && !bounces(system, island)) continue;
    if (!closes(system, state, island)) continue;
    const IslandSolution after = FrictionDynamics(system, settings).impact(state, island, slow);
    keep_book(after, book);
    set_velocities(island, after.twists, state);
  }
}

/// Whether the exact law also has a fall, where an equilibrium exists. `frictionless` is the same
/// instant without friction.
bool may_fall(const System& system,
              const State& state,
              const InstantForces& found,
              const InstantForces& frictionless) {
  for (std::size_t m = 0; m < found.islands.size(); ++m) {
    const IslandForces& smooth = frictionless.islands[m];
    if (found.islands[m].friction && !smooth.rests
        && fall_satisfies_law(system, state, smooth.island, smooth.solution))
      return true;
  }
  return false;
}

FrictionFacts find_facts(const System& system,
                         const MotionSettings& settings,
                         const State& state,
                         const InstantForces& found,
                         Verdict verdict) {
  FrictionFacts facts;
  if (verdict == Verdict::moves) return facts;
  facts.equilibrium_exists = verdict == Verdict::stands;
  System smooth = system;
  smooth.rubs = false;
  const InstantForces frictionless = forces_at(smooth, settings, state, Detail::accelerations);
  facts.stands_without_friction = judge(smooth, state, frictionless) == Verdict::stands;
  facts.fall_also_possible = facts.equilibrium_exists && !facts.stands_without_friction
                             && may_fall(system, state, found, frictionless);
  return facts;
}

void add_certificate(const System& system, const IslandForces& of, Check& check) {
  if (!of.friction) return;
  check.jams = check.jams || of.friction->jams;
  if (of.friction->certificate.empty()) return;
  check.certificate.resize(system.cubes);
  for (std::size_t k = 0; k < of.island.cubes.size(); ++k)
    check.certificate[of.island.cubes[k]] = of.friction->certificate[k];
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

Check check(const Scene& scene, const MotionSettings& settings) {
  const System system = make_system(scene);
  GridPoint start;
  start.state = start_state(scene);
  Bookkeeping impacts;
  if (system.rubs || system.bounces) strike(system, settings, start.state, impacts);
  ActiveRestrictions(system, settings).find(start, impacts);
  const InstantForces found = forces_at(system, settings, start.state, Detail::uniqueness);

  Check check;
  check.verdict = judge(system, start.state, found);
  if (impacts.audit.missed_solves > 0 && check.verdict != Verdict::moves)
    check.verdict = Verdict::undecided;
  check.kkt_residual = found.residual;
  check.accelerations = found.accelerations;
  for (int i = 0; i < system.cubes; ++i) {
    const Body& body = system.body(i);
    const Twist& a = check.accelerations[i];
    check.objective += body.mass * (a.linear - system.gravity).squaredNorm()
                       + body.inertia * a.angular * a.angular;
  }
  for (const IslandForces& of : found.islands) {
    add_contact_forces(system, of, check);
    add_certificate(system, of, check);
  }
  if (system.rubs) check.facts = find_facts(system, settings, start.state, found, check.verdict);
  return check;
}

}  // namespace wuerfel
