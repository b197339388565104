#include "core/time/rattle_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace wuerfel {
namespace {

/// Overlap that may be left, as a share of the smaller side of a pair.
constexpr double overlap_share = 2e-10;

/// Gaps are kept open by so much, so that nothing like rounding is ever pushed out, or, in units of
/// its square, by what a step of Newton's method is expected to leave of an overlap. Both are
/// bounded by a share of the fall within a step: they must not be felt as a velocity.
constexpr double margin_share = 5e-11;
constexpr double margin_of_fall = 1e-6;
constexpr double margin_of_square = 4.0;
constexpr double square_of_fall = 1e-2;

// Shares of the smaller side of a pair.
constexpr double near_share = 1e-2;       ///< pairs that come nearer may be pushed into each other
constexpr double touching_share = 1e-8;   ///< nearer contacts take part in the velocity program
constexpr double pressed_share = 1e-3;    ///< those that were pressed do within this distance
constexpr double closable_share = 1e-4;   ///< gaps of pressed contacts that may be closed
constexpr double closed_overlap = 1e-11;  ///< gaps and overlap afterwards
constexpr double bent_share = 1e-11;      ///< what sides may miss after the first placement

constexpr int most_clean_ups = 8;
/// A clean-up looks at pairs nearer to each other than so many times the deepest overlap.
constexpr double pushed_times = 20.0;
constexpr double least_pushed_share = 1e-7;
/// Displacements beyond so many times the overlap are no clean-up any more.
constexpr double farthest_times = 100.0;
constexpr int most_halvings = 50;
constexpr int closings = 3;
constexpr double pressed_force = 1e-9;  ///< of the island's largest multiplier
/// Closing speeds beyond this many g h are impacts, not the load of a step, and beyond the second
/// leave a step of order one.
constexpr double impact_steps = 0.5;
constexpr double rough_steps = 3.0;

/// A step is as exact as its length allows, not as its programs are. Overlap is removed by steps of
/// Newton's method, which only have to get out of it.
constexpr ProgramTolerances tolerances{.impact = 1e-6, .correction = 1e-3, .placement = 1e-5};

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
    : system_(&system), dynamics_(system, settings, tolerances), closed_(system), near_(system) {}

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
  h_ = h;
  start_ = state;
  predicted_ = state;
  for (BodyState& s : predicted_) {
    s.position += h * (s.velocity + 0.5 * h * system_->gravity);
    s.angle += h * s.spin;
  }
  near_.begin(start_, h, scales_.gravity);
  overlap_left_ = 0.0;
  place(state, book);
  clean_up(state, book);
  return arrive(state, t + h, book);
}

/// Velocities at the end of the way from the start to `state`.
double RattleStepper::arrive(State& state, double t, Bookkeeping& book) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i].velocity = (state[i].position - start_[i].position) / h_ + 0.5 * h_ * system_->gravity;
    state[i].spin = (state[i].angle - start_[i].angle) / h_;
  }
  const std::size_t first_event = book.events.size();
  hit(state, t, book);
  estimate_error(state);
  const double rise = energy(*system_, state) - energy(*system_, start_);
  if (rise < 0.0 && book.events.size() > first_event) book.events[first_event].loss = -rise;
  return rise;
}

void RattleStepper::estimate_error(const State& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const BodyState& a = start_[i];
    const BodyState& b = state[i];
    const double radius = 0.5 * system_->body(static_cast<int>(i)).size.norm();
    const double change = (b.velocity - a.velocity).norm() + radius * std::abs(b.spin - a.spin);
    if (change > rough_steps * scales_.gravity * h_) continue;
    const Vec2 way = b.position - a.position - 0.5 * h_ * (a.velocity + b.velocity);
    const double turn = radius * (b.angle - a.angle - 0.5 * h_ * (a.spin + b.spin));
    sum += way.squaredNorm() + turn * turn;
  }
  error_ = std::sqrt(sum / static_cast<double>(state.size())) / scales_.length;
}

void RattleStepper::place(State& state, Bookkeeping& book) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i].position = predicted_[i].position;
    state[i].angle = predicted_[i].angle;
  }
  pressed_.clear();
  near_.find_towards(predicted_, near_share, contacts_);
  find_islands(*system_, contacts_, islands_);
  for (const Island& island : islands_)
    place_island(island, state, book);
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

/// Displacements that leave no overlap, to first order, nearest to `targets` or to none. Judged by
/// the overlap that is left at the end of the step, not by its residual.
IslandSolution RattleStepper::apart(Island island,
                                    const State& state,
                                    std::span<const Twist> targets,
                                    Bookkeeping& book) {
  use_.assign(island.contacts.size(), SideUse::inequality);
  const double fall = scales_.gravity * h_ * h_;
  const auto margin = [&](const Contact& c) {
    const double scale = contact_scale(*system_, c);
    return std::max(
        std::min(margin_share * scale, margin_of_fall * fall),
        std::min(margin_of_square * overlap_left_ * overlap_left_ * scale, square_of_fall * fall));
  };
  for (Contact& c : island.contacts)
    c.gap -= margin(c);
  IslandSolution solution = dynamics_.correction(state, island, use_, targets);
  ++book.cost.qp_solves;
  if (solution.status != QpStatus::infeasible) return solution;
  // No room for the margin, perhaps.
  for (Contact& c : island.contacts)
    c.gap += margin(c);
  ++book.cost.qp_solves;
  return dynamics_.correction(state, island, use_, targets);
}

