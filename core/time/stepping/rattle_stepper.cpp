#include "core/time/stepping/rattle_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/dynamics/contact_rows.h"
#include "core/dynamics/impact.h"
#include "core/dynamics/momentum.h"
#include "core/dynamics/momentum_balance.h"
#include "core/dynamics/rod_rows.h"
#include "core/time/rod_events.h"
#include "core/time/stepping/close_gaps.h"
#include "core/time/stepping/step_books.h"

namespace wuerfel {
namespace {

// Shares of the smaller side of a pair.
constexpr double pressed_share =
    1e-3;  ///< contacts that were pressed take part in the velocity program up to here
constexpr double held_share = 1e-9;  ///< gaps up to here stay what they are where sides rub
/// Rods may contradict each other that a placement leaves farther off their lengths than this share of them, and than
/// this share of what the first one left.
constexpr double jammed_share = 1e-10;
constexpr double still_missed = 0.5;
constexpr int most_bends = 4;  ///< placements that follow the first one where rods hold

/// The impulse on the body of the corner.
Vec2 impulse_at(const Contact& c, const IslandSolution& solution, std::size_t k) {
  const double side = solution.tangential.empty() ? 0.0 : solution.tangential[k];
  return solution.forces[k] * c.normal + side * perp(c.normal);
}

/// How far the corner has slid along the side, along perp(normal), m.
double slip_of(const System& system, const Contact& start, const Contact& end) {
  if (system.body(start.from).kind == BodyKind::plane)
    return perp(start.normal).dot(end.point - start.point);
  return (start.alpha - end.alpha) * start.length;
}

}  // namespace

RattleStepper::RattleStepper(const System& system, const MotionSettings& settings, double sway)
    : system_(&system),
      work_(system, settings, step_tolerances),
      removal_(work_),
      closed_(system),
      sway_(sway) {}

double RattleStepper::longest_step(const State& state) const {
  double fastest = 0.0;
  double thinnest = std::numeric_limits<double>::max();
  for (int i = 0; i < system_->count(); ++i) {
    const Body& body = system_->body(i);
    thinnest = std::min(thinnest, body.smaller_side());
    if (system_->is_cube(i)) fastest = std::max(fastest, fastest_corner(body, state[i]));
  }
  if (system_->cubes == system_->points)
    thinnest = std::min(thinnest, scales_of(*system_, state).length);
  // h (v + g h) = thinnest / 2, both bodies of a pair moving.
  const double g = system_->gravity.norm();
  const double reach = 0.25 * thinnest;
  if (g == 0.0) return fastest > 0.0 ? reach / fastest : std::numeric_limits<double>::infinity();
  return 2.0 * reach / (fastest + std::sqrt(fastest * fastest + 4.0 * g * reach));
}

Step RattleStepper::step(const State& state, double t, double h) {
  Step step;
  step.book.cost.steps = 1;
  stride_ = {h, scales_of(*system_, state), state, state, {}, {}};
  stride_.rods_first.assign(system_->rods.size(), 0.0);
  stride_.rods_second.assign(system_->rods.size(), 0.0);
  removal_.begin(state, h);
  place(step);
  flown_ = step.state;
  cleaned_ = removal_.clean_up(step.state, step.book);
  add_blows(cleaned_);
  for (const Contact& c : cleaned_)
    stride_.blows.at(c.id()).cleaned = true;
  arrive(step, t);
  return step;
}

Step RattleStepper::stop_short(Step tried, double t) {
  Step step;
  step.book.cost = tried.book.cost;
  step.state = std::move(tried.state);
  for (auto& [id, blow] : stride_.blows) {
    blow.second.setZero();
    blow.taken_back = false;
  }
  std::ranges::fill(stride_.rods_second, 0.0);
  removal_.retreat(step.state);
  arrive(step, t);
  return step;
}

/// Contacts at the end of the way that have not acted so far.
void RattleStepper::add_blows(const std::vector<Contact>& contacts) {
  for (const Contact& c : contacts)
    stride_.blows.emplace(c.id(), Blow{at_poses(*system_, removal_.near().start_boxes(), c), c});
}

/// To the place nearest to free flight, with the impulses that lead there.
void RattleStepper::place(Step& step) {
  State& half = stride_.half;
  for (BodyState& s : half)
    s.velocity += 0.5 * stride_.h * system_->gravity;
  step.state = stride_.start;
  for (std::size_t i = 0; i < half.size(); ++i) {
    step.state[i].position += stride_.h * half[i].velocity;
    step.state[i].angle += stride_.h * half[i].spin;
  }
  std::vector<Contact> contacts;
  std::vector<Island> islands;
  removal_.near().find_towards(step.state, near_share, contacts);
  find_islands(*system_, contacts, islands);
  pose_boxes(*system_, stride_.start, way_.boxes);
  way_.moved = stride_.start;
  for (const Island& island : islands)
    place_island(island, step);
}

/// Displacements that keep the cubes of an island apart, against friction where they rub.
IslandSolution RattleStepper::apart(const Island& island,
                                    const std::vector<Twist>& targets,
                                    Bookkeeping& book) {
  Restricted part = removal_.apart(island);
  if (rubs(*system_, island)) {
    // Gaps are neither opened nor closed against friction where bodies touch: staying put is to be possible, or there
    // may be no solution (a cube in a corner that rubs).
    for (std::size_t k = 0; k < part.margins.size(); ++k) {
      const Contact start =
          at_poses(*system_, removal_.near().start_boxes(), part.island.contacts[k]);
      const bool touches = start.gap < held_share * contact_scale(*system_, start);
      part.margins[k] = touches ? start.gap : std::min(part.margins[k], start.gap);
    }
    IslandSolution solution = work_.friction.placement(stride_.start, with_margins(part), targets);
    keep_book(solution, book);
    return solution;
  }
  Solves solves;
  IslandSolution solution = nearest_place(stride_.start, part, targets, work_.dynamics, solves);
  solves.count(solution);
  keep_cost(solves, book);
  return solution;
}

/// Velocities between the halves, from the multipliers of a placement, and the places that they lead to.
void RattleStepper::fly_half(const Island& island, const IslandSolution& solution, State& state) {
  for (const int cube : island.cubes) {
    stride_.half[cube].velocity = stride_.start[cube].velocity + 0.5 * stride_.h * system_->gravity;
    stride_.half[cube].spin = stride_.start[cube].spin;
  }
  const double least = solution.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (solution.forces[k] > least)
      push(*system_, c, impulse_at(c, solution, k) / stride_.h, stride_.half);
  }
  for (std::size_t k = 0; k < island.rods.size(); ++k) {
    double& impulse = stride_.rods_first[island.rods[k]];
    impulse = solution.rods[k] / stride_.h;
    push(*system_, system_->rods[island.rods[k]], impulse, stride_.start, stride_.half);
  }
  for (const int cube : island.cubes) {
    state[cube].position = stride_.start[cube].position + stride_.h * stride_.half[cube].velocity;
    state[cube].angle = stride_.start[cube].angle + stride_.h * stride_.half[cube].spin;
  }
}

