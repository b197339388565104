#include "core/check.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/forces_at.h"
#include "core/dynamics/friction.h"
#include "core/dynamics/impact.h"
#include "core/model/scales.h"
#include "core/time/reference/active_restrictions.h"
#include "core/time/start_state.h"

namespace wuerfel {
namespace {

void add_contact_forces(const System& system, const IslandForces& of, Check& check) {
  for (std::size_t k = 0; k < of.island.contacts.size(); ++k) {
    const Contact& c = of.island.contacts[k];
    check.contacts.push_back(
        {system.body(c.on).name, system.body(c.from).name, c.point, c.normal, of.forces.force[k],
         of.forces.tangential.empty() ? 0.0 : of.forces.tangential[k], of.forces.unique[k] != 0});
  }
}

void add_rod_forces(const System& system, const std::vector<IslandForces>& islands, Check& check) {
  std::vector<double> force(system.rods.size(), 0.0);
  std::vector<char> unique(system.rods.size(), 1);
  for (const IslandForces& of : islands) {
    for (std::size_t k = 0; k < of.island.rods.size(); ++k) {
      force[of.island.rods[k]] = of.forces.rods[k];
      unique[of.island.rods[k]] = of.forces.rods_unique[k];
    }
  }
  for (std::size_t k = 0; k < system.rods.size(); ++k) {
    const Rod& rod = system.rods[k];
    if (rod.kind == Rod::Kind::rod) {
      check.rods.push_back({rod.name, -force[k], unique[k] != 0});
    } else if (rod.kind == Rod::Kind::pin_x) {
      check.pins.push_back(
          {rod.name, {force[k], force[k + 1]}, unique[k] != 0 && unique[k + 1] != 0});
    }
  }
}

/// Impacts at the start of islands that rub or bounce.
void strike(State& state, Workspace& work, Bookkeeping& book) {
  const System& system = *work.system;
  const std::vector<Contact> contacts = work.finder.find(system, state);
  const double slow = rate_tolerance * scales_of(system, state).speed;
  for (const Island& island : find_islands(system, contacts)) {
    if (!rubs(system, island) && !bounces(system, island)) continue;
    if (!closes(system, state, island)) continue;
    const IslandSolution after = work.friction.impact(state, island, slow);
    keep_book(after, book);
    set_velocities(island, after.twists, state);
    // What the law leaves of the velocities of those that stay is no slip.
    for (const int cube : island.cubes)
      if (fastest_corner(system.body(cube), state[cube]) <= slow) stop(state[cube]);
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

Check check(const Scene& scene, const MotionSettings& settings) {
  const System system = make_system(scene);
  GridPoint start;
  start.state = start_state(scene);
  Bookkeeping impacts;
  Workspace work(system, settings);
  if (system.rubs || system.bounces) strike(start.state, work, impacts);
  find_restrictions(start, work, impacts);
  const auto accelerations = [&] {
    return forces_at(system, settings, start.state, Detail::accelerations).accelerations;
  };
  require_consistent_rods(system, start.state, accelerations);
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
  add_rod_forces(system, found.islands, check);
  if (system.rubs) check.facts = find_facts(system, settings, start.state, found, check.verdict);
  return check;
}

}  // namespace wuerfel
