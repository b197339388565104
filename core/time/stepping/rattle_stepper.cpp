#include "core/time/stepping/rattle_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/dynamics/contact_rows.h"
#include "core/dynamics/impact.h"
#include "core/dynamics/momentum.h"
#include "core/dynamics/momentum_balance.h"

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
/// What the sway of a step takes from the energy is given back by no more than this factor on velocities.
constexpr double most_given_back = 1.01;

/// A step is as exact as its length allows, not as its programs are.
constexpr ProgramTolerances tolerances{.impact = 1e-6};

/// A state whose velocities are the displacement from one state to another: what rows times a displacement are
/// read from.
State displacement_of(const State& from, const State& to) {
  State moved = from;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i].velocity = to[i].position - from[i].position;
    moved[i].spin = to[i].angle - from[i].angle;
  }
  return moved;
}

/// What the contacts of a component take from its energy, J.
struct Balance {
  double friction = 0.0;  ///< along sides
  double closing = 0.0;   ///< those that close
  double lasting =
      0.0;  ///< those that were closed and stay so: the sway of the method, where nothing is struck
  double last_struck = -1.0;  ///< share of the step; none: -1
};

std::vector<Contact> contacts_of_fixed(const System& system, std::vector<Contact> contacts) {
  std::erase_if(contacts,
                [&](const Contact& c) { return system.is_cube(c.on) && system.is_cube(c.from); });
  return contacts;
}

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

double sum_of(const std::vector<StepLoss>& losses) {
  double sum = 0.0;
  for (const StepLoss& loss : losses)
    sum += loss.energy;
  return sum;
}

/// Makes the losses of single contacts, which are positive, add up to what is taken on balance.
void balance(const Balance& sums, std::vector<StepLoss>& losses) {
  const bool struck = sums.last_struck >= 0.0;
  const double total = std::max(0.0, sums.closing + (struck ? sums.lasting : 0.0));
  const double booked = sum_of(losses);
  if (total > booked) {
    losses.push_back({struck ? sums.last_struck : 1.0, total - booked, false});
  } else {
    for (StepLoss& loss : losses)
      loss.energy *= total / booked;
  }
}

}  // namespace

RattleStepper::RattleStepper(const System& system, const MotionSettings& settings, double sway)
    : system_(&system),
      dynamics_(system, settings, tolerances),
      friction_(system, settings),
      removal_(system, settings),
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
  // h (v + g h) = thinnest / 2, both bodies of a pair moving.
  const double g = system_->gravity.norm();
  const double reach = 0.25 * thinnest;
  if (g == 0.0) return fastest > 0.0 ? reach / fastest : std::numeric_limits<double>::infinity();
  return 2.0 * reach / (fastest + std::sqrt(fastest * fastest + 4.0 * g * reach));
}

Step RattleStepper::step(const State& state, double t, double h) {
  Step step;
  step.book.cost.steps = 1;
  scales_ = scales_of(*system_, state);
  h_ = h;
  start_ = state;
  removal_.begin(start_, h);
  place(step);
  flown_ = step.state;
  cleaned_.clear();
  removal_.clean_up(step.state, cleaned_, step.book);
  for (const Contact& c : cleaned_)
    blows_.emplace(c.id(), Blow{at_poses(*system_, removal_.near().start_boxes(), c), c});
  arrive(step, t);
  return step;
}

Step RattleStepper::stop_short(Step tried, double t) {
  Step step;
  step.book.cost = tried.book.cost;
  step.state = std::move(tried.state);
  for (auto& [id, blow] : blows_)
    blow.second.setZero();
  removal_.retreat(step.state);
  arrive(step, t);
  return step;
}

/// To the place nearest to free flight, with the impulses that lead there.
void RattleStepper::place(Step& step) {
  half_ = start_;
  for (BodyState& s : half_)
    s.velocity += 0.5 * h_ * system_->gravity;
  step.state = start_;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    step.state[i].position += h_ * half_[i].velocity;
    step.state[i].angle += h_ * half_[i].spin;
  }
  blows_.clear();
  removal_.near().find_towards(step.state, near_share, contacts_);
  find_islands(*system_, contacts_, islands_);
  for (const Island& island : islands_)
    place_island(island, step);
}

/// Displacements that keep the cubes of an island apart, against friction where they rub.
IslandSolution RattleStepper::apart(const Island& island,
                                    const std::vector<Twist>& targets,
                                    Step& step) {
  if (!rubs(*system_, island)) return removal_.apart(island, start_, targets, step.book);
  IslandSolution solution = friction_.placement(start_, removal_.with_margins(island), targets);
  keep_book(solution, step.book);
  return solution;
}