void RattleStepper::note_pressed(const Island& island, const IslandSolution& solution) {
  const double least = solution.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (solution.forces[k] > least)
      stride_.blows[c.id()] = {c, c, impulse_at(c, solution, k) / stride_.h, Vec2::Zero()};
  }
}

void RattleStepper::place_island(const Island& island, Step& step) {
  // Where free flight touches nothing and no rod holds there is nothing to solve.
  const bool free =
      island.rods.empty() && std::ranges::none_of(island.contacts, [&](const Contact& c) {
        return at_poses(*system_, removal_.near().end_boxes(), c).gap < 0.0;
      });
  if (free) {
    ++step.book.cost.skipped_certificate;
    return;
  }
  std::vector<Twist> targets;
  for (const int cube : island.cubes) {
    const BodyState& half = stride_.half[cube];
    targets.push_back({stride_.h * half.velocity, stride_.h * half.spin});
  }
  const IslandSolution straight = apart(island, targets, step.book);
  fly_half(island, straight, step.state);
  // Where something is struck within the step its order is one anyway.
  const double least = straight.least_pressing();
  bool rough = false;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    rough = rough
            || (straight.forces[k] > least
                && closing_speed(*system_, stride_, island.contacts[k]) > rough_steps);
  }
  if (rough) {
    note_pressed(island, straight);
  } else {
    bend(island, targets, straight, step);
  }
}

