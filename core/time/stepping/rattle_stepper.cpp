#include "core/time/stepping/rattle_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/dynamics/impact.h"

namespace wuerfel {
namespace {

// Shares of the smaller side of a pair.
constexpr double near_share = 1e-2;       ///< pairs that come nearer may be pushed into each other
constexpr double touching_share = 1e-8;   ///< nearer contacts take part in the velocity program
constexpr double pressed_share = 1e-3;    ///< those that were pressed do within this distance
constexpr double closable_share = 1e-4;   ///< gaps of pressed contacts that may be closed
constexpr double closed_overlap = 1e-11;  ///< gaps and overlap afterwards
constexpr double bent_share = 1e-11;      ///< what sides may miss after the first placement

constexpr int closings = 3;
/// Closing speeds beyond this many g h are impacts, not the load of a step.
constexpr double impact_steps = 0.5;

/// A step is as exact as its length allows, not as its programs are.
constexpr ProgramTolerances tolerances{.impact = 1e-6};

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
    : system_(&system),
      dynamics_(system, settings, tolerances),
      removal_(system, settings),
      closed_(system) {}

double RattleStepper::longest_step(const State& state) const {
  double fastest = 0.0;
  double thinnest = std::numeric_limits<double>::max();
  for (int i = 0; i < system_->count(); ++i) {
    const Body& body = system_->body(i);
    if (body.kind == BodyKind::plane) continue;
    thinnest = std::min(thinnest, body.size.minCoeff());
    if (!system_->is_cube(i)) continue;
    const BodyState& s = state[i];
    fastest = std::max(fastest, fastest_corner(body, s));
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
  removal_.begin(start_, h);
  place(state, book);
  contacts_.clear();
  removal_.clean_up(state, contacts_, book);
  for (const Contact& c : contacts_)
    pressed_.push_back({c, 0.0});
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
  if (rise < 0.0 && book.events.size() > first_event) {
    book.events.back().loss = -rise;
    book.events.back().lost_at = t;
  }
  return rise;
}

void RattleStepper::estimate_error(const State& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const BodyState& a = start_[i];
    const BodyState& b = state[i];
    const double radius = system_->bodies[i].radius();
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
  removal_.near().find_towards(predicted_, near_share, contacts_);
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

void RattleStepper::note_pressed(const Island& island, const IslandSolution& solution) {
  const double least = solution.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (solution.forces[k] > least)
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
    return at_poses(*system_, removal_.near().end_boxes(), c).gap < 0.0;
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
  const IslandSolution straight = removal_.apart(island, start_, targets, book);
  place_cubes(island, straight, state);
  // Where something is struck within the step its order is one anyway.
  const double least = straight.least_pressing();
  bool rough = false;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    rough =
        rough || (straight.forces[k] > least && closing_speed(island.contacts[k]) > rough_steps);
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
  const IslandSolution solution = removal_.apart(bent, start_, targets, book);
  const bool found = solution.status == QpStatus::optimal;
  if (found) place_cubes(island, solution, state);
  note_pressed(island, found ? solution : straight);
}

double RattleStepper::stop_short(State& state, double t, Bookkeeping& book) {
  removal_.retreat(state);
  return arrive(state, t + h_, book);
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
    if (!closes(*system_, state, island)) continue;
    const IslandSolution solution = impact(*system_, state, island, dynamics_).after;
    keep_book(solution, book);
    set_velocities(island, solution.twists, state);
    for (std::size_t k = 0; k < island.contacts.size(); ++k)
      blows.at(island.contacts[k].id()).impulse += solution.forces[k];
  }
  const std::size_t first = book.events.size();
  for (const auto& [id, blow] : blows) {
    const Contact c = at_poses(*system_, removal_.near().start_boxes(), blow.contact);
    const double speed = closing_speed(c);
    if (blow.impulse <= 0.0 || speed <= impact_steps) continue;
    // Where the gap closes at the speed of the start.
    const double flight = std::clamp(c.gap / (speed * scales_.gravity * h_), 0.0, h_);
    book.events.push_back({t - h_ + flight, EventKind::impact, system_->body(c.on).name,
                           system_->body(c.from).name, blow.contact.point, blow.impulse, 0.0});
  }
  std::stable_sort(book.events.begin() + static_cast<std::ptrdiff_t>(first), book.events.end(),
                   [](const Event& a, const Event& b) { return a.t < b.t; });
}

bool RattleStepper::is_near(const Contact& c, double share) const {
  const bool on_side =
      system_->body(c.from).kind == BodyKind::plane || (c.alpha >= 0.0 && c.alpha <= 1.0);
  return on_side && std::abs(c.gap) < share * contact_scale(*system_, c);
}

std::vector<Contact> RattleStepper::loaded() const {
  std::vector<Contact> loaded;
  for (const Pressed& p : pressed_) {
    const Contact now = at_poses(*system_, finder_.boxes(), p.contact);
    if (p.impulse > 0.0 && is_near(now, pressed_share)) loaded.push_back(now);
  }
  return loaded;
}

void RattleStepper::close_gaps(State& state) {
  pose_boxes(*system_, state, boxes_);
  contacts_.clear();
  for (const Pressed& p : pressed_) {
    const Contact now = at_poses(*system_, boxes_, p.contact);
    if (is_near(now, closable_share)) contacts_.push_back(now);
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
