#include "core/dynamics/projection.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/rod_rows.h"

namespace wuerfel {
namespace {

/// A round of an island; it keeps to the policy where restrictions contradict one another.
IslandSolution correct(Restricted& part,
                       const State& state,
                       Contradiction contradiction,
                       IslandDynamics& dynamics,
                       Projection& result) {
  IslandSolution solution = nearest_place(state, part, {}, dynamics, result.solves);
  if (solution.status == QpStatus::optimal || contradiction != Contradiction::open) return solution;
  result.solves.count(solution);
  result.opened.insert(result.opened.end(), part.island.contacts.begin(),
                       part.island.contacts.end());
  std::ranges::fill(part.use, SideUse::inequality);
  return nearest_place(state, part, {}, dynamics, result.solves);
}

bool goes_too_far(const Restricted& part, const IslandSolution& solution) {
  return std::ranges::any_of(solution.twists,
                             [&](const Twist& d) { return d.linear.norm() > part.farthest; });
}

void take_over(const Restricted& part, const IslandSolution& solution, Projection& result) {
  displace(part.island, solution.twists, result.state);
  for (std::size_t k = 0; k < part.use.size(); ++k) {
    if (part.use[k] == SideUse::inequality && solution.forces[k] > 0.0)
      result.pushing.push_back(part.island.contacts[k]);
  }
}

}  // namespace

bool misses(const System& system,
            const State& state,
            const Restricted& part,
            const ProjectionPolicy& policy) {
  for (std::size_t k = 0; k < part.use.size(); ++k) {
    const Contact& c = part.island.contacts[k];
    if (part.use[k] == SideUse::inequality && overlaps(system, c, policy.overlap)) return true;
    if (part.use[k] == SideUse::equality && std::abs(c.gap) > policy.gap * contact_scale(system, c))
      return true;
  }
  return std::ranges::any_of(part.island.rods,
                             [&](int rod) { return !has_length(system, state, system.rods[rod]); });
}

bool rests(const System& system, const State& state, const Restricted& part) {
  for (std::size_t k = 0; k < part.use.size(); ++k) {
    const Contact& c = part.island.contacts[k];
    if (part.use[k] == SideUse::equality
        && contact_motion(system, state, c) != ContactMotion::resting)
      return false;
  }
  return std::ranges::none_of(part.island.rods,
                              [&](int rod) { return jerks(system, state, system.rods[rod]); });
}

bool overlaps(const System& system, const Contact& c, double share) {
  return c.gap < -share * contact_scale(system, c);
}

bool overlaps(const System& system, const Island& island, double share) {
  return std::ranges::any_of(island.contacts,
                             [&](const Contact& c) { return overlaps(system, c, share); });
}

Island with_margins(const Restricted& part) {
  Island island = part.island;
  for (std::size_t k = 0; k < part.margins.size(); ++k)
    island.contacts[k].gap -= part.margins[k];
  return island;
}

void follow(const System& system, const State& state, std::vector<Contact>& contacts) {
  std::vector<Box> boxes;
  pose_boxes(system, state, boxes);
  for (Contact& c : contacts)
    c = at_poses(system, boxes, c);
}

IslandSolution nearest_place(const State& state,
                             const Restricted& part,
                             std::span<const Twist> targets,
                             IslandDynamics& dynamics,
                             Solves& unused) {
  if (!part.margins.empty()) {
    IslandSolution roomy = dynamics.correction(state, with_margins(part), part.use, targets);
    if (roomy.status == QpStatus::optimal) return roomy;
    // No room for the margins, perhaps: cubes that fit exactly between others.
    unused.count(roomy);
  }
  return dynamics.correction(state, part.island, part.use, targets);
}

Projection project_places(const System& system,
                          State state,
                          const ProjectionPolicy& policy,
                          const FindRestricted& find,
                          IslandDynamics& dynamics) {
  Projection result{std::move(state)};
  for (; result.rounds < policy.rounds; ++result.rounds) {
    bool corrected = false;
    for (Restricted& part : find(result)) {
      if (!misses(system, result.state, part, policy)) continue;
      const IslandSolution solution =
          correct(part, result.state, policy.contradiction, dynamics, result);
      result.solves.add(solution);
      if (policy.contradiction == Contradiction::leave && solution.status != QpStatus::optimal)
        continue;
      result.too_far = goes_too_far(part, solution);
      if (result.too_far) return result;
      take_over(part, solution, result);
      corrected = true;
    }
    if (!corrected) break;
    result.moved = true;
  }
  return result;
}

Projection project_velocities(const System& system,
                              State state,
                              const std::vector<Restricted>& parts,
                              Contradiction contradiction,
                              IslandDynamics& dynamics) {
  Projection result{std::move(state)};
  for (const Restricted& part : parts) {
    if (rests(system, result.state, part)) continue;
    const IslandSolution solution = dynamics.velocities(result.state, part.island, part.use);
    result.solves.add(solution);
    if (contradiction == Contradiction::leave && solution.status != QpStatus::optimal) continue;
    set_velocities(part.island, solution.twists, result.state);
    result.moved = true;
  }
  return result;
}

void project_places(ClosedContacts& closed, State& state) {
  const double* d = closed.nearest(state, Order::position).data();
  for (const int cube : closed.cubes()) {
    BodyState& s = state[cube];
    s.position += Vec2(d[0], d[1]);
    s.angle += d[2];
    d += 3;
  }
}

void project_velocities(ClosedContacts& closed, State& state) {
  const double* v = closed.nearest(state, Order::velocity).data();
  for (const int cube : closed.cubes()) {
    BodyState& s = state[cube];
    s.velocity = Vec2(v[0], v[1]);
    s.spin = v[2];
    v += 3;
  }
}

}  // namespace wuerfel
