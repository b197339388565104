#include "core/time/events/contact_law.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/impact.h"
#include "core/time/events/contact_changes.h"

namespace wuerfel {
namespace {

constexpr int most_separations = 4;
/// Overlap deeper than this share of the smaller side is removed.
constexpr double overlap_share = 1e-13;
/// After an impact a gap that opens more slowly than this share of V, and that the forces would
/// close again, is closed at once: it would rise by 5e-11 of the size and come back.
constexpr double bounce_speed = 1e-5;
/// A force and a gap's acceleration below these shares of the largest force and of g leave it open
/// which of them will be positive.
constexpr double undecided_force = 1e-6;
constexpr double undecided_acceleration = 1e-6;
/// How far the program looks ahead then, in units of L / V.
constexpr double peek_time = 1e-7;
/// A contact is closed if its gap's acceleration is below this share of g, or below the share that
/// rounding leaves of the largest force.
constexpr double closed_acceleration = 1e-9;
constexpr double closed_rounding = 1e-11;

IndexPair pair_of(const Contact& c) { return std::minmax(c.on, c.from); }

bool all_rest(const Island& island, const std::vector<char>& resting) {
  return std::ranges::all_of(island.cubes, [&](int cube) { return resting[cube] != 0; });
}

}  // namespace

ContactLaw::ContactLaw(const System& system, const MotionSettings& settings)
    : system_(&system), skips_(settings.skips), dynamics_(system, settings) {}

void ContactLaw::apply(
    State& state, double t, const ContactLimits& limits, Closure& closure, Bookkeeping& book) {
  limits_ = limits;
  scales_ = scales_of(*system_, state);
  closure.resting.resize(state.size(), 0);
  const std::vector<Contact> before = std::move(closure.closed);
  closure.closed.clear();
  closure.wedged = false;
  finder_.find(*system_, state, contacts_, limits.touching);
  note_overlap(finder_.deepest().depth, finder_.deepest().scale, book.audit);
  find_islands(*system_, contacts_, islands_);
  separate(state, closure.resting, book);
  const std::size_t first_event = book.events.size();
  // A cube that touches nothing any more does not rest.
  std::vector<char> touched(state.size(), 0);
  for (Island& island : islands_) {
    for (const int cube : island.cubes)
      touched[cube] = 1;
    if (all_rest(island, closure.resting)) {
      ++book.cost.skipped_rest;
      continue;
    }
    apply_island(island, state, t, closure, book);
  }
  const bool falls = !system_->gravity.isZero(0.0);
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (touched[i] != 0) continue;
    ++book.cost.skipped_free;
    closure.resting[i] = !falls && state[i].velocity.isZero(0.0) && state[i].spin == 0.0 ? 1 : 0;
  }
  log_changes(*system_, before, closure.closed, closure.resting, t, first_event, book);
}

void ContactLaw::apply_island(
    Island& island, State& state, double t, Closure& closure, Bookkeeping& book) {
  const bool rested =
      std::ranges::any_of(island.cubes, [&](int cube) { return closure.resting[cube] != 0; });
  for (const int cube : island.cubes)
    closure.resting[cube] = 0;
  const bool hit = closes(*system_, state, island);
  if (hit) strike(island, state, t, book);
  if (comes_to_rest(island, state, book)) {
    for (std::size_t k = 0; k < island.cubes.size(); ++k) {
      const int cube = island.cubes[k];
      closure.resting[cube] = 1;
      if (rested || t == 0.0) continue;
      const auto touching = std::ranges::find_if(
          island.contacts, [&](const Contact& c) { return c.on == cube || c.from == cube; });
      const int other = touching->on == cube ? touching->from : touching->on;
      book.events.push_back({t, EventKind::rest, system_->body(cube).name,
                             system_->body(other).name, touching->point, 0.0});
    }
    return;
  }
  const IslandSolution solution = settle_contacts(island, state, hit, book);
  closure.wedged = closure.wedged || solution.status == QpStatus::infeasible;
  find_closed(island, solution);
  settle_on_closed(island, state, book);
  close(island, closure);
}

bool ContactLaw::overlaps(const Contact& c) const {
  return c.gap < -overlap_share * contact_scale(*system_, c);
}

