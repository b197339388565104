#include "core/time/events/instant.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/impact.h"
#include "core/dynamics/momentum_balance.h"
#include "core/dynamics/rod_jam.h"
#include "core/dynamics/rod_rows.h"
#include "core/time/events/contact_changes.h"
#include "core/time/events/corrections.h"
#include "core/time/rod_events.h"

namespace wuerfel {
namespace {

/// Removes overlap. What touched before it was removed still takes part, by whatever gap that has
/// opened.
void separate(double touching, std::vector<Island>& islands, Instant& now, Workspace& work) {
  OutOfOverlap apart = out_of_overlap(now.state, islands, now.modes.resting, touching, work);
  if (!apart.moved) return;
  now.state = std::move(apart.state);
  if (apart.pushed) {
    islands = islands_at(now.state, touching, work);
  } else {
    for (Island& island : islands)
      follow(*work.system, now.state, island.contacts);
  }
}

/// Adds what impulses (N s) of an island do to bodies that only stand (Body::stands), about their centres.
void add_pushes_to_standing(const System& system,
                            const Island& island,
                            const IslandSolution& solution,
                            std::map<int, Push>& pushes) {
  const auto add = [&](int body, const Vec2& place, const Vec2& p) {
    const Body& pushed = system.body(body);
    if (pushed.stands) pushes[body] += {p, det(place - pushed.box.center, p)};
  };
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (solution.forces[k] == 0.0) continue;
    const Vec2 p = impulse_at(c, solution, k);
    add(c.on, c.point, p);
    add(c.from, c.point, -p);
  }
}

/// Takes an impact over: its events, and what it does to fixed bodies and to those that only stand.
void add_impacts(const System& system,
                 const Island& island,
                 const Impact& hit,
                 double t,
                 EventKind kind,
                 Instant& now) {
  now.push += push_of(system, now.state, island, hit.after);
  add_pushes_to_standing(system, island, hit.after, now.blows);
  add_impact_events(system, island, hit.after, t, kind, now.events);
}

/// What the first rod of a cube joins it to: a body, or, where that is a place of the world, the rod.
const std::string& joined_to(const System& system, const Island& island, int cube) {
  for (const int number : island.rods) {
    const Rod& rod = system.rods[number];
    if (rod.i.body == cube) return end_name(system, rod, rod.j);
    if (rod.j.body == cube) return end_name(system, rod, rod.i);
  }
  return system.body(cube).name;
}

/// Events of rods whose velocities had to jump.
void add_jerks(const System& system,
               const Island& island,
               const State& before,
               const Impact& hit,
               double t,
               Instant& now) {
  for (std::size_t k = 0; k < island.rods.size(); ++k) {
    const Rod& rod = system.rods[island.rods[k]];
    if (!jerks(system, before, rod)) continue;
    now.events.push_back({t, EventKind::impact, end_name(system, rod, rod.i),
                          end_name(system, rod, rod.j), held_place(rod.i, before).p,
                          std::abs(hit.after.rods[k])});
  }
}

/// Velocities that rods cannot go on with are taken by an impact of the rods; whether there was one. At the start they are
/// an error of the scene.
bool jam_rods(const Island& island, double t, bool hits, Instant& now, Workspace& work) {
  if (island.rods.size() < 2 || t == 0.0) return false;
  const System& system = *work.system;
  const RodJam jam = rod_jam(system, now.state, island);
  if (jam.rods.empty()) return false;
  work.solves.add(jam.hit.after);
  if (!hits) now.contradicting = jam.rods;
  const State before = now.state;
  set_velocities(island, jam.hit.after.twists, now.state);
  add_jam_events(system, before, now.state, jam.rods, t, now.events);
  add_impacts(system, island, jam.hit, t, EventKind::jam, now);
  // Rods in one line that take a blow across them pull at fixed places with impulses that no first order tells.
  if (std::ranges::any_of(island.rods, [&](int rod) { return is_held(system.rods[rod]); })) {
    const Push known = push_of(system, before, island, jam.hit.after);
    now.push += unexplained(system, before, now.state, 0.0, known);
  }
  return true;
}

void add_rest(const System& system, const Island& island, int cube, double t, Instant& now) {
  const auto touching = std::ranges::find_if(
      island.contacts, [&](const Contact& c) { return c.on == cube || c.from == cube; });
  if (touching == island.contacts.end()) {
    const Vec2 place = now.state[cube].position;
    const std::string other = joined_to(system, island, cube);
    now.events.push_back({t, EventKind::rest, system.body(cube).name, other, place, 0.0});
    return;
  }
  const int other = touching->on == cube ? touching->from : touching->on;
  now.events.push_back(
      {t, EventKind::rest, system.body(cube).name, system.body(other).name, touching->point, 0.0});
}

/// What velocities have changed by beyond impulses: fixed bodies give it, where they are touched.
void note_settled(const System& system, const Island& island, const State& before, Instant& now) {
  if (is_fixed(system, island)) now.settled += unexplained(system, before, now.state);
}

/// Makes an island rest. That it does is an event where none of its cubes did before.
void stop(const System& system, const Island& island, double t, bool is_event, Instant& now) {
  const State before = now.state;
  for (const int cube : island.cubes) {
    stop(now.state[cube]);
    now.modes.resting[cube] = 1;
    if (is_event) add_rest(system, island, cube, t, now);
  }
  note_settled(system, island, before, now);
}

/// Puts the closed contacts of an island into the modes. `boxes`: all, of other islands anywhere.
void close(const Island& island,
           const IslandModes& modes,
           std::vector<Box>& boxes,
           Instant& now,
           const Workspace& work) {
  now.modes.wedged = now.modes.wedged || modes.wedged;
  for (const int cube : island.cubes) {
    const BodyState& s = now.state[cube];
    boxes[cube] = make_box(s.position, s.angle, work.system->body(cube).size);
  }
  ContactSet& closed = now.modes.closed;
  for (std::size_t k = 0; k < island.touches.size(); ++k) {
    const std::size_t before = closed.touches.size();
    add_closed_rows(*work.system, boxes, island.touches[k], island.contacts, modes.closed, closed);
    if (modes.sides.empty() || closed.touches.size() == before) continue;
    Touch& touch = closed.touches.back();
    touch.sticks = modes.sides[k].sticks;
    touch.slips = modes.sides[k].slips;
    touch.idle = modes.sides[k].idle;
    touch.anchor = place_along(*work.system, closed.contacts[touch.first]);
  }
}

/// Whether everything that touches stays closed and sticks, as after the last blow of a rocking block: openings of less
/// than the slowest bounces are all that moves then, and closed at once.
bool holds_still(const IslandModes& modes) {
  return !modes.sides.empty() && std::ranges::all_of(modes.closed, [](char c) { return c != 0; })
         && std::ranges::all_of(modes.sides, [](const SideMode& s) { return s.sticks; });
}

void happen_to(const Island& island,
               double t,
               const ContactLimits& limits,
               const Scales& scales,
               std::vector<Box>& boxes,
               Instant& now,
               Workspace& work) {
  const System& system = *work.system;
  const bool rested =
      std::ranges::any_of(island.cubes, [&](int cube) { return now.modes.resting[cube] != 0; });
  for (const int cube : island.cubes)
    now.modes.resting[cube] = 0;
  bool hits = closes(system, now.state, island);
  if (hits) {
    // The impulses of all the bounces that are left out are those of the weight meanwhile, so that nothing but the height
    // of the last ones is missing.
    const double slow = slowest_motion * scales.speed;
    const Impact hit = impact(system, now.state, island, slow, work.dynamics, work.friction);
    work.solves.add(hit.after);
    add_jerks(system, island, now.state, hit, t, now);
    set_velocities(island, hit.after.twists, now.state);
    add_impacts(system, island, hit, t, EventKind::impact, now);
  }
  hits = jam_rods(island, t, hits, now, work) || hits;
  if (rests(island, now.state, scales, limits, work)) {
    stop(system, island, t, !rested && t > 0.0, now);
  } else {
    IslandModes modes = find_modes(island, now.state, scales, hits, work);
    if (modes.wedged && rubs(system, island)) {
      const Impact hit = jam(system, now.state, island, work.friction);
      work.solves.add(hit.after);
      set_velocities(island, hit.after.twists, now.state);
      add_impacts(system, island, hit, t, EventKind::jam, now);
      modes = find_modes(island, now.state, scales, true, work);
    }
    const State before = now.state;
    onto_closed(island, modes.closed, now.state, work);
    note_settled(system, island, before, now);
    const ContactLimits after_last{limits.touching, slowest_motion};
    if (hits && holds_still(modes) && rests(island, now.state, scales, after_last, work)) {
      stop(system, island, t, !rested && t > 0.0, now);
    } else {
      close(island, modes, boxes, now, work);
    }
  }
}

}  // namespace

