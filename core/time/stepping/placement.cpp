#include "core/time/stepping/placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/dynamics/contact_rows.h"
#include "core/dynamics/momentum.h"
#include "core/dynamics/rod_rows.h"

namespace wuerfel {
namespace {

constexpr double still_missed = 0.5;  ///< of what a first placement misses of the lengths of rods
constexpr int most_bends = 4;         ///< placements that follow the first one where rods hold
/// touching_share of islands that are placed once, which leaves gaps of the size of what the second placement would have
/// moved: to close them, by less than can be seen, hundreds of bodies that stand would have to be moved, step after step.
constexpr double touching_share_of_many = 1e-5;

/// How far the corner has slid along the side, along perp(normal), m.
double slip_of(const System& system, const Contact& start, const Contact& end) {
  if (system.body(start.from).kind == BodyKind::plane)
    return perp(start.normal).dot(end.point - start.point);
  return (start.alpha - end.alpha) * start.length;
}

}  // namespace

Placement::Placement(Workspace& work, OverlapRemoval& removal, const RestingIslands& resting)
    : system_(work.system), work_(&work), removal_(&removal), resting_(&resting) {}

/// To the place nearest to free flight, with the impulses that lead there.
State Placement::find(Stride& stride, Bookkeeping& book) {
  stride_ = &stride;
  State& half = stride_->half;
  for (BodyState& s : half)
    s.velocity += 0.5 * stride_->h * system_->gravity;
  State state = stride_->start;
  for (std::size_t i = 0; i < half.size(); ++i) {
    state[i].position += stride_->h * half[i].velocity;
    state[i].angle += stride_->h * half[i].spin;
  }
  const std::vector<Contact> near = removal_->near().find_towards(state, near_share);
  way_.boxes = removal_->near().start_boxes();
  way_.moved = stride_->start;
  for (const Island& island : find_islands(*system_, near))
    place_island(island, state, book);
  return state;
}

/// Displacements that keep the cubes of an island apart, against friction where they rub; `again`: gaps have been measured
/// anew.
IslandSolution Placement::apart(const Island& island,
                                const std::vector<Twist>& targets,
                                bool again,
                                Bookkeeping& book) {
  Restricted part = removal_->apart(island);
  if (rubs(*system_, island)) {
    // Gaps are neither opened nor closed against friction where bodies touch: staying put is to be possible, or there
    // may be no solution (a cube in a corner that rubs).
    const double share = is_placed_once(island) ? touching_share_of_many : touching_share;
    for (std::size_t k = 0; k < part.margins.size(); ++k) {
      const Contact& c = part.island.contacts[k];
      const double gap = gap_at_poses(*system_, removal_->near().start_boxes(), c);
      const bool touches = gap < share * contact_scale(*system_, c);
      part.margins[k] = touches ? gap : std::min(part.margins[k], gap);
    }
    IslandSolution solution =
        work_->friction.placement(stride_->start, with_margins(part), targets, again);
    keep_book(solution, book);
    return solution;
  }
  Solves solves;
  IslandSolution solution = nearest_place(stride_->start, part, targets, work_->dynamics, solves);
  solves.count(solution);
  keep_cost(solves, book);
  return solution;
}

/// Velocities between the halves, from the multipliers of a placement, and the places that they lead to.
void Placement::fly_half(const Island& island, const IslandSolution& solution, State& state) {
  for (const int cube : island.cubes) {
    stride_->half[cube].velocity =
        stride_->start[cube].velocity + 0.5 * stride_->h * system_->gravity;
    stride_->half[cube].spin = stride_->start[cube].spin;
  }
  const double least = solution.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (solution.forces[k] > least)
      push(*system_, c, impulse_at(c, solution, k) / stride_->h, stride_->half);
  }
  for (std::size_t k = 0; k < island.rods.size(); ++k) {
    double& impulse = stride_->rods_first[island.rods[k]];
    impulse = solution.rods[k] / stride_->h;
    push(*system_, system_->rods[island.rods[k]], impulse, stride_->start, stride_->half);
  }
  for (const int cube : island.cubes) {
    state[cube].position =
        stride_->start[cube].position + stride_->h * stride_->half[cube].velocity;
    state[cube].angle = stride_->start[cube].angle + stride_->h * stride_->half[cube].spin;
  }
}

void Placement::note_pressed(const Island& island, const IslandSolution& solution) {
  const double least = solution.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (solution.forces[k] > least)
      stride_->blows[c.id()] = {c, c, impulse_at(c, solution, k) / stride_->h, Vec2::Zero()};
  }
}

/// Contacts hold what gravity does.
void Placement::rest(const RestingIsland& island, State& state) {
  for (const int cube : island.cubes)
    state[cube] = stride_->half[cube] = stride_->start[cube];
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    stride_->blows[c.id()] = {c, c, 0.5 * stride_->h * island.forces[k], Vec2::Zero()};
  }
}

