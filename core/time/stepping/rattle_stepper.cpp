#include "core/time/stepping/rattle_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/dynamics/momentum.h"
#include "core/dynamics/momentum_balance.h"
#include "core/dynamics/rod_rows.h"
#include "core/time/rod_events.h"
#include "core/time/stepping/close_gaps.h"
#include "core/time/stepping/step_books.h"

namespace wuerfel {
namespace {

/// Three quarters of what the books may be open by, which is a share of what was in motion at the beginning. Without rods energy
/// comes back from below by itself, but where more than this share of it is missing.
constexpr double most_missing = 0.75e-4;

}  // namespace

RattleStepper::RattleStepper(const System& system, const MotionSettings& settings, double sway)
    : system_(&system),
      work_(system, settings, step_tolerances(system)),
      removal_(work_),
      resting_(work_),
      placement_(work_, removal_, resting_),
      landing_(work_, removal_, resting_),
      closed_(system),
      sway_(sway) {}

void RattleStepper::begin(const State& state) {
  true_energy_ = energy(*system_, state);
  start_motion_ = energy_in_motion(*system_, state, scales_of(*system_, state));
}

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
  work_.friction.begin_step(h);
  step.state = placement_.find(stride_, step.book);
  flown_ = step.state;
  fly_second_half(step.state);
  cleaned_ = removal_.clean_up(step.state, step.book);
  add_blows(*system_, removal_.near().start_boxes(), cleaned_, stride_);
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
  fly_second_half(step.state);
  removal_.retreat(step.state);
  arrive(step, t);
  return step;
}

Step RattleStepper::halt(Step tried, double t) const {
  Step step;
  step.book.cost = tried.book.cost;
  step.book.audit = tried.book.audit;
  step.book.audit.max_overlap = step.book.audit.max_penetration = 0.0;
  step.book.audit.max_rod_error = 0.0;
  step.book.breaches = std::move(tried.book.breaches);
  std::vector<std::string> torn = lost_rods(*system_, tried.state);
  if (!torn.empty()) {
    ++step.book.audit.rods_contradicting;
    step.book.breaches.push_back({Promise::rods, t, std::move(torn)});
  }
  step.jammed = std::move(tried.jammed);
  step.state = stride_.start;
  for (BodyState& s : step.state)
    stop(s);
  step.book.losses = {{t + stride_.h, kinetic_energy(*system_, stride_.start), false, t}};
  step.book.settled = unexplained(*system_, stride_.start, step.state, stride_.h, {});
  step.record = std::make_shared<const StepRecord>();
  return step;
}

/// Velocities at the end of the way, before anything lands.
void RattleStepper::fly_second_half(State& state) const {
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i].velocity = stride_.half[i].velocity + 0.5 * stride_.h * system_->gravity;
    state[i].spin = stride_.half[i].spin;
  }
}

/// Velocities and books at the end of the way.
void RattleStepper::arrive(Step& step, double t) {
  step.overlap = removal_.left();
  step.book.audit.max_rod_error = largest_rod_error(*system_, step.state);
  landing_.find_touching(stride_, step.book);
  State flown = step.state;
  keep_turning(*system_, cleaned_, flown_, step.state);
  for (std::size_t i = 0; i < flown.size(); ++i) {
    flown[i].position = flown_[i].position;
    flown[i].angle = flown_[i].angle;
  }
  const Push cleaned = unexplained(*system_, flown, step.state);
  stride_.before = step.state;
  landing_.strike(step.state, step.book);
  step.error = error_of(step.state);
  StepRecord record = record_of(*system_, stride_, step.state);
  step.book.events = impacts_of(*system_, stride_, t);
  step.book.unexplained =
      unexplained(*system_, stride_.start, step.state, stride_.h, pushed()) + -1.0 * cleaned;
  note_settled(cleaned, record, step.book);
  jam(step, record, t);
  const bool sways = sway_ > 0.0 && !strays(record, step.state);
  const State unsettled = step.state;
  step.rise = restore_energy(*system_, stride_, sways, record, step.state);
  // What it was astray by before the step is paid back as well.
  if (sway_ > 0.0 && !sways)
    pay(*system_, record.components, energy(*system_, stride_.start) - true_energy_, step.state);
  note_settled(unexplained(*system_, unsettled, step.state), record, step.book);
  Loss impacts{t + stride_.h, 0.0, false, t};
  Loss friction{t + stride_.h, 0.0, true, t};
  for (const StepComponent& part : record.components) {
    for (const StepLoss& loss : part.losses)
      (loss.friction ? friction : impacts).energy += loss.energy;
  }
  step.book.losses = {impacts, friction};
  step.record = std::make_shared<const StepRecord>(std::move(record));
}

