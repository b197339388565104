#include "core/time/rattle_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wuerfel {
namespace {

// Shares of the smaller side of a pair.
constexpr double overlap_share = 1e-10;   ///< overlap that is left
constexpr double touching_share = 1e-8;   ///< nearer contacts take part in the velocity program
constexpr double pressed_share = 1e-3;    ///< those that were pressed do within this distance
constexpr double closable_share = 1e-4;   ///< gaps of pressed contacts that may be closed
constexpr double closed_overlap = 1e-11;  ///< gaps and overlap afterwards
/// Corners that are past the end of a side by more than this share of it are not held back by it.
constexpr double beyond_end = 0.1;
constexpr int most_clean_ups = 11;
constexpr int closings = 3;
constexpr double pressed_force = 1e-9;  ///< of the island's largest multiplier
/// Closing speeds beyond this many g h are impacts, not the load of a step.
constexpr double impact_steps = 3.0;

/// A state whose velocities are the displacement from one state to another: what rows times a
/// displacement are read from.
State displacement_of(const State& from, const State& to) {
  State moved = from;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i].velocity = to[i].position - from[i].position;
    moved[i].spin = to[i].angle - from[i].angle;
  }
  return moved;
}

}  // namespace

RattleStepper::RattleStepper(const System& system, const MotionSettings& settings)
    : system_(&system), dynamics_(system, settings), closed_(system), near_(system) {}

double RattleStepper::longest_step(const State& state) const {
  double fastest = 0.0;
  double thinnest = std::numeric_limits<double>::max();
  for (int i = 0; i < system_->count(); ++i) {
    const Body& body = system_->body(i);
    if (body.kind == BodyKind::plane) continue;
    thinnest = std::min(thinnest, body.size.minCoeff());
    if (!system_->is_cube(i)) continue;
    const BodyState& s = state[static_cast<std::size_t>(i)];
    fastest = std::max(fastest, s.velocity.norm() + 0.5 * body.size.norm() * std::abs(s.spin));
  }
  // h (v + g h) = thinnest / 2, both bodies of a pair moving.
  const double g = system_->gravity.norm();
  const double reach = 0.25 * thinnest;
  if (g == 0.0) return fastest > 0.0 ? reach / fastest : std::numeric_limits<double>::infinity();
  return 2.0 * reach / (fastest + std::sqrt(fastest * fastest + 4.0 * g * reach));
}

double RattleStepper::step(State& state, double t, double h, Bookkeeping& book) {
  ++book.cost.steps;
  scales_ = scales_of(*system_, state);
  start_ = state;
  const double before = energy(*system_, state);
  State predicted = state;
  for (BodyState& s : predicted) {
    s.position += h * (s.velocity + 0.5 * h * system_->gravity);
    s.angle += h * s.spin;
  }
  near_.find(start_, predicted, h, scales_.gravity);
  place(state, predicted, h, book);
  clean_up(state, h, book);
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i].velocity = (state[i].position - start_[i].position) / h + 0.5 * h * system_->gravity;
    state[i].spin = (state[i].angle - start_[i].angle) / h;
  }
  const std::size_t first_event = book.events.size();
  hit(state, t + h, h, book);
  const double rise = energy(*system_, state) - before;
  if (rise < 0.0 && book.events.size() > first_event) book.events[first_event].loss = -rise;
  return rise;
}

void RattleStepper::place(State& state, const State& predicted, double h, Bookkeeping& book) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i].position = predicted[i].position;
    state[i].angle = predicted[i].angle;
  }
  pressed_.clear();
  find_islands(*system_, near_.contacts(), islands_);
  for (const Island& island : islands_)
    place_island(island, predicted, h, state, book);
}

/// Displacements are from the start.
void RattleStepper::place_cubes(const Island& island,
                                const IslandSolution& solution,
                                State& state) const {
  for (std::size_t m = 0; m < island.cubes.size(); ++m) {
    const auto i = static_cast<std::size_t>(island.cubes[m]);
    state[i].position = start_[i].position + solution.twists[m].linear;
    state[i].angle = start_[i].angle + solution.twists[m].angular;
  }
}