Instant happen(const State& state,
               double t,
               const FormerPhase& before,
               const ContactLimits& limits,
               Workspace& work) {
  const System& system = *work.system;
  const Scales scales = scales_of(system, state);
  Instant now;
  now.state = state;
  now.modes.resting = before.modes.resting;
  now.modes.resting.resize(state.size(), 0);
  std::vector<Island> islands = islands_at(state, limits.touching, work);
  now.deepest = work.finder.deepest();
  separate(limits.touching, islands, now, work);
  std::vector<Box> boxes(work.finder.boxes().begin(), work.finder.boxes().end());
  std::vector<char> touched(state.size(), 0);
  for (const Island& island : islands) {
    now.modes.touching.insert(now.modes.touching.end(), island.touches.begin(),
                              island.touches.end());
    for (const int cube : island.cubes)
      touched[cube] = 1;
    if (all_rest(island, now.modes.resting)) {
      ++now.skipped_rest;
    } else {
      happen_to(island, t, limits, scales, boxes, now, work);
    }
  }
  // A cube that touches nothing any more does not rest but where nothing pulls at it.
  const bool falls = !system.gravity.isZero(0.0);
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (touched[i] != 0) continue;
    ++now.skipped_free;
    now.modes.resting[i] = !falls && is_still(state[i]) ? 1 : 0;
  }
  if (before.known) add_contact_changes(system, before.modes, now.modes, t, now.events);
  return now;
}