/// Books a change of momenta beyond the impulses: of fixed bodies, where they were touched.
void RattleStepper::note_settled(const Push& change, const StepRecord& record, Bookkeeping& book) {
  const bool fixed = std::ranges::any_of(
      record.components, [](const StepComponent& part) { return !part.held_along.empty(); });
  (fixed ? book.settled : book.unexplained) += change;
}

/// What fixed bodies did in the step.
Push RattleStepper::pushed() const {
  const Vec2 start = common_center(*system_, stride_.start);
  const Vec2 end = common_center(*system_, stride_.before);
  Push sum;
  for (std::size_t k = 0; k < system_->rods.size(); ++k) {
    const Rod& rod = system_->rods[k];
    add_push(stride_.start, start, rod, stride_.rods_first[k], sum);
    add_push(stride_.before, end, rod, stride_.rods_second[k], sum);
  }
  for (const auto& [id, blow] : stride_.blows) {
    add_push(*system_, stride_.start, start, blow.start, blow.first, sum);
    add_push(*system_, stride_.before, end, blow.end, blow.second, sum);
  }
  return sum;
}

/// Where no placement led to the lengths of rods, velocities that they cannot go on with are taken at once. Where that
/// happens step after step forces drive what the rods hold.
void RattleStepper::jam(Step& step, StepRecord& record, double t) {
  if (stride_.jammed.empty()) return;
  for (const Island& island : find_islands(*system_, landing_.touching())) {
    if (std::ranges::find_first_of(stride_.jammed, island.rods) == stride_.jammed.end()) continue;
    RodJam jam = rod_jam(*system_, step.state, island);
    if (!jam.rods.empty()) {
      take_jam(island, jam, step, record);
    } else {
      jam.rods = stopping_rods(island, step.state);
    }
    if (jam.rods.empty()) continue;
    if (jam.rods == jammed_) note_contradiction(*system_, jam.rods, t, step.book);
    add_jam_events(*system_, stride_.before, step.state, jam.rods, t + stride_.h, step.book.events);
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
  note_settled(unexplained(*system_, before, step.state), record, step.book);
  const auto mine = std::ranges::find_if(record.components, [&](const StepComponent& part) {
    return std::ranges::binary_search(part.cubes, island.cubes.front());
  });
  if (mine != record.components.end()) mine->losses.push_back({1.0, 1.0, jam.hit.loss});
}

/// Whether energy is farther from its true value than it may sway.
bool RattleStepper::strays(const StepRecord& record, const State& end) const {
  double astray = energy(*system_, end) - true_energy_;
  for (const StepComponent& part : record.components)
    astray += sum_of(part.losses);
  const double in_motion = energy_in_motion(*system_, stride_.start, stride_.scales);
  const double sway = sway_ * in_motion;
  if (!system_->rods.empty()) return std::abs(astray) > sway;
  const double most = most_missing * std::min(start_motion_, in_motion);
  return astray > std::min(sway, most) || -astray > most;
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
    const Body& body = system_->bodies[i];
    const double change = fastest_corner(body, Twist{b.velocity - a.velocity, b.spin - a.spin});
    if (change > rough_steps * stride_.scales.gravity * stride_.h) continue;
    const Vec2 way = b.position - a.position - 0.5 * stride_.h * (a.velocity + b.velocity);
    const double turn = body.radius() * (b.angle - a.angle - 0.5 * stride_.h * (a.spin + b.spin));
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

void RattleStepper::close_gaps(State& state) {
  wuerfel::close_gaps(acting(stride_), closed_, work_.finder, state);
}

}  // namespace wuerfel