/// Removes what bodies overlap by, which is rounding, so that it cannot add up. A light body
/// between others may have to move by more than that, into what it did not touch before: then that
/// takes part as well.
void ContactLaw::separate(State& state, const std::vector<char>& resting, Bookkeeping& book) {
  if (std::ranges::none_of(contacts_, [&](const Contact& c) { return overlaps(c); })) return;
  const State start = state;
  for (int round = 0; round < most_separations; ++round) {
    for (Island& island : islands_) {
      if (all_rest(island, resting)) continue;
      if (std::ranges::none_of(island.contacts, [&](const Contact& c) { return overlaps(c); }))
        continue;
      use_.assign(island.contacts.size(), SideUse::inequality);
      const IslandSolution solution = dynamics_.correction(state, island, use_);
      ++book.cost.qp_solves;
      displace(island, solution.twists, state);
      follow(island, state);
    }
    if (!add_overlapping(state)) {
      if (round == 0) return;
      // What has been added stands apart from what else there is of its pair.
      finder_.find(*system_, state, contacts_, limits_.touching);
      find_islands(*system_, contacts_, islands_);
      return;
    }
    state = start;
    find_islands(*system_, contacts_, islands_);
    for (Island& island : islands_)
      follow(island, state);
  }
}

/// Adds contacts that overlap at `state` and have not been seen before; false where there are none.
bool ContactLaw::add_overlapping(const State& state) {
  std::vector<ContactId> known;
  for (const Contact& c : contacts_)
    known.push_back(c.id());
  std::ranges::sort(known);
  finder_.find(*system_, state, found_, limits_.touching);
  std::erase_if(found_, [&](const Contact& c) {
    return !overlaps(c) || std::ranges::binary_search(known, c.id());
  });
  contacts_.insert(contacts_.end(), found_.begin(), found_.end());
  return !found_.empty();
}

void ContactLaw::strike(const Island& island, State& state, double t, Bookkeeping& book) {
  const IslandSolution after = impact(*system_, state, island, dynamics_).after;
  keep_book(after, book);
  set_velocities(island, after.twists, state);
  const double least = after.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (after.forces[k] <= least) continue;
    book.events.push_back({t, EventKind::impact, system_->body(c.on).name,
                           system_->body(c.from).name, c.point, after.forces[k]});
  }
}

bool ContactLaw::comes_to_rest(const Island& island, State& state, Bookkeeping& book) {
  if (!skips_.rest) return false;
  std::vector<BodyState> moving;
  for (const int cube : island.cubes) {
    BodyState& s = state[cube];
    if (fastest_corner(system_->body(cube), s) > limits_.rest_speed * scales_.speed) return false;
    moving.push_back(s);
  }
  for (const int cube : island.cubes) {
    state[cube].velocity.setZero();
    state[cube].spin = 0.0;
  }
  use_.assign(island.contacts.size(), SideUse::inequality);
  const IslandSolution solution = dynamics_.accelerations(state, island, use_);
  keep_book(solution, book);
  if (accelerations_vanish(*system_, island, solution, scales_.gravity)) return true;
  for (std::size_t k = 0; k < island.cubes.size(); ++k)
    state[island.cubes[k]] = moving[k];
  return false;
}

IslandSolution ContactLaw::settle_contacts(const Island& island,
                                           const State& state,
                                           bool after_impact,
                                           Bookkeeping& book) {
  use_.clear();
  std::vector<double> rates;
  for (const Contact& c : island.contacts) {
    const double rate = gap_rate(c, contact_velocity(*system_, state, c));
    const bool rests = contact_motion(*system_, state, c) != ContactMotion::opening;
    const bool slow = after_impact && rate <= bounce_speed * scales_.speed;
    use_.push_back(rests || slow ? SideUse::inequality : SideUse::none);
    rates.push_back(rests ? 0.0 : rate);
  }
  IslandSolution solution = dynamics_.accelerations(state, island, use_);
  keep_book(solution, book);
  // What opens slowly and is not pressed keeps its velocity.
  for (bool dropped = true; dropped;) {
    dropped = false;
    const double largest = std::ranges::max(solution.forces);
    for (std::size_t k = 0; k < use_.size(); ++k) {
      if (use_[k] == SideUse::none || rates[k] == 0.0) continue;
      if (solution.forces[k] > undecided_force * largest) continue;
      use_[k] = SideUse::none;
      dropped = true;
    }
    if (dropped) {
      solution = dynamics_.accelerations(state, island, use_);
      keep_book(solution, book);
    }
  }
  double largest = std::ranges::max(solution.forces);
  for (const int cube : island.cubes)
    largest = std::max(largest, system_->body(cube).mass * scales_.gravity);
  bool undecided = false;
  for (std::size_t k = 0; k < use_.size(); ++k) {
    undecided = undecided
                || (use_[k] != SideUse::none && solution.forces[k] <= undecided_force * largest
                    && solution.slacks[k] <= undecided_acceleration * scales_.gravity);
  }
  return undecided ? peek(island, state, solution, use_, book) : solution;
}