void RattleStepper::note_pressed(const Island& island, const IslandSolution& solution) {
  const double largest = std::ranges::max(solution.forces);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (solution.forces[k] > pressed_force * largest)
      pressed_.push_back({island.contacts[k], solution.forces[k] / h_});
  }
}

/// How fast the contact closes at the start, in units of g h.
double RattleStepper::closing_speed(const Contact& contact) const {
  const double rate = gap_rate(contact, contact_velocity(*system_, start_, contact));
  return -rate / (scales_.gravity * h_);
}

void RattleStepper::place_island(const Island& island, State& state, Bookkeeping& book) {
  // Where free flight touches nothing there is nothing to solve.
  const bool free = std::ranges::none_of(island.contacts, [&](const Contact& c) {
    return at_poses(*system_, near_.end_boxes(), c).gap < 0.0;
  });
  if (free) {
    ++book.cost.skipped_certificate;
    return;
  }
  std::vector<Twist> targets;
  for (const int cube : island.cubes) {
    const auto i = static_cast<std::size_t>(cube);
    targets.push_back(
        {predicted_[i].position - start_[i].position, predicted_[i].angle - start_[i].angle});
  }
  const IslandSolution straight = apart(island, start_, targets, book);
  place_cubes(island, straight, state);
  // Where something is struck within the step its order is one anyway.
  const double largest = std::ranges::max(straight.forces);
  bool rough = false;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    rough = rough
            || (straight.forces[k] > pressed_force * largest
                && closing_speed(island.contacts[k]) > rough_steps);
  }
  if (rough) {
    note_pressed(island, straight);
  } else {
    bend(island, targets, straight, state, book);
  }
}

/// The placement once more: directions stay those of the start, gaps are measured where the cubes
/// have come. That makes the order two. Where these contradict one another the first place is as
/// good a start for the clean-up.
void RattleStepper::bend(const Island& island,
                         const std::vector<Twist>& targets,
                         const IslandSolution& straight,
                         State& state,
                         Bookkeeping& book) {
  pose_boxes(*system_, state, boxes_);
  const State moved = displacement_of(start_, state);
  Island bent = island;
  bool missed = false;
  for (std::size_t k = 0; k < bent.contacts.size(); ++k) {
    Contact& c = bent.contacts[k];
    const double gap = at_poses(*system_, boxes_, c).gap;
    const double reached = c.gap + gap_rate(c, contact_velocity(*system_, moved, c));
    missed = missed
             || (std::abs(gap - reached) > bent_share * contact_scale(*system_, c)
                 && (straight.forces[k] > 0.0 || gap < 0.0));
    c.gap += gap - reached;
  }
  if (!missed) {
    note_pressed(island, straight);
    return;
  }
  const IslandSolution solution = apart(bent, start_, targets, book);
  const bool found = solution.status == QpStatus::optimal;
  if (found) place_cubes(island, solution, state);
  note_pressed(island, found ? solution : straight);
}

double RattleStepper::measure_overlap(const State& state) {
  finder_.find(*system_, state, overlapping_, 0.0);
  return finder_.deepest().depth / finder_.deepest().scale;
}

/// Newton's method towards the nearest place without overlap. Each pair is kept apart by the side
/// that did so longest on the way from the start.
void RattleStepper::clean_up(State& state, Bookkeeping& book) {
  for (int round = 0; round <= most_clean_ups; ++round) {
    overlap_left_ = measure_overlap(state);
    if (overlap_left_ <= overlap_share || round == most_clean_ups) return;
    const double reach = std::clamp(pushed_times * overlap_left_, least_pushed_share, near_share);
    near_.find_at(state, reach, contacts_);
    find_islands(*system_, contacts_, islands_);
    for (const Island& island : islands_) {
      const bool off = std::ranges::any_of(island.contacts, [&](const Contact& c) {
        return c.gap < -overlap_share * contact_scale(*system_, c);
      });
      if (!off) continue;
      const IslandSolution solution = apart(island, state, {}, book);
      if (std::ranges::any_of(solution.twists, [&](const Twist& d) {
            return d.linear.norm() > farthest_times * overlap_left_ * scales_.length;
          }))
        return;
      displace(island, solution.twists, state);
      for (std::size_t k = 0; k < island.contacts.size(); ++k) {
        if (solution.forces[k] > 0.0) pressed_.push_back({island.contacts[k], 0.0});
      }
    }
  }
}

