#include "core/time/events/contact_modes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/dynamics/instant_friction.h"
#include "core/dynamics/projection.h"
#include "core/dynamics/verdict.h"

namespace wuerfel {
namespace {

/// After an impact a gap that opens more slowly than this share of V, and that the forces would
/// close again, is closed at once: it would rise by 5e-11 of the size and come back.
constexpr double bounce_speed = 1e-5;
/// A force and a gap's acceleration below this share of the largest force and of g leave it open
/// which of them will be positive.
constexpr double undecided_share = 1e-6;
/// How far the program looks ahead then, in units of L / V.
constexpr double peek_time = 1e-7;

IslandSolution accelerations(const Island& island,
                             const State& state,
                             std::span<const SideUse> use,
                             Workspace& work) {
  IslandSolution solution =
      rubs(*work.system, island) ? work.friction.accelerations(
          state, island, use, known_slips(*work.system, state, island, rate_tolerance))
                                 : work.dynamics.accelerations(state, island, use);
  // Accelerations that cannot be found exactly are those of cubes that are all but wedged: the group is stepped,
  // for positions know what happens next.
  if (solution.status == QpStatus::inaccurate && !solution.friction_inexact)
    solution.status = QpStatus::infeasible;
  work.solves.add(solution);
  return solution;
}

/// Gauss' principle over the contacts that do not open. `use` says which these are; what opens
/// slowly and is not pressed keeps its velocity.
IslandSolution drop_slow_openings(const Island& island,
                                  const State& state,
                                  const Scales& scales,
                                  bool after_impact,
                                  std::vector<SideUse>& use,
                                  Workspace& work) {
  std::vector<char> slow;
  for (const Contact& c : island.contacts) {
    const double rate = gap_rate(c, contact_velocity(*work.system, state, c));
    const bool rests = contact_motion(*work.system, state, c) != ContactMotion::opening;
    slow.push_back(!rests && after_impact && rate <= bounce_speed * scales.speed ? 1 : 0);
    use.push_back(rests || slow.back() != 0 ? SideUse::inequality : SideUse::none);
  }
  IslandSolution solution = accelerations(island, state, use, work);
  for (bool dropped = true; dropped;) {
    dropped = false;
    for (std::size_t k = 0; k < use.size(); ++k) {
      if (use[k] == SideUse::none || slow[k] == 0) continue;
      if (solution.forces[k] > undecided_share * solution.largest_force()) continue;
      use[k] = SideUse::none;
      dropped = true;
    }
    if (dropped) solution = accelerations(island, state, use, work);
  }
  return solution;
}

/// Normal and tangential force of a touch.
std::pair<double, double> forces_on(const Touch& touch, const IslandSolution& solution) {
  double normal = 0.0;
  double along = 0.0;
  for (int k = touch.first; k < touch.first + touch.count; ++k) {
    normal += solution.forces[k];
    along += solution.tangential[k];
  }
  return {normal, along};
}

/// The contact of a touch that is nearest to staying closed: how fast others slip is not known where they open.
int staying(const Touch& touch, const IslandSolution& solution) {
  const auto first = solution.slacks.begin() + touch.first;
  return static_cast<int>(std::min_element(first, first + touch.count) - solution.slacks.begin());
}

/// How fast a touch begins to slip, m/s^2.
double begins_to_slip(const Touch& touch, const IslandSolution& solution) {
  return solution.slips[staying(touch, solution)];
}

/// Whether a touch that does not slip yet is just held, with all its friction.
bool is_just_held(const Touch& touch, const IslandSolution& solution, double force, double rate) {
  const auto [normal, along] = forces_on(touch, solution);
  const double margin = touch.surface.friction * normal - std::abs(along);
  return normal > force && margin <= force && std::abs(begins_to_slip(touch, solution)) <= rate;
}

/// Whether some contact neither presses nor opens, or neither sticks nor slips.
bool is_undecided(const Island& island,
                  const IslandSolution& solution,
                  std::span<const SideUse> use,
                  double gravity,
                  const System& system) {
  double largest = solution.largest_force();
  for (const int cube : island.cubes)
    largest = std::max(largest, system.body(cube).mass * gravity);
  for (std::size_t k = 0; k < use.size(); ++k) {
    if (use[k] != SideUse::none && solution.forces[k] <= undecided_share * largest
        && solution.slacks[k] <= undecided_share * gravity)
      return true;
  }
  return std::ranges::any_of(island.touches, [&](const Touch& touch) {
    return touch.surface.friction > 0.0 && use[staying(touch, solution)] != SideUse::none
           && is_just_held(touch, solution, undecided_share * largest, undecided_share * gravity);
  });
}

/// The same program after dt s.
IslandSolution peek(const Island& island,
                    const State& state,
                    const IslandSolution& now,
                    std::span<const SideUse> use,
                    double dt,
                    Workspace& work) {
  State ahead = state;
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    BodyState& s = ahead[island.cubes[k]];
    const Twist& a = now.twists[k];
    s.position += dt * (s.velocity + 0.5 * dt * a.linear);
    s.angle += dt * (s.spin + 0.5 * dt * a.angular);
    s.velocity += dt * a.linear;
    s.spin += dt * a.angular;
  }
  Island later = island;
  follow(*work.system, ahead, later.contacts);
  return accelerations(later, ahead, use, work);
}

/// What the touches of an island do along their sides: those that slip go on, the others stick
/// where they do not begin to slip faster than `limit`, m/s^2.
std::vector<SideMode> find_sides(const System& system,
                                 const State& state,
                                 const Island& island,
                                 const IslandSolution& solution,
                                 double limit) {
  const std::vector<int> known = known_slips(system, state, island, rate_tolerance);
  std::vector<SideMode> sides;
  for (const Touch& touch : island.touches) {
    SideMode mode{false, known[touch.first], false};
    const double begins = begins_to_slip(touch, solution);
    if (touch.surface.friction > 0.0 && mode.slips == 0) {
      mode.sticks = std::abs(begins) <= limit;
      if (!mode.sticks) mode.slips = begins > 0.0 ? 1 : -1;
    }
    mode.idle = mode.slips != 0
                && forces_on(touch, solution).first <= undecided_share * solution.largest_force();
    sides.push_back(mode);
  }
  return sides;
}

/// Asks of the islands that touch at a state and have closed contacts, with these as inequalities: rows of closed contacts stand for
/// sides, whose ends may be elsewhere by now.
template <class Predicate>
bool any_closed(const State& state,
                std::span<const Touch> closed,
                Workspace& work,
                const Predicate& predicate) {
  const auto is_closed = [&](const Contact& c) {
    return std::ranges::any_of(
        closed, [&](const Touch& t) { return t.pair() == IndexPair(std::minmax(c.on, c.from)); });
  };
  for (const Island& island : islands_at(state, ContactLimits{}.touching, work)) {
    std::vector<SideUse> use = resting_uses(*work.system, state, island);
    for (std::size_t k = 0; k < use.size(); ++k)
      if (!is_closed(island.contacts[k])) use[k] = SideUse::none;
    const bool any = std::ranges::find(use, SideUse::inequality) != use.end();
    if (any && predicate(island, use)) return true;
  }
  return false;
}

/// Whether a touch of the same bodies sticks.
bool sticks(std::span<const Touch> closed, const Touch& touch) {
  return std::ranges::any_of(closed,
                             [&](const Touch& t) { return t.sticks && t.pair() == touch.pair(); });
}

}  // namespace