/// Velocities between the halves, from the multipliers of a placement, and the places that they lead to.
void RattleStepper::fly_half(const Island& island, const IslandSolution& solution, State& state) {
  for (const int cube : island.cubes) {
    half_[cube].velocity = start_[cube].velocity + 0.5 * h_ * system_->gravity;
    half_[cube].spin = start_[cube].spin;
  }
  const double least = solution.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (solution.forces[k] > least) push(*system_, c, impulse_at(c, solution, k) / h_, half_);
  }
  for (const int cube : island.cubes) {
    state[cube].position = start_[cube].position + h_ * half_[cube].velocity;
    state[cube].angle = start_[cube].angle + h_ * half_[cube].spin;
  }
}

void RattleStepper::note_pressed(const Island& island, const IslandSolution& solution) {
  const double least = solution.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (solution.forces[k] > least)
      blows_[c.id()] = {c, c, impulse_at(c, solution, k) / h_, Vec2::Zero()};
  }
}

/// How fast the contact closes at the start, in units of g h.
double RattleStepper::closing_speed(const Contact& contact) const {
  const double rate = gap_rate(contact, contact_velocity(*system_, start_, contact));
  return -rate / (scales_.gravity * h_);
}

void RattleStepper::place_island(const Island& island, Step& step) {
  // Where free flight touches nothing there is nothing to solve.
  const bool free = std::ranges::none_of(island.contacts, [&](const Contact& c) {
    return at_poses(*system_, removal_.near().end_boxes(), c).gap < 0.0;
  });
  if (free) {
    ++step.book.cost.skipped_certificate;
    return;
  }
  std::vector<Twist> targets;
  for (const int cube : island.cubes)
    targets.push_back({h_ * half_[cube].velocity, h_ * half_[cube].spin});
  const IslandSolution straight = apart(island, targets, step);
  fly_half(island, straight, step.state);
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
    bend(island, targets, straight, step);
  }
}

/// The placement once more: directions stay those of the start, gaps are measured where the cubes have come. That
/// makes the order two. Where these contradict one another the first place is as good a start for the clean-up.
void RattleStepper::bend(const Island& island,
                         const std::vector<Twist>& targets,
                         const IslandSolution& straight,
                         Step& step) {
  std::vector<Box> boxes;
  pose_boxes(*system_, step.state, boxes);
  const State moved = displacement_of(start_, step.state);
  const bool rubbing = rubs(*system_, island);
  Island bent = island;
  bool missed = false;
  for (std::size_t k = 0; k < bent.contacts.size(); ++k) {
    Contact& c = bent.contacts[k];
    const Contact now = at_poses(*system_, boxes, c);
    const ContactVelocity way = contact_velocity(*system_, moved, c);
    const double gap = now.gap - (c.gap + gap_rate(c, way));
    const double slip = rubbing ? slip_of(*system_, c, now) - slip_rate(*system_, moved, c) : 0.0;
    missed = missed
             || (std::max(std::abs(gap), std::abs(slip)) > bent_share * contact_scale(*system_, c)
                 && (straight.forces[k] > 0.0 || now.gap < 0.0));
    c.gap += gap;
    c.slip += slip;
  }
  if (!missed) {
    note_pressed(island, straight);
    return;
  }
  const IslandSolution solution = apart(bent, targets, step);
  const bool found = solution.status == QpStatus::optimal || solution.friction_inexact;
  if (found) fly_half(island, solution, step.state);
  note_pressed(island, found ? solution : straight);
}

/// Velocities and books at the end of the way.
void RattleStepper::arrive(Step& step, double t) {
  for (std::size_t i = 0; i < step.state.size(); ++i) {
    step.state[i].velocity = half_[i].velocity + 0.5 * h_ * system_->gravity;
    step.state[i].spin = half_[i].spin;
  }
  step.overlap = removal_.left();
  find_touching(step);
  keep_turning(*system_, cleaned_, flown_, step.state);
  if (system_->bounces) strike_anew(step);
  hit(step);
  step.error = error_of(step.state);
  StepRecord record;
  find_components(record);
  book_blows(step, record, t);
  const State unsettled = step.state;
  step.book.unexplained = unexplained(*system_, start_, unsettled, h_, pushed());
  settle_energy(record, step, t);
  const Push settled = unexplained(*system_, unsettled, step.state, 0.0, {});
  const bool fixed = std::ranges::any_of(
      record.components, [](const StepComponent& part) { return !part.fixed_normals.empty(); });
  (fixed ? step.book.settled : step.book.unexplained) += settled;
  step.record = std::make_shared<const StepRecord>(std::move(record));
}