void RattleStepper::place_island(
    const Island& island, const State& predicted, double h, State& state, Bookkeeping& book) {
  // Where free flight touches nothing there is nothing to solve.
  const bool free = std::ranges::none_of(island.contacts, [&](const Contact& c) {
    return at_poses(*system_, near_.predicted_boxes(), c).gap < 0.0;
  });
  if (free) {
    ++book.cost.skipped_certificate;
    return;
  }
  std::vector<Twist> targets;
  for (const int cube : island.cubes) {
    const auto i = static_cast<std::size_t>(cube);
    targets.push_back(
        {predicted[i].position - start_[i].position, predicted[i].angle - start_[i].angle});
  }
  Island frozen = island;
  use_.assign(island.contacts.size(), SideUse::inequality);
  IslandSolution solution = dynamics_.correction(start_, frozen, use_, targets);
  keep_book(solution, book);
  place_cubes(island, solution, state);
  // Once more: directions stay those of the start, gaps are measured where the cubes have come.
  // Where these contradict one another the first place is as good a start for the clean-up.
  pose_boxes(*system_, state, end_boxes_);
  const State moved = displacement_of(start_, state);
  for (Contact& c : frozen.contacts) {
    const double gap = at_poses(*system_, end_boxes_, c).gap;
    c.gap = gap - gap_rate(c, contact_velocity(*system_, moved, c));
  }
  IslandSolution again = dynamics_.correction(start_, frozen, use_, targets);
  ++book.cost.qp_solves;
  if (again.status == QpStatus::optimal) {
    solution = std::move(again);
    place_cubes(island, solution, state);
  }
  const double largest = std::ranges::max(solution.forces);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (solution.forces[k] > pressed_force * largest)
      pressed_.push_back({island.contacts[k], solution.forces[k] / h});
  }
}

bool RattleStepper::overlaps(const std::vector<Box>& boxes, const Contact& c) const {
  if (c.gap >= -overlap_share * contact_scale(*system_, c)) return false;
  if (system_->body(c.from).kind == BodyKind::plane) return true;
  // Behind the line of a side, but perhaps beyond its end.
  return separation(boxes[static_cast<std::size_t>(c.on)], boxes[static_cast<std::size_t>(c.from)])
         < -overlap_share * contact_scale(*system_, c);
}

/// The short way: contacts that were pressed and corners that got in, all closed at once. Whether
/// it helped is seen by who looks for overlap next.
void RattleStepper::close_pressed(State& state, const std::vector<Contact>& found) {
  pose_boxes(*system_, state, end_boxes_);
  contacts_ = found;
  for (const Pressed& p : pressed_) {
    const Contact now = at_poses(*system_, end_boxes_, p.contact);
    const bool known = std::ranges::any_of(contacts_, [&](const Contact& d) {
      return std::minmax(d.on, d.from) == std::minmax(now.on, now.from) && d.id() == now.id();
    });
    if (!known && std::abs(now.gap) < pressed_share * contact_scale(*system_, now))
      contacts_.push_back(now);
  }
  closed_.close(contacts_, {});
  closed_.project_positions(state);
}