std::vector<Island> islands_at(const State& state, double touching, Workspace& work) {
  const std::vector<Contact> contacts = work.finder.find(*work.system, state, touching);
  return find_islands(*work.system, contacts, work.finder.touches());
}

std::vector<SideUse> resting_uses(const System& system, const State& state, const Island& island) {
  std::vector<SideUse> use;
  for (const Contact& c : island.contacts) {
    const bool rests = contact_motion(system, state, c) == ContactMotion::resting;
    use.push_back(rests ? SideUse::inequality : SideUse::none);
  }
  return use;
}

IslandSolution accelerations_at(const Island& island, const State& state, Workspace& work) {
  return accelerations(island, state, resting_uses(*work.system, state, island), work);
}

IslandModes find_modes(const Island& island,
                       const State& state,
                       const Scales& scales,
                       bool after_impact,
                       Workspace& work) {
  std::vector<SideUse> use;
  IslandSolution solution = drop_slow_openings(island, state, scales, after_impact, use, work);
  // Where no accelerations exist what the solver leaves decides nothing.
  const bool exists = solution.status != QpStatus::infeasible;
  if (exists && is_undecided(island, solution, use, scales.gravity, *work.system))
    solution = peek(island, state, solution, use, peek_time * scales.time, work);
  double lightest = work.system->body(island.cubes.front()).mass;
  for (const int cube : island.cubes)
    lightest = std::min(lightest, work.system->body(cube).mass);
  // A contact is closed if its gap's acceleration is no fall, or what rounding leaves of the largest force.
  const double limit =
      falls_above * scales.gravity + force_rounding * solution.largest_force() / lightest;
  IslandModes modes;
  modes.wedged = solution.status == QpStatus::infeasible;
  for (const double slack : solution.slacks)
    modes.closed.push_back(slack <= limit ? 1 : 0);
  if (rubs(*work.system, island)) {
    modes.sides = find_sides(*work.system, state, island, solution, limit);
  }
  return modes;
}