/// Rods of an island measured where the cubes have come; whether they miss their lengths there.
bool RattleStepper::bend_rods(const State& end, Island& bent) const {
  bool missed = false;
  for (const int number : bent.rods) {
    const Rod& rod = system_->rods[number];
    const double way = rod_excess(rod, stride_.start) + rod_change(rod, stride_.start, way_.moved);
    bent.bends.push_back(rod_excess(rod, end) - way);
    missed = missed || !has_length(*system_, end, rod);
  }
  return missed;
}

/// Takes the way of an island's cubes over.
void RattleStepper::follow(const Island& island, const State& state) {
  for (const int cube : island.cubes) {
    const BodyState& from = stride_.start[cube];
    const BodyState& to = state[cube];
    way_.boxes[cube] = make_box(to.position, to.angle, system_->body(cube).size);
    way_.moved[cube].velocity = to.position - from.position;
    way_.moved[cube].spin = to.angle - from.angle;
  }
}

/// The placement once more: directions stay those of the start, gaps are measured where the cubes have come. That
/// makes the order two. Where these contradict one another, or Coulomb's law, the first place is as good a start for the
/// clean-up.
void RattleStepper::bend(const Island& island,
                         const std::vector<Twist>& targets,
                         const IslandSolution& straight,
                         Step& step) {
  follow(island, step.state);
  const bool rubbing = rubs(*system_, island);
  Island bent = island;
  bool missed = bend_rods(step.state, bent);
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
  const double missed_first = worst_of(step.state, island.rods);
  // Once for contacts; rods until they have their lengths, for no velocity knows of what the clean-up changes.
  for (int k = 0; k < most_bends && (k == 0 || bend_more(step.state, bent)); ++k) {
    Bookkeeping tried;
    IslandSolution solution = apart(bent, targets, tried);
    const bool solved = solution.status == QpStatus::optimal;
    if (!solved) tried.audit = {};
    add(tried, step.book);
    if (!solved) break;
    fly_half(island, solution, step.state);
    placed = std::move(solution);
  }
  note_pressed(island, placed);
  if (worst_of(step.state, island.rods) > std::max(jammed_share, still_missed * missed_first))
    stride_.jammed.insert(stride_.jammed.end(), island.rods.begin(), island.rods.end());
}

/// The largest error of some rods.
double RattleStepper::worst_of(const State& state, const std::vector<int>& rods) const {
  double worst = 0.0;
  for (const int rod : rods)
    worst = std::max(worst, rod_error(*system_, state, system_->rods[rod]));
  return worst;
}

/// What rods of a bent island still miss where the cubes have come; whether any does.
bool RattleStepper::bend_more(const State& end, Island& bent) const {
  bool missed = false;
  for (std::size_t k = 0; k < bent.rods.size(); ++k) {
    const Rod& rod = system_->rods[bent.rods[k]];
    bent.bends[k] += rod_excess(rod, end);
    missed = missed || !has_length(*system_, end, rod);
  }
  return missed;
}