void Placement::place_island(const Island& island, State& state, Bookkeeping& book) {
  if (const RestingIsland* resting = resting_->skipped(island, stride_->start)) {
    rest(*resting, state);
    ++book.cost.skipped_rest;
    return;
  }
  // Where free flight touches nothing and no rod holds there is nothing to solve.
  const bool free =
      island.rods.empty() && std::ranges::none_of(island.contacts, [&](const Contact& c) {
        return gap_at_poses(*system_, removal_->near().end_boxes(), c) < 0.0;
      });
  if (free) {
    ++book.cost.skipped_certificate;
    return;
  }
  std::vector<Twist> targets;
  for (const int cube : island.cubes) {
    const BodyState& half = stride_->half[cube];
    targets.push_back({stride_->h * half.velocity, stride_->h * half.spin});
  }
  const IslandSolution straight = apart(island, targets, false, book);
  work_->friction.keep_if_missed(straight);
  fly_half(island, straight, state);
  // Where something is struck within the step its order is one anyway.
  const double least = straight.least_pressing();
  bool rough = false;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    rough = rough
            || (straight.forces[k] > least
                && closing_speed(*system_, *stride_, island.contacts[k]) > rough_steps);
  }
  if (rough) {
    note_pressed(island, straight);
  } else {
    bend(island, targets, straight, state, book);
  }
}

/// Rods of an island measured where the cubes have come; whether they miss their lengths there.
bool Placement::bend_rods(const State& end, Island& bent) const {
  bool missed = false;
  for (const int number : bent.rods) {
    const Rod& rod = system_->rods[number];
    const double way =
        rod_excess(rod, stride_->start) + rod_change(rod, stride_->start, way_.moved);
    bent.bends.push_back(rod_excess(rod, end) - way);
    missed = missed || !has_length(*system_, end, rod);
  }
  return missed;
}

/// Takes the way of an island's cubes over.
void Placement::note_way(const Island& island, const State& state) {
  for (const int cube : island.cubes) {
    const BodyState& from = stride_->start[cube];
    const BodyState& to = state[cube];
    way_.boxes[cube] = make_box(to.position, to.angle, system_->body(cube).size);
    way_.moved[cube].velocity = to.position - from.position;
    way_.moved[cube].spin = to.angle - from.angle;
  }
}

/// The placement once more: directions stay those of the start, gaps are measured where the cubes have come. That
/// makes the order two. Where these contradict one another, or Coulomb's law, the first place is as good a start for the
/// clean-up.
void Placement::bend(const Island& island,
                     const std::vector<Twist>& targets,
                     const IslandSolution& straight,
                     State& state,
                     Bookkeeping& book) {
  note_way(island, state);
  const bool rubbing = rubs(*system_, island);
  Island bent = island;
  bool missed = bend_rods(state, bent);
  for (std::size_t k = 0; k < bent.contacts.size(); ++k) {
    Contact& c = bent.contacts[k];
    const Contact now = at_poses(*system_, way_.boxes, c);
    const ContactVelocity way = contact_velocity(*system_, way_.moved, c);
    const double gap = now.gap - (c.gap + gap_rate(c, way));
    const double slip =
        rubbing ? slip_of(*system_, c, now) - slip_rate(*system_, way_.moved, c) : 0.0;
    missed = missed
             || (std::max(std::abs(gap), std::abs(slip)) > closed_gap * contact_scale(*system_, c)
                 && (straight.forces[k] > 0.0 || now.gap < 0.0));
    c.gap += gap;
    c.slip += slip;
  }
  if (!missed) {
    note_pressed(island, straight);
    return;
  }
  IslandSolution placed = straight;
  const double missed_first = worst_of(state, island.rods);
  // Once for contacts; rods until they have their lengths, for no velocity knows of what the clean-up changes.
  for (int k = 0; k < most_bends && (k == 0 || bend_more(state, bent)); ++k) {
    Bookkeeping tried;
    IslandSolution solution = apart(bent, targets, true, tried);
    const bool solved = solution.status == QpStatus::optimal;
    if (!solved) tried.audit = {};
    add(tried, book);
    if (!solved) break;
    fly_half(island, solution, state);
    placed = std::move(solution);
  }
  note_pressed(island, placed);
  if (worst_of(state, island.rods) > std::max(jammed_share, still_missed * missed_first))
    stride_->jammed.insert(stride_->jammed.end(), island.rods.begin(), island.rods.end());
}

/// The largest error of some rods.
double Placement::worst_of(const State& state, const std::vector<int>& rods) const {
  double worst = 0.0;
  for (const int rod : rods)
    worst = std::max(worst, rod_error(*system_, state, system_->rods[rod]));
  return worst;
}

/// What rods of a bent island still miss where the cubes have come; whether any does.
bool Placement::bend_more(const State& end, Island& bent) const {
  bool missed = false;
  for (std::size_t k = 0; k < bent.rods.size(); ++k) {
    const Rod& rod = system_->rods[bent.rods[k]];
    bent.bends[k] += rod_excess(rod, end);
    missed = missed || !has_length(*system_, end, rod);
  }
  return missed;
}

}  // namespace wuerfel