/// What fixed bodies did in the step.
Push RattleStepper::pushed() const {
  const Vec2 start = common_center(*system_, start_);
  const Vec2 end = common_center(*system_, before_);
  Push sum;
  for (const auto& [id, blow] : blows_) {
    add_push(*system_, start_, start, blow.start, blow.first, sum);
    add_push(*system_, before_, end, blow.end, blow.second, sum);
  }
  return sum;
}

/// Contacts at the end of the way: what touches there, and what was pressed and is still near.
void RattleStepper::find_touching(Step& step) {
  finder_.find(*system_, step.state, contacts_, touching_share);
  note_overlap(finder_.deepest().depth, finder_.deepest().scale, step.book.audit);
  std::erase_if(contacts_, [&](const Contact& c) { return is_covered(*system_, c); });
  std::vector<ContactId> found;
  for (const Contact& c : contacts_)
    found.push_back(c.id());
  std::ranges::sort(found);
  for (auto& [id, blow] : blows_) {
    blow.end = at_poses(*system_, finder_.boxes(), blow.start);
    if (!std::ranges::binary_search(found, id)
        && std::abs(blow.end.gap) < pressed_share * contact_scale(*system_, blow.end))
      contacts_.push_back(blow.end);
  }
  for (const Contact& c : contacts_)
    blows_.emplace(c.id(), Blow{at_poses(*system_, removal_.near().start_boxes(), c), c});
}

/// What bounces is judged by the speed at which it closes: a blow that the placement has taken it from is left to the
/// impact law.
void RattleStepper::strike_anew(Step& step) {
  std::vector<ContactId> near;
  for (const Contact& c : contacts_)
    near.push_back(c.id());
  std::ranges::sort(near);
  for (auto& [id, blow] : blows_) {
    const bool bounces = system_->surface(blow.start.on, blow.start.from).restitution > 0.0;
    if (!bounces || blow.first.isZero(0.0) || closing_speed(blow.start) <= impact_steps
        || !std::ranges::binary_search(near, id))
      continue;
    push(*system_, blow.start, -blow.first, step.state);
    blow.first.setZero();
  }
}

/// The impact law over all that touches, one island after the other.
void RattleStepper::hit(Step& step) {
  find_islands(*system_, contacts_, islands_);
  before_ = step.state;
  const double slow = impact_steps * scales_.gravity * h_;
  for (const Island& island : islands_) {
    if (!closes(*system_, step.state, island)) continue;
    const IslandSolution after = rubs(*system_, island) || bounces(*system_, island)
                                     ? friction_.impact(step.state, island, slow)
                                     : impact(*system_, step.state, island, dynamics_).after;
    keep_book(after, step.book);
    const double least = after.least_pressing();
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const Contact& c = island.contacts[k];
      if (after.forces[k] <= least) continue;
      const Vec2 impulse = impulse_at(c, after, k);
      push(*system_, c, impulse, step.state);
      blows_.at(c.id()).second = impulse;
    }
  }
}

/// Cubes that pushed one another, and the fixed bodies that keep them.
void RattleStepper::find_components(StepRecord& record) {
  contacts_.clear();
  for (const auto& [id, blow] : blows_) {
    if (blow.acts()) contacts_.push_back(blow.end);
  }
  find_islands(*system_, contacts_, islands_);
  std::vector<int> component(start_.size(), -1);
  for (const Island& island : islands_) {
    for (const int cube : island.cubes)
      component[cube] = static_cast<int>(record.components.size());
    record.components.push_back({island.cubes, {}, {}});
  }
  for (const auto& [id, blow] : blows_) {
    const Contact& c = blow.end;
    if (system_->is_cube(c.on) && system_->is_cube(c.from)) continue;
    const int k = component[system_->is_cube(c.on) ? c.on : c.from];
    if (k < 0 || !(blow.acts() || is_near(c, touching_share))) continue;
    std::vector<Vec2>& normals = record.components[k].fixed_normals;
    if (normals.size() < 2) normals.push_back(c.normal);
  }
}