void add_impact_events(const System& system,
                       const Island& island,
                       const IslandSolution& impulses,
                       double t,
                       EventKind kind,
                       std::vector<Event>& events) {
  const double least = impulses.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (impulses.forces[k] <= least) continue;
    events.push_back(
        {t, kind, system.body(c.on).name, system.body(c.from).name, c.point, impulses.forces[k]});
  }
}

void note_events(const Instant& now, Bookkeeping& book) {
  note_overlap(now.deepest.depth, now.deepest.scale, book.audit);
  book.cost.skipped_rest += now.skipped_rest;
  book.cost.skipped_free += now.skipped_free;
  for (const Event& e : now.events) {
    const auto later = std::ranges::upper_bound(book.events, e.t, {}, &Event::t);
    book.events.insert(later, e);
  }
}

void note_change(const System& system,
                 const State& before,
                 double t,
                 const Instant& now,
                 const State& after,
                 Bookkeeping& book) {
  book.settled += now.settled;
  book.unexplained += unexplained(system, before, after, 0.0, now.push + now.settled);
  // Impacts take energy, and so does what is put on closed contacts: of wedged cubes a lot. The gaps
  // closed then, some 1e-10 of a side, may lift cubes as well.
  const double loss = energy(system, before) - energy(system, after);
  const Scales scales = scales_of(system, after);
  const double lifted = touching_tolerance * scales.weight * scales.length;
  if (loss > -lifted) book.losses.push_back({t, loss, false, t});
}

}  // namespace wuerfel