/// Halves the ways that cubes have come from the start, with all that is near them, until nothing
/// overlaps.
void RattleStepper::retreat(State& state) {
  for (int k = 1; k <= most_halvings; ++k) {
    overlap_left_ = measure_overlap(state);
    if (overlap_left_ <= overlap_share) return;
    std::vector<char> stuck(state.size(), 0);
    for (const Contact& c : overlapping_) {
      for (const int body : {c.on, c.from}) {
        if (system_->is_cube(body)) stuck[static_cast<std::size_t>(body)] = 1;
      }
    }
    near_.find_at(state, near_share, contacts_);
    find_islands(*system_, contacts_, islands_);
    const double share = k < most_halvings ? 0.5 : 0.0;
    for (const Island& island : islands_) {
      const bool stops = std::ranges::any_of(
          island.cubes, [&](int cube) { return stuck[static_cast<std::size_t>(cube)] != 0; });
      if (!stops) continue;
      for (const int cube : island.cubes) {
        const auto i = static_cast<std::size_t>(cube);
        state[i].position = start_[i].position + share * (state[i].position - start_[i].position);
        state[i].angle = start_[i].angle + share * (state[i].angle - start_[i].angle);
      }
    }
  }
  overlap_left_ = measure_overlap(state);
}

double RattleStepper::stop_short(State& state, double t, Bookkeeping& book) {
  retreat(state);
  return arrive(state, t + h_, book);
}

/// Where a cube is at `share` of a step. Between loads its acceleration is even, to the order of
/// the step. What is struck flies on until it is: the instant follows from the way it has come.
BodyState RattleStepper::between(const BodyState& from,
                                 const BodyState& to,
                                 double radius,
                                 double share) const {
  const Vec2 change = to.velocity - from.velocity;
  const double turn = radius * (to.spin - from.spin);
  const double square = change.squaredNorm() + turn * turn;
  const double load = rough_steps * scales_.gravity * h_;
  const Vec2 way = to.position - from.position;
  BodyState state = from;
  if (square <= load * load) {
    const double bend = 0.5 * share * (1.0 - share) * h_;
    state.position += share * way - bend * change;
    state.angle += share * (to.angle - from.angle) - bend * (to.spin - from.spin);
    state.velocity += share * change;
    state.spin += share * (to.spin - from.spin);
    return state;
  }
  const double flown =
      change.dot(way - h_ * to.velocity) + radius * turn * (to.angle - from.angle - h_ * to.spin);
  const double struck = std::clamp(-flown / (h_ * square), 0.0, 1.0);
  const double before = h_ * std::min(share, struck);
  const double after = h_ * std::max(share - struck, 0.0);
  // What these two ways miss of the whole one is made up for on the way.
  const Vec2 missed = way - h_ * (struck * from.velocity + (1.0 - struck) * to.velocity);
  const double missed_turn =
      to.angle - from.angle - h_ * (struck * from.spin + (1.0 - struck) * to.spin);
  state.position += before * from.velocity + after * to.velocity + share * missed;
  state.angle += before * from.spin + after * to.spin + share * missed_turn;
  if (share >= struck) {
    state.velocity = to.velocity;
    state.spin = to.spin;
  }
  return state;
}

State RattleStepper::look(const State& from, const State& to, double h, double share) {
  scales_ = scales_of(*system_, from);
  h_ = h;
  start_ = from;
  near_.begin(from, h, scales_.gravity);
  State state = from;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double radius = 0.5 * system_->body(static_cast<int>(i)).size.norm();
    state[i] = between(from[i], to[i], radius, share);
  }
  Bookkeeping aside;
  pressed_.clear();
  clean_up(state, aside);
  if (overlap_left_ > overlap_share) retreat(state);
  return state;
}

void RattleStepper::hit(State& state, double t, Bookkeeping& book) {
  finder_.find(*system_, state, contacts_, touching_share);
  note_overlap(finder_.deepest().depth, finder_.deepest().scale, book.audit);
  std::map<ContactId, Pressed> blows;
  for (const Contact& c : contacts_)
    blows.emplace(c.id(), Pressed{c, 0.0});
  for (const Pressed& p : pressed_) {
    const auto [blow, is_new] = blows.emplace(p.contact.id(), p);
    if (!is_new) {
      blow->second.impulse += p.impulse;
      continue;
    }
    const Contact now = at_poses(*system_, finder_.boxes(), p.contact);
    if (std::abs(now.gap) < pressed_share * contact_scale(*system_, now)) contacts_.push_back(now);
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
    for (std::size_t k = 0; k < island.contacts.size(); ++k)
      blows.at(island.contacts[k].id()).impulse += solution.forces[k];
  }
  for (const auto& [id, blow] : blows) {
    const Contact& c = blow.contact;
    if (blow.impulse <= 0.0 || closing_speed(c) <= impact_steps) continue;
    book.events.push_back({t, EventKind::impact, system_->body(c.on).name,
                           system_->body(c.from).name, c.point, blow.impulse, 0.0});
  }
}

void RattleStepper::close_gaps(State& state) {
  pose_boxes(*system_, state, boxes_);
  contacts_.clear();
  for (const Pressed& p : pressed_) {
    const Contact now = at_poses(*system_, boxes_, p.contact);
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