/// Work of a contact in both halves: what its impulses do against the mean velocities that they change, gravity
/// aside.
RattleStepper::Work RattleStepper::work(const Blow& blow, const State& end) const {
  Work sum;
  const auto add = [&](const Contact& c, const Vec2& p, const State& a, const State& b, Vec2 more) {
    if (p.isZero(0.0)) return;
    if (!system_->is_cube(c.on)) more = -more;
    if (system_->is_cube(c.on) && system_->is_cube(c.from)) more.setZero();
    const Vec2 v =
        0.5 * (relative_velocity(*system_, a, c) + relative_velocity(*system_, b, c)) + more;
    const Vec2 t = perp(c.normal);
    sum.normal += p.dot(c.normal) * v.dot(c.normal);
    sum.side += p.dot(t) * v.dot(t);
  };
  add(blow.start, blow.first, start_, half_, -0.25 * h_ * system_->gravity);
  add(blow.end, blow.second, before_, end, Vec2::Zero());
  return sum;
}

/// Whether the contact is closed at the start and does not close: its work is the sway of the method.
bool RattleStepper::lasts(const Blow& blow) const {
  return blow.start.gap <= touching_share * contact_scale(*system_, blow.start)
         && closing_speed(blow.start) <= impact_steps;
}

/// The share of the step at which a gap closes at the speed of the start; 1 where it closes more slowly than an
/// impact.
double RattleStepper::struck_at(const Blow& blow) const {
  const double speed = closing_speed(blow.start);
  if (speed <= impact_steps) return 1.0;
  return std::clamp(blow.start.gap / (speed * scales_.gravity * h_ * h_), 0.0, 1.0);
}

/// Impulses, and what they cost: contacts that close lose what their impulses take, on balance; in a component where
/// something is struck all contacts do, at the last blow.
void RattleStepper::book_blows(Step& step, StepRecord& record, double t) const {
  std::vector<int> component(start_.size(), -1);
  for (std::size_t k = 0; k < record.components.size(); ++k) {
    for (const int cube : record.components[k].cubes)
      component[cube] = static_cast<int>(k);
  }
  std::vector<Balance> balances(record.components.size());
  for (const auto& [id, blow] : blows_) {
    if (!blow.acts()) continue;
    const bool struck = closing_speed(blow.start) > impact_steps;
    const double share = struck_at(blow);
    record.impulses.push_back(impulse_of(blow, step.state, struck ? share : 0.0, share));
    const int k = component[system_->is_cube(blow.end.on) ? blow.end.on : blow.end.from];
    const Work done = work(blow, step.state);
    const double loss = -done.normal;
    balances[k].friction -= done.side;
    (lasts(blow) ? balances[k].lasting : balances[k].closing) += loss;
    if (!lasts(blow) && loss > 0.0) record.components[k].losses.push_back({share, loss, false});
    if (!struck) continue;
    balances[k].last_struck = std::max(balances[k].last_struck, share);
    step.book.events.push_back({t + share * h_, EventKind::impact, system_->body(blow.end.on).name,
                                system_->body(blow.end.from).name, blow.end.point,
                                (blow.first + blow.second).dot(blow.end.normal)});
  }
  for (std::size_t k = 0; k < balances.size(); ++k) {
    std::vector<StepLoss>& losses = record.components[k].losses;
    balance(balances[k], losses);
    if (system_->rubs && balances[k].friction > 0.0)
      losses.push_back({1.0, balances[k].friction, true});
  }
  std::stable_sort(step.book.events.begin(), step.book.events.end(),
                   [](const Event& a, const Event& b) { return a.t < b.t; });
}

StepImpulse RattleStepper::impulse_of(const Blow& blow,
                                      const State& end,
                                      double from,
                                      double to) const {
  const auto turn = [&](int body) {
    if (!system_->is_cube(body)) return 0.0;
    return det(blow.start.point - start_[body].position, blow.first)
           + det(blow.end.point - end[body].position, blow.second);
  };
  const Contact& c = blow.end;
  return {c.on, c.from, blow.first + blow.second, turn(c.on), -turn(c.from), from, to};
}

