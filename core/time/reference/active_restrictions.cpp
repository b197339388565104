#include "core/time/reference/active_restrictions.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/forces_at.h"
#include "core/dynamics/impact.h"
#include "core/dynamics/momentum_balance.h"
#include "core/dynamics/rod_jam.h"
#include "core/time/rod_events.h"

namespace wuerfel {
namespace {

/// Nothing has changed about an island since its rest was certified: the forces are the same, too.
void keep_rest(GridPoint& point, const GridPoint& before) {
  std::size_t k = 0;
  for (std::size_t m = 0; m < point.islands.size(); ++m) {
    const Island& island = point.islands[m];
    if (!all_rest(island, point.resting)) continue;
    while (k < before.islands.size() && before.islands[k].cubes.front() < island.cubes.front())
      ++k;
    if (k == before.islands.size()) return;
    if (before.islands[k].cubes == island.cubes) point.solutions[m] = before.solutions[k];
  }
}

void strike_island(GridPoint& point,
                   const Island& island,
                   const std::vector<ContactId>& lasting,
                   Workspace& work,
                   Bookkeeping& book) {
  const auto [after, loss] = impact(*work.system, point.state, island, work.dynamics);
  keep_book(after, book);
  point.push += push_of(*work.system, point.state, island, after);
  set_velocities(island, after.twists, point.state);
  book.audit.impact_loss += loss;
  const double least = after.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    // A contact that lasts is struck in each step by the step's error; that is no event.
    if (after.forces[k] <= least || std::ranges::binary_search(lasting, c.id())) continue;
    book.events.push_back({point.t, EventKind::impact, work.system->body(c.on).name,
                           work.system->body(c.from).name, c.point, after.forces[k]});
  }
}

/// Velocities that rods cannot go on with are taken at once. Where that happens again and again, or nothing was struck,
/// forces go on to drive what the rods hold. `jammed`: rods of the grid time before. At the start they are an error of the
/// scene.
void jam_island(GridPoint& point,
                const Island& island,
                bool struck,
                const std::vector<int>& jammed,
                const System& system,
                Bookkeeping& book) {
  if (island.rods.size() < 2 || point.t == 0.0) return;
  const RodJam jam = rod_jam(system, point.state, island);
  if (jam.rods.empty()) return;
  keep_book(jam.hit.after, book);
  const State before = point.state;
  set_velocities(island, jam.hit.after.twists, point.state);
  point.push += unexplained(system, before, point.state);
  book.audit.impact_loss += jam.hit.loss;
  if (!struck || jam.rods == jammed) note_contradiction(system, jam.rods, point.t, book);
  add_jam_events(system, before, point.state, jam.rods, point.t, book.events);
  point.jammed.insert(point.jammed.end(), jam.rods.begin(), jam.rods.end());
}

/// Velocities that count as zero become zero, so that rest can be certified.
void stop_what_hardly_moves(const System& system, const Island& island, State& state) {
  for (const int cube : island.cubes) {
    const Body& body = system.body(cube);
    const double zero = rate_tolerance * std::sqrt(system.gravity.norm() * body.smaller_side());
    if (fastest_corner(body, state[cube]) > zero) return;
  }
  set_velocities(island, std::vector<Twist>(island.cubes.size()), state);
}

}  // namespace

void find_restrictions(GridPoint& point, Workspace& work, Bookkeeping& book) {
  const GridPoint before = std::move(point);
  point = {before.t, before.state, {}, {}, {}, before.push, before.resting, {}};
  point.resting.resize(work.system->cubes, 0);
  const std::vector<Contact> contacts = work.finder.find(*work.system, point.state);
  note_overlap(work.finder.deepest().depth, work.finder.deepest().scale, book.audit);
  point.islands = group_cubes(*work.system, contacts, work.skips);
  point.solutions.resize(point.islands.size());
  keep_rest(point, before);
  std::vector<ContactId> lasting;
  for (const Island& island : before.islands) {
    for (const Contact& c : island.contacts)
      lasting.push_back(c.id());
  }
  std::ranges::sort(lasting);
  for (const Island& island : point.islands) {
    if (all_rest(island, point.resting)) continue;
    // Who rested is awake where somebody came to it.
    for (const int cube : island.cubes)
      point.resting[cube] = 0;
    // (3) must hold where (2) = 0: an impact.
    const bool struck = closes(*work.system, point.state, island);
    if (struck) strike_island(point, island, lasting, work, book);
    jam_island(point, island, struck, before.jammed, *work.system, book);
    stop_what_hardly_moves(*work.system, island, point.state);
  }
}

void accelerate(GridPoint& point, Workspace& work, Bookkeeping& book) {
  if (!point.accelerations.empty()) return;
  point.accelerations.assign(work.system->cubes, {work.system->gravity, 0.0});
  book.cost.skipped_free += work.system->cubes;
  for (std::size_t m = 0; m < point.islands.size(); ++m) {
    const Island& island = point.islands[m];
    IslandSolution& solution = point.solutions[m];
    book.cost.skipped_free -= static_cast<long>(island.cubes.size());
    bool rests = !solution.twists.empty();  // as it did before
    if (rests) {
      ++book.cost.skipped_rest;
    } else {
      solution = work.dynamics.accelerations(point.state, island);
      keep_book(solution, book);
      rests = work.skips.rest && stands_still(island, point.state)
              && accelerations_vanish(*work.system, island, solution, work.system->gravity.norm());
    }
    for (std::size_t k = 0; k < island.cubes.size(); ++k) {
      point.resting[island.cubes[k]] = rests ? 1 : 0;
      point.accelerations[island.cubes[k]] = rests ? Twist{} : solution.twists[k];
    }
  }
}

}  // namespace wuerfel