/// Velocities and books at the end of the way.
void RattleStepper::arrive(Step& step, double t) {
  for (std::size_t i = 0; i < step.state.size(); ++i) {
    step.state[i].velocity = stride_.half[i].velocity + 0.5 * stride_.h * system_->gravity;
    step.state[i].spin = stride_.half[i].spin;
  }
  step.overlap = removal_.left();
  if (!system_->rods.empty())
    step.book.audit.max_rod_error = largest_rod_error(*system_, step.state);
  find_touching(step);
  State flown = step.state;
  keep_turning(*system_, cleaned_, flown_, step.state);
  for (std::size_t i = 0; i < flown.size(); ++i) {
    flown[i].position = flown_[i].position;
    flown[i].angle = flown_[i].angle;
  }
  const Push cleaned = unexplained(*system_, flown, step.state, 0.0, {});
  stride_.before = step.state;
  if (system_->bounces) strike_anew(step);
  hit(step);
  step.error = error_of(step.state);
  StepRecord record = record_of(*system_, stride_, step.state);
  step.book.events = impacts_of(*system_, stride_, t);
  step.book.unexplained =
      unexplained(*system_, stride_.start, step.state, stride_.h, pushed()) + -1.0 * cleaned;
  settle(cleaned, record, step.book);
  jam(step, record, t);
  const bool sways = sway_ > 0.0 && !strays(record, step.state);
  const State unsettled = step.state;
  step.rise = settle_energy(*system_, stride_, sways, record, step.state);
  settle(unexplained(*system_, unsettled, step.state, 0.0, {}), record, step.book);
  for (const StepComponent& part : record.components) {
    for (const StepLoss& loss : part.losses)
      step.book.losses.push_back({t + loss.share * stride_.h, loss.energy, loss.friction, t});
  }
  std::ranges::stable_sort(step.book.losses, {}, &Loss::t);
  step.record = std::make_shared<const StepRecord>(std::move(record));
}

/// Books a change of momenta beyond the impulses: of fixed bodies, where they were touched.
void RattleStepper::settle(const Push& change, const StepRecord& record, Bookkeeping& book) {
  const bool fixed = std::ranges::any_of(
      record.components, [](const StepComponent& part) { return !part.fixed_normals.empty(); });
  (fixed ? book.settled : book.unexplained) += change;
}

/// What fixed bodies did in the step.
Push RattleStepper::pushed() const {
  const Vec2 start = common_center(*system_, stride_.start);
  const Vec2 end = common_center(*system_, stride_.before);
  Push sum;
  for (std::size_t k = 0; k < system_->rods.size(); ++k) {
    const Rod& rod = system_->rods[k];
    if (k < stride_.rods_first.size())
      add_push(stride_.start, start, rod, stride_.rods_first[k], sum);
    if (k < stride_.rods_second.size())
      add_push(stride_.before, end, rod, stride_.rods_second[k], sum);
  }
  for (const auto& [id, blow] : stride_.blows) {
    add_push(*system_, stride_.start, start, blow.start, blow.first, sum);
    add_push(*system_, stride_.before, end, blow.end, blow.second, sum);
  }
  return sum;
}

/// Contacts at the end of the way: what touches there, and what was pressed and is still near.
void RattleStepper::find_touching(Step& step) {
  work_.finder.find(*system_, step.state, contacts_, touching_share);
  note_overlap(work_.finder.deepest().depth, work_.finder.deepest().scale, step.book.audit);
  std::erase_if(contacts_, [&](const Contact& c) { return is_covered(*system_, c); });
  std::vector<ContactId> found;
  for (const Contact& c : contacts_)
    found.push_back(c.id());
  std::ranges::sort(found);
  for (auto& [id, blow] : stride_.blows) {
    blow.end = at_poses(*system_, work_.finder.boxes(), blow.start);
    if (!std::ranges::binary_search(found, id)
        && std::abs(blow.end.gap) < pressed_share * contact_scale(*system_, blow.end))
      contacts_.push_back(blow.end);
  }
  add_blows(contacts_);
}