IslandSolution ContactLaw::peek(const Island& island,
                                const State& state,
                                const IslandSolution& now,
                                std::span<const SideUse> use,
                                Bookkeeping& book) {
  const double dt = peek_time * scales_.time;
  State ahead = state;
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    BodyState& s = ahead[island.cubes[k]];
    const Twist& a = now.twists[k];
    s.position += dt * (s.velocity + 0.5 * dt * a.linear);
    s.angle += dt * (s.spin + 0.5 * dt * a.angular);
    s.velocity += dt * a.linear;
    s.spin += dt * a.angular;
  }
  Island moved = island;
  follow(moved, ahead);
  IslandSolution solution = dynamics_.accelerations(ahead, moved, use);
  keep_book(solution, book);
  return solution;
}

void ContactLaw::find_closed(const Island& island, const IslandSolution& solution) {
  double lightest = system_->body(island.cubes.front()).mass;
  for (const int cube : island.cubes)
    lightest = std::min(lightest, system_->body(cube).mass);
  const double limit = closed_acceleration * scales_.gravity
                       + closed_rounding * std::ranges::max(solution.forces) / lightest;
  closed_.clear();
  for (const double slack : solution.slacks)
    closed_.push_back(slack <= limit ? SideUse::equality : SideUse::inequality);
}

/// Closed contacts may still have gaps within what counts as touching, and open slowly. The smooth
/// phase makes both zero, which may not push other contacts into overlap or let them close: they
/// take part here, as inequalities.
void ContactLaw::settle_on_closed(Island& island, State& state, Bookkeeping& book) {
  if (std::ranges::find(closed_, SideUse::inequality) == closed_.end()) return;
  bool off = false;
  bool moving = false;
  for (std::size_t k = 0; k < closed_.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (closed_[k] != SideUse::equality) continue;
    off = off || std::abs(c.gap) > overlap_share * contact_scale(*system_, c);
    moving = moving || contact_motion(*system_, state, c) != ContactMotion::resting;
  }
  if (off) {
    const IslandSolution placed = dynamics_.correction(state, island, closed_);
    ++book.cost.qp_solves;
    if (placed.status == QpStatus::optimal) {
      displace(island, placed.twists, state);
      follow(island, state);
    }
  }
  if (!moving) return;
  const IslandSolution moved = dynamics_.velocities(state, island, closed_);
  ++book.cost.qp_solves;
  if (moved.status == QpStatus::optimal) set_velocities(island, moved.twists, state);
}

/// Contacts of an island whose cubes have been moved.
void ContactLaw::follow(Island& island, const State& state) const {
  std::vector<Box> boxes;
  pose_boxes(*system_, state, boxes);
  for (Contact& c : island.contacts)
    c = at_poses(*system_, boxes, c);
}

void ContactLaw::close(const Island& island, Closure& closure) const {
  std::vector<Contact> closed;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (closed_[k] == SideUse::equality) closed.push_back(island.contacts[k]);
  }
  for (std::size_t k = 0; k < closed.size(); ++k) {
    const Contact& c = closed[k];
    // The finder lists the two ends of a flush pair one after the other.
    if (k + 1 == closed.size() || pair_of(closed[k + 1]) != pair_of(c)
        || system_->body(c.from).kind == BodyKind::plane) {
      closure.closed.push_back(c);
      continue;
    }
    // Ends may lie close to each other: both corners of the shorter side on the line of the longer
    // one say the same and never do.
    const Contact& d = closed[++k];
    const auto both = [&](int on, int from, int corner, int side) {
      for (const int which : {corner, next_corner(corner)}) {
        Contact row;
        row.on = on;
        row.from = from;
        row.corner = which;
        row.side = side;
        closure.closed.push_back(at_poses(*system_, finder_.boxes(), row));
      }
    };
    // Side of c.from, and the side of c.on that lies on it.
    const int facing =
        d.from == c.from ? (next_corner(c.corner) == d.corner ? c.corner : d.corner) : d.side;
    const auto length = [&](int body, int side) {
      const Vec2& size = system_->body(body).size;
      return (side & 1) != 0 ? size.y() : size.x();
    };
    if (length(c.on, facing) <= length(c.from, c.side)) {
      both(c.on, c.from, facing, c.side);
    } else {
      both(c.from, c.on, c.side, facing);
    }
  }
}

}  // namespace wuerfel