void RattleStepper::clean_up(State& state, double h, Bookkeeping& book) {
  std::vector<Contact> found;
  for (int round = 0; round < most_clean_ups; ++round) {
    // Pairs that only met because neighbours pushed them: their sides are chosen at the start,
    // where they did not overlap.
    finder_.find(*system_, state, found, 0.0);
    overlap_left_ = finder_.deepest().depth / finder_.deepest().scale;
    if (overlap_left_ <= overlap_share) return;
    if (round < closings) {
      close_pressed(state, found);
      continue;
    }
    for (const Contact& c : found) {
      if (system_->body(c.from).kind == BodyKind::plane) continue;
      const IndexPair pair = std::minmax(c.on, c.from);
      const bool known = std::ranges::any_of(near_.contacts(), [&](const Contact& d) {
        return IndexPair(std::minmax(d.on, d.from)) == pair;
      });
      if (!known) near_.add(pair, h);
    }
    pose_boxes(*system_, state, end_boxes_);
    contacts_.clear();
    for (const Contact& c : near_.contacts()) {
      const Contact now = at_poses(*system_, end_boxes_, c);
      const bool on_side = system_->body(c.from).kind == BodyKind::plane
                           || (now.alpha >= -beyond_end && now.alpha <= 1.0 + beyond_end);
      if (now.gap < pressed_share * contact_scale(*system_, c)
          && (now.gap >= 0.0 ? on_side : overlaps(end_boxes_, now)))
        contacts_.push_back(now);
    }
    // Another corner than the one that was nearest at the start may have got in.
    for (const Contact& c : found) {
      const bool known = std::ranges::any_of(contacts_, [&](const Contact& d) {
        return std::minmax(d.on, d.from) == std::minmax(c.on, c.from)
               && (d.id() == c.id() || overlaps(end_boxes_, d));
      });
      if (!known) contacts_.push_back(c);
    }
    find_islands(*system_, contacts_, islands_);
    for (const Island& island : islands_) {
      const bool off = std::ranges::any_of(
          island.contacts, [&](const Contact& c) { return overlaps(end_boxes_, c); });
      if (!off) continue;
      use_.assign(island.contacts.size(), SideUse::inequality);
      // Judged by the overlap that it leaves, which is measured.
      const IslandSolution solution = dynamics_.correction(state, island, use_);
      ++book.cost.qp_solves;
      displace(island, solution.twists, state);
    }
  }
  finder_.find(*system_, state, found, 0.0);
  overlap_left_ = finder_.deepest().depth / finder_.deepest().scale;
}

void RattleStepper::hit(State& state, double t, double h, Bookkeeping& book) {
  finder_.find(*system_, state, contacts_, touching_share);
  note_overlap(finder_.deepest().depth, finder_.deepest().scale, book.audit);
  std::vector<ContactId> known;
  for (const Contact& c : contacts_)
    known.push_back(c.id());
  std::ranges::sort(known);
  for (const Pressed& p : pressed_) {
    const Contact now = at_poses(*system_, finder_.boxes(), p.contact);
    if (std::abs(now.gap) < pressed_share * contact_scale(*system_, now)
        && !std::ranges::binary_search(known, now.id()))
      contacts_.push_back(now);
  }
  find_islands(*system_, contacts_, islands_);
  for (const Island& island : islands_) {
    const bool closing = std::ranges::any_of(island.contacts, [&](const Contact& c) {
      return contact_motion(*system_, state, c) == ContactMotion::closing;
    });
    if (!closing) continue;
    const IslandSolution solution = dynamics_.impact(state, island);
    keep_book(solution, book);
    set_velocities(island, solution.twists, state);
    log_hits(island, solution, t, h, book);
  }
}

void RattleStepper::log_hits(const Island& island,
                             const IslandSolution& solution,
                             double t,
                             double h,
                             Bookkeeping& book) const {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    const double rate = gap_rate(c, contact_velocity(*system_, start_, c));
    if (rate >= -impact_steps * scales_.gravity * h) continue;
    double impulse = solution.forces[k];
    for (const Pressed& p : pressed_) {
      if (p.contact.id() == c.id()) impulse += p.impulse;
    }
    if (impulse <= 0.0) continue;
    book.events.push_back({t, EventKind::impact, system_->body(c.on).name,
                           system_->body(c.from).name, c.point, impulse, 0.0});
  }
}

void RattleStepper::close_gaps(State& state) {
  pose_boxes(*system_, state, end_boxes_);
  contacts_.clear();
  for (const Pressed& p : pressed_) {
    const Contact now = at_poses(*system_, end_boxes_, p.contact);
    const bool on_side =
        system_->body(now.from).kind == BodyKind::plane || (now.alpha >= 0.0 && now.alpha <= 1.0);
    if (on_side && std::abs(now.gap) < closable_share * contact_scale(*system_, now))
      contacts_.push_back(now);
  }
  closed_.close(contacts_, {});
  State next = state;
  for (int k = 0; k < closings; ++k)
    closed_.project_positions(next);
  finder_.find(*system_, next, contacts_, 0.0);
  const bool apart = finder_.deepest().depth <= closed_overlap * finder_.deepest().scale;
  const bool closed = std::ranges::all_of(closed_.contacts(), [&](const Contact& c) {
    return std::abs(at_poses(*system_, finder_.boxes(), c).gap)
           <= closed_overlap * contact_scale(*system_, c);
  });
  if (apart && closed) state = std::move(next);
}

}  // namespace wuerfel