/// What bounces is judged by the speed at which it closes: a blow that the placement has taken it from is left to the
/// impact law.
void RattleStepper::strike_anew(Step& step) {
  std::vector<ContactId> near;
  for (const Contact& c : contacts_)
    near.push_back(c.id());
  std::ranges::sort(near);
  const auto bounces = [&](const Contact& c) {
    const Contact& start = stride_.blows.at(c.id()).start;
    return system_->surface(start.on, start.from).restitution > 0.0
           && closing_speed(*system_, stride_, start) > impact_steps
           && std::ranges::binary_search(near, start.id());
  };
  std::vector<Island> islands;
  find_islands(*system_, acting(), islands);
  for (const Island& island : islands) {
    std::vector<Contact> bouncing = island.contacts;
    std::erase_if(bouncing, [&](const Contact& c) { return !bounces(c); });
    if (bouncing.empty()) continue;
    take_back(bouncing, step.state);
    // Without them others, as in a wedge, push too hard.
    if (is_faster_than_free(island, step.state)) take_back(island.contacts, step.state);
  }
}

/// Takes first impulses of an island back, where the cubes are now: both have that place in common, so that no turning
/// is left behind. Arms have turned since the start; so much of them is taken that the energy comes back that they took.
void RattleStepper::take_back(const std::vector<Contact>& contacts, State& state) {
  double due = 0.0;
  double linear = 0.0;
  State change(state.size());
  for (const Contact& c : contacts) {
    Blow& blow = stride_.blows.at(c.id());
    due -= first_work(*system_, stride_, blow).sum();
    linear -= blow.first.dot(relative_velocity(*system_, stride_.before, c));
    push(*system_, c, -blow.first, change);
  }
  // quadratic s^2 + linear s = due
  const double quadratic = kinetic_energy(*system_, change);
  const double root = linear * linear + 4.0 * quadratic * due;
  const double share =
      quadratic > 0.0 && root >= 0.0 ? (std::sqrt(root) - linear) / (2.0 * quadratic) : 1.0;
  for (const Contact& c : contacts) {
    Blow& blow = stride_.blows.at(c.id());
    push(*system_, c, -share * blow.first - blow.second, state);
    blow.second = -share * blow.first;
    blow.taken_back = true;
  }
}

/// Whether an island has more energy in motion than if nothing had touched it since the start.
bool RattleStepper::is_faster_than_free(const Island& island, const State& state) const {
  double has = 0.0;
  double free = 0.0;
  for (const int cube : island.cubes) {
    BodyState s = stride_.start[cube];
    s.velocity += stride_.h * system_->gravity;
    free += kinetic_energy(system_->body(cube), s);
    has += kinetic_energy(system_->body(cube), state[cube]);
  }
  return has > free;
}

/// The impact law over all that touches, one island after the other.
void RattleStepper::hit(Step& step) {
  std::vector<Island> islands;
  find_islands(*system_, contacts_, islands);
  const double slow = impact_steps * stride_.scales.gravity * stride_.h;
  for (const Island& island : islands) {
    if (!closes(*system_, step.state, island)) continue;
    const IslandSolution after = rubs(*system_, island) || bounces(*system_, island)
                                     ? work_.friction.impact(step.state, island, slow)
                                     : impact(*system_, step.state, island, work_.dynamics).after;
    keep_book(after, step.book);
    const double least = after.least_pressing();
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const Contact& c = island.contacts[k];
      if (after.forces[k] <= least) continue;
      const Vec2 impulse = impulse_at(c, after, k);
      push(*system_, c, impulse, step.state);
      stride_.blows.at(c.id()).second += impulse;
    }
    for (std::size_t k = 0; k < island.rods.size(); ++k) {
      stride_.rods_second[island.rods[k]] = after.rods[k];
      push(*system_, system_->rods[island.rods[k]], after.rods[k], stride_.before, step.state);
    }
  }
}