/// What contacts have taken is lost; what else has changed of a component's energy is put right as far as its
/// velocities allow. What they do not, for the clean-up may lift what stops on landing, is less of a loss.
void RattleStepper::settle_energy(StepRecord& record, Step& step, double t) const {
  const bool sways = sway_ > 0.0 && surplus_of(record, step) <= 0.0;
  double unpaid = 0.0;
  for (StepComponent& part : record.components) {
    const double lost = sum_of(part.losses);
    const double goal = energy_of(*system_, start_, part.cubes) - lost;
    step.rise += std::max(0.0, energy_of(*system_, step.state, part.cubes) - goal);
    double kept_back = 0.0;
    if (!sways) {
      const RigidMotion kept =
          kept_motion(momentum_of(*system_, step.state, part.cubes), part.fixed_normals);
      const double missing =
          scale_to_energy(*system_, part.cubes, kept, goal, most_given_back, step.state);
      kept_back = std::clamp(-missing, 0.0, lost);
      unpaid += std::max(0.0, -missing - kept_back);
    }
    for (StepLoss& loss : part.losses) {
      if (kept_back > 0.0) loss.energy *= 1.0 - kept_back / lost;
      step.book.losses.push_back({t + loss.share * h_, loss.energy, loss.friction, t});
    }
  }
  // What slides as a whole has no motion to pay with: others of the group do.
  for (const StepComponent& part : record.components) {
    if (unpaid <= 0.0) break;
    const RigidMotion kept =
        kept_motion(momentum_of(*system_, step.state, part.cubes), part.fixed_normals);
    const double goal = energy_of(*system_, step.state, part.cubes) - unpaid;
    unpaid = std::max(0.0, -scale_to_energy(*system_, part.cubes, kept, goal, 1.0, step.state));
  }
  std::stable_sort(step.book.losses.begin(), step.book.losses.end(),
                   [](const Loss& a, const Loss& b) { return a.t < b.t; });
}

/// By how much energy is more than it may sway, J.
double RattleStepper::surplus_of(const StepRecord& record, const Step& step) const {
  double allowed =
      true_energy_ + sway_ * (kinetic_energy(*system_, start_) + scales_.weight * scales_.length);
  for (const StepComponent& part : record.components)
    allowed -= sum_of(part.losses);
  return energy(*system_, step.state) - allowed;
}

void RattleStepper::accept(const Step& step) {
  for (const Loss& loss : step.book.losses)
    true_energy_ -= loss.energy;
}

double RattleStepper::error_of(const State& state) const {
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
  return std::sqrt(sum / static_cast<double>(state.size())) / scales_.length;
}

bool RattleStepper::is_near(const Contact& c, double share) const {
  const bool on_side =
      system_->body(c.from).kind == BodyKind::plane || (c.alpha >= 0.0 && c.alpha <= 1.0);
  return on_side && std::abs(c.gap) < share * contact_scale(*system_, c);
}

std::vector<Contact> RattleStepper::loaded() const {
  std::vector<Contact> loaded;
  for (const auto& [id, blow] : blows_) {
    if (!blow.first.isZero(0.0) && is_near(blow.end, pressed_share)) loaded.push_back(blow.end);
  }
  return loaded;
}

void RattleStepper::close_gaps(State& state) {
  std::vector<Box> boxes;
  pose_boxes(*system_, state, boxes);
  contacts_.clear();
  for (const auto& [id, blow] : blows_) {
    const Contact now = at_poses(*system_, boxes, blow.end);
    if (blow.acts() && is_near(now, closable_share)) contacts_.push_back(now);
  }
  closed_.close(contacts_, {});
  State next = state;
  for (int k = 0; k < closings; ++k)
    closed_.project_positions(next);
  keep_turning(*system_, contacts_, state, next);
  finder_.find(*system_, next, contacts_, 0.0);
  const bool apart = finder_.deepest().depth <= closed_overlap * finder_.deepest().scale;
  const bool closed = std::ranges::all_of(closed_.contacts(), [&](const Contact& c) {
    return std::abs(at_poses(*system_, finder_.boxes(), c).gap)
           <= closed_overlap * contact_scale(*system_, c);
  });
  if (!apart || !closed) return;
  // What the cubes were lifted by costs motion.
  std::vector<int> cubes(state.size());
  std::iota(cubes.begin(), cubes.end(), 0);
  std::vector<Vec2> normals;
  for (const Contact& c : contacts_of_fixed(*system_, closed_.contacts()))
    normals.push_back(c.normal);
  const RigidMotion kept = kept_motion(momentum_of(*system_, next, cubes), normals);
  const double goal = std::min(energy(*system_, state), energy(*system_, next));
  scale_to_energy(*system_, cubes, kept, goal, 1.0, next);
  state = std::move(next);
}

}  // namespace wuerfel