bool drop_idle(ContactSet& closed) {
  ContactSet kept;
  for (Touch touch : closed.touches) {
    if (touch.idle) continue;
    const auto first = closed.contacts.begin() + touch.first;
    touch.first = static_cast<int>(kept.contacts.size());
    kept.contacts.insert(kept.contacts.end(), first, first + touch.count);
    kept.touches.push_back(touch);
  }
  const bool any = kept.touches.size() < closed.touches.size();
  closed = std::move(kept);
  return any;
}

bool rests(const Island& island,
           const State& state,
           const Scales& scales,
           const ContactLimits& limits,
           Workspace& work) {
  if (!work.skips.rest) return false;
  State still = state;
  for (const int cube : island.cubes) {
    BodyState& s = still[cube];
    if (fastest_corner(work.system->body(cube), s) > limits.rest_speed * scales.speed) return false;
    stop(s);
  }
  if (rubs(*work.system, island)) return work.friction.rests(still, island);
  const IslandSolution solution = accelerations(island, still, {}, work);
  return accelerations_vanish(*work.system, island, solution, scales.gravity);
}

bool would_rest(const State& state, const ContactLimits& limits, Workspace& work) {
  const System& system = *work.system;
  const Scales scales = scales_of(system, state);
  const std::vector<Island> islands = islands_at(state, limits.touching, work);
  std::size_t touching = 0;
  for (const Island& island : islands)
    touching += island.cubes.size();
  if (touching < state.size() && !system.gravity.isZero(0.0)) return false;
  return std::ranges::all_of(
      islands, [&](const Island& i) { return rests(i, state, scales, limits, work); });
}

bool would_open(const State& state, std::span<const Touch> closed, double most, Workspace& work) {
  std::vector<IndexPair> pairs;
  for (const Touch& touch : closed)
    pairs.push_back(touch.pair());
  std::ranges::sort(pairs);
  std::vector<Contact> contacts = work.finder.find(*work.system, state, ContactLimits{}.touching);
  std::erase_if(contacts, [&](const Contact& c) {
    return contact_motion(*work.system, state, c) != ContactMotion::resting
           || !std::ranges::binary_search(pairs, IndexPair(std::minmax(c.on, c.from)));
  });
  return std::ranges::any_of(find_islands(*work.system, contacts), [&](const Island& island) {
    if (island.contacts.empty()) return false;
    return std::ranges::max(accelerations(island, state, {}, work).slacks) > most;
  });
}

bool would_let_go(const State& state, const ContactSet& closed, double most, Workspace& work) {
  return any_closed(state, closed.touches, work, [&](const Island& island, const auto& use) {
    const IslandSolution solution = accelerations(island, state, use, work);
    for (std::size_t k = 0; k < use.size(); ++k)
      if (use[k] != SideUse::none && solution.slacks[k] > most) return true;
    return std::ranges::any_of(island.touches, [&](const Touch& touch) {
      return sticks(closed.touches, touch) && std::abs(begins_to_slip(touch, solution)) > most;
    });
  });
}

bool have_lawful_forces(const State& state,
                        const ContactSet& closed,
                        const std::function<Twist(int cube)>& acceleration,
                        double most,
                        Workspace& work) {
  return !any_closed(state, closed.touches, work, [&](const Island& island, const auto& use) {
    std::vector<Twist> accelerations;
    for (const int cube : island.cubes)
      accelerations.push_back(acceleration(cube));
    return !work.friction.bears(state, island, use,
                                known_slips(*work.system, state, island, rate_tolerance),
                                accelerations, most);
  });
}

}  // namespace wuerfel