/// Where no placement led to the lengths of rods, velocities that they cannot go on with are taken at once. Where that
/// happens step after step forces drive what the rods hold.
void RattleStepper::jam(Step& step, StepRecord& record, double t) {
  if (stride_.jammed.empty()) return;
  std::vector<Island> islands;
  find_islands(*system_, contacts_, islands);
  for (const Island& island : islands) {
    if (std::ranges::find_first_of(stride_.jammed, island.rods) == stride_.jammed.end()) continue;
    RodJam jam = rod_jam(*system_, step.state, island);
    if (!jam.rods.empty()) {
      take_jam(island, jam, step, record);
    } else {
      jam.rods = stopping_rods(island, step.state);
    }
    if (jam.rods.empty()) continue;
    if (jam.rods == jammed_) note_contradiction(*system_, jam.rods, t, step.book);
    for (Event& e : jam_events(*system_, stride_.before, step.state, jam.rods, t + stride_.h))
      step.book.events.push_back(std::move(e));
    step.jammed.insert(step.jammed.end(), jam.rods.begin(), jam.rods.end());
  }
}

/// Rods that had lost their lengths and whose velocities at the end of the step jumped.
std::vector<int> RattleStepper::stopping_rods(const Island& island, const State& end) const {
  const auto jumps = [&](const RodEnd& at) {
    if (at.body < 0) return false;
    const double change = (end[at.body].velocity - stride_.before[at.body].velocity).norm();
    return change > rough_steps * stride_.scales.gravity * stride_.h;
  };
  std::vector<int> rods;
  for (const int number : island.rods) {
    const Rod& rod = system_->rods[number];
    const bool lost = rod_error(*system_, flown_, rod) > jammed_share;
    if (lost && (jumps(rod.i) || jumps(rod.j))) rods.push_back(number);
  }
  return rods;
}

void RattleStepper::take_jam(const Island& island,
                             const RodJam& jam,
                             Step& step,
                             StepRecord& record) {
  keep_book(jam.hit.after, step.book);
  const State before = step.state;
  set_velocities(island, jam.hit.after.twists, step.state);
  settle(unexplained(*system_, before, step.state, 0.0, {}), record, step.book);
  const auto mine = std::ranges::find_if(record.components, [&](const StepComponent& part) {
    return std::ranges::binary_search(part.cubes, island.cubes.front());
  });
  if (mine != record.components.end()) mine->losses.push_back({1.0, jam.hit.loss, false});
}

/// Whether energy is farther from its true value than it may sway.
bool RattleStepper::strays(const StepRecord& record, const State& end) const {
  const Scales& scales = stride_.scales;
  double astray = energy(*system_, end) - true_energy_;
  for (const StepComponent& part : record.components)
    astray += sum_of(part.losses);
  return std::abs(astray)
         > sway_ * (kinetic_energy(*system_, stride_.start) + scales.weight * scales.length);
}

void RattleStepper::accept(const Step& step) {
  jammed_ = step.jammed;
  for (const Loss& loss : step.book.losses)
    true_energy_ -= loss.energy;
}

double RattleStepper::error_of(const State& state) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const BodyState& a = stride_.start[i];
    const BodyState& b = state[i];
    const double radius = system_->bodies[i].radius();
    const double change = (b.velocity - a.velocity).norm() + radius * std::abs(b.spin - a.spin);
    if (change > rough_steps * stride_.scales.gravity * stride_.h) continue;
    const Vec2 way = b.position - a.position - 0.5 * stride_.h * (a.velocity + b.velocity);
    const double turn = radius * (b.angle - a.angle - 0.5 * stride_.h * (a.spin + b.spin));
    sum += way.squaredNorm() + turn * turn;
  }
  return std::sqrt(sum / static_cast<double>(state.size())) / stride_.scales.length;
}

std::vector<Contact> RattleStepper::loaded() const {
  std::vector<Contact> loaded;
  for (const auto& [id, blow] : stride_.blows) {
    if (!blow.first.isZero(0.0) && !blow.taken_back && is_near(*system_, blow.end, pressed_share))
      loaded.push_back(blow.end);
  }
  return loaded;
}

std::vector<Contact> RattleStepper::acting() const {
  std::vector<Contact> acting;
  for (const auto& [id, blow] : stride_.blows) {
    if (blow.acts()) acting.push_back(blow.end);
  }
  return acting;
}

void RattleStepper::close_gaps(State& state) {
  wuerfel::close_gaps(acting(), closed_, work_.finder, state);
}

}  // namespace wuerfel
