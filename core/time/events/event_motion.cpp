#include "core/time/events/event_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/dynamics/momentum.h"
#include "core/dynamics/momentum_balance.h"
#include "core/dynamics/rod_rows.h"
#include "core/time/crowding.h"
#include "core/time/events/corrections.h"
#include "core/time/rod_events.h"

namespace wuerfel {
namespace {

/// Smooth phases are integrated to this share of the tolerance that the user asked for.
constexpr double inner_share = 0.01;
/// Events closer than this share of L / V are at one instant; more of them in a row have no end.
constexpr double instant_share = 1e-13;
constexpr int most_instant_events = 60;
/// Below this share of L / V an event is reached by accelerations; what they change by meanwhile is
/// rounding.
constexpr double shifted_share = 1e-8;
/// The search has found an event to this share of the step, or Newton's method is not trusted.
constexpr double trusted_share = 0.01;
constexpr int most_newton_steps = 4;
/// Rates of loads are differences over this share of L / V.
constexpr double ahead_share = 1e-6;
/// Accelerations break Coulomb's law that no forces lead to but for this share of the largest one.
constexpr double lawful_share = 1e-6;
/// What is left of bouncing when a contact no longer bounces takes less than a frame, in units of L / V.
constexpr double longest_tail = 1.0 / frames_per_time;

/// Books what friction takes in a step from `start` at time t: nothing else takes energy between events.
void note_friction(
    const System& system, const State& start, double t, const SmoothStep& step, Bookkeeping& book) {
  const double taken = energy(system, start) - energy(system, step.end);
  book.losses.push_back({t + step.elapsed, taken, true, t});
}

/// Whether a pair, by its names in order, is among those that touch.
bool touch_each_other(const System& system,
                      const std::vector<Touch>& touches,
                      const BounceSeries::NamePair& names) {
  return std::ranges::any_of(touches, [&](const Touch& t) {
    return names
           == BounceSeries::NamePair(std::minmax(system.body(t.on).name, system.body(t.from).name));
  });
}

}  // namespace

EventMotion::EventMotion(const System& system, const MotionSettings& settings)
    : system_(&system),
      tolerance_(inner_share * settings.tolerance),
      work_(system, settings),
      phase_(system, settings.skips.free_bodies),
      geometry_(system),
      looker_(system) {}

bool EventMotion::start(const State& state,
                        double t,
                        const ContactLimits& limits,
                        std::vector<char> resting,
                        Bookkeeping& book) {
  clock_ = t;
  events_ = 0;
  instant_events_ = 0;
  phase_.forget_step();
  FormerPhase before;
  before.modes.resting = std::move(resting);
  Bookkeeping found;
  struck_ = {};
  Instant now = happen(state, t, before, limits, work_);
  const bool strikes = !now.blows.empty();
  begin_phase(state, std::move(now), found);
  if (strikes || overlap() > bearable_overlap(state, phase_.scales())) return false;
  add(found, book);
  return true;
}

bool EventMotion::would_rest(const State& state, const ContactLimits& limits) {
  const bool rests = wuerfel::would_rest(state, limits, work_);
  work_.solves = {};
  return rests;
}

bool EventMotion::at_rest() const {
  return std::ranges::all_of(modes_.resting, [](char r) { return r != 0; });
}

double EventMotion::overlap() {
  work_.finder.find(*system_, state(), 0.0);
  return work_.finder.deepest().depth / work_.finder.deepest().scale;
}

// The heart of the default motion: a smooth phase is stepped; where an event ends it, the step is
// cut there, impacts happen, it is found which contacts stay closed, and another phase begins.
void EventMotion::advance(double limit, std::deque<MotionPiece>& pieces, Bookkeeping& book) {
  if (at_rest()) return rest_for_ever(pieces);
  const SmoothStep& step = phase_.step(limit - clock_);
  const std::optional<FirstEvent> event = first_event(step, book);
  if (event) reach(*event);
  note_step(step, book);
  pieces.push_back(last_piece());
  clock_ += step.elapsed;
  const bool ends = event || phase_.rods_contradict();
  const bool instant = step.elapsed <= instant_share * phase_.scales().time;
  instant_events_ = ends && instant ? instant_events_ + 1 : 0;
  if (ends) {
    const State end = step.end;
    Instant now = happen(end, clock_, ended_phase(), {}, work_);
    if (now.blows.empty()) return take(end, std::move(now), book);
    note_overlap(now.deepest.depth, now.deepest.scale, book.audit);
    struck_ = std::move(now);
  }
  phase_.go_on();
  if (ends) return;
  if (breaks_law()) modes_.wedged = true;
  geometry_.passed(state());
  forces_.passed(phase_.loads());
}

/// The motion goes on by what the clock's instant brings to a state.
void EventMotion::take(const State& state, Instant now, Bookkeeping& book) {
  begin_phase(state, std::move(now), book);
  if (!series_.goes_on()) ++events_;
  // Events without end at one instant: only positions know what happens next.
  if (instant_events_ > most_instant_events) modes_.wedged = true;
}

void EventMotion::take_blows(Bookkeeping& book) {
  const State before = state();
  take(before, std::exchange(struck_, {}), book);
}

void EventMotion::rest_for_ever(std::deque<MotionPiece>& pieces) {
  pieces.push_back({MotionPiece::Kind::rest, clock_, 0.0, state(), {}, {}, {}});
  clock_ = std::numeric_limits<double>::infinity();
}

/// Books a step that ends where it ends.
void EventMotion::note_step(const SmoothStep& step, Bookkeeping& book) {
  ++book.cost.steps;
  if (!step.followed) {
    modes_.wedged = true;
    ++book.audit.wedged;
  }
  note_momenta(step, book);
  double& worst = book.audit.max_rod_error;
  worst = std::max(worst, largest_rod_error(*system_, step.end));
  if (phase_.equations().slips()) note_friction(*system_, state(), clock_, step, book);
}

/// Books what the momenta changed by in a step, and what putting its end on fixed bodies did.
void EventMotion::note_momenta(const SmoothStep& step, Bookkeeping& book) const {
  const State& flown = step.flown.empty() ? step.end : step.flown;
  book.unexplained +=
      unexplained(*system_, state(), flown, step.elapsed, step.push, modes_.resting);
  if (!step.flown.empty())
    book.settled += unexplained(*system_, step.flown, step.end, 0.0, {}, modes_.resting);
}

/// Books what the clock's instant has brought to a state, and begins the phase that follows.
void EventMotion::begin_phase(const State& state, Instant now, Bookkeeping& book) {
  const auto stays = [&](const BounceSeries::NamePair& names) {
    return touch_each_other(*system_, now.modes.closed.touches, names);
  };
  series_.note(now.events, stays, longest_tail * scales_of(*system_, state).time);
  note_events(now, book);
  if (!now.contradicting.empty()) note_contradiction(*system_, now.contradicting, clock_, book);
  keep_book(std::exchange(work_.solves, {}), book);
  modes_ = std::move(now.modes);
  close(now.state);
  // The phase begins on its closed contacts; of wedged cubes that takes more than rounding.
  if (phase_.equations().on_fixed())
    now.settled += unexplained(*system_, now.state, phase_.state());
  // What is put on its contacts is pushed into others that were not there yet, if it has to go far.
  const double way = farthest_way(*system_, state, phase_.state());
  if (way > touching_tolerance * phase_.scales().length && overlap() > 0.0)
    note_overlap(work_.finder.deepest().depth, work_.finder.deepest().scale, book.audit);
  note_change(*system_, state, clock_, now, phase_.state(), book);
  geometry_.begin(phase_.state(), modes_.closed, modes_.resting);
  // A load, or a slip, that starts at rounding is watched from where it has left zero.
  forces_.begin(phase_, force_rounding);
  // A body on a rod that is alone in the world meets nobody and releases nothing.
  phase_.set_watched(!modes_.closed.contacts.empty() || geometry_.watches());
}

/// Begins a phase. Where contacts depend on one another their forces are not the only ones, and friction is that of those
/// that were found: what slips and needs none is left open. What slips and pulls all the same is driven: only positions know
/// what happens next.
void EventMotion::close(const State& state) {
  phase_.begin(state, modes_.closed, modes_.resting, tolerance_);
  if (phase_.redundant() && drop_idle(modes_.closed))
    phase_.begin(state, modes_.closed, modes_.resting, tolerance_);
  if (phase_.friction_drives() || breaks_law()) modes_.wedged = true;
}

/// Whether forces that are not the only ones, of contacts that slip, lead to accelerations that Coulomb's law does not have: some
/// pull, or are beyond their friction, and no others do the same.
bool EventMotion::breaks_law() {
  const EquationsOfMotion& equations = phase_.equations();
  if (!phase_.redundant() || !equations.slips()) return false;
  const std::span<const double> loads(phase_.loads());
  const double rounding = force_rounding * phase_.scales().weight;
  const auto pulls = [&](double load) { return load < -rounding; };
  if (std::ranges::none_of(loads.first(equations.first_slip(phase_.loads())), pulls)) return false;
  return !have_lawful_forces(
      phase_.state(), phase_.closed(), [&](int cube) { return phase_.acceleration(cube); },
      lawful_share, work_);
}

/// The first event within a step.
std::optional<EventMotion::FirstEvent> EventMotion::first_event(const SmoothStep& step,
                                                                Bookkeeping& book) {
  const auto [meeting, given_up] = geometry_.first(step.motion, step.length, step.range);
  book.audit.searches_given_up += given_up;
  const double until = meeting ? meeting->share : 1.0;
  const auto release = forces_.first(phase_, until, phase_.scales().gravity, work_);
  keep_book(std::exchange(work_.solves, {}), book);
  if (release) return FirstEvent(*release);
  return meeting ? std::optional<FirstEvent>(*meeting) : std::nullopt;
}

/// The function of an event, value and rate, at the end of the step.
Jet EventMotion::value_at_end(const FirstEvent& event) {
  if (const auto* meeting = std::get_if<GeometricEvents::First>(&event)) {
    Jet jet = value_at(*system_, phase_.last().end, meeting->function);
    jet.value += meeting->function.arming.shift;
    return jet;
  }
  const auto& release = std::get<ForceEvents::First>(event);
  if (!release.load) return {};
  const double ahead = ahead_share * phase_.scales().time;
  std::vector<double> later;
  phase_.loads_at(phase_.shifted_end(ahead), later);
  const double now = phase_.last().loads[*release.load];
  return {now + release.arming.shift, (later[*release.load] - now) / ahead, 0.0};
}

/// Steps to where the function of an event vanishes: Newton's method on true states.
void EventMotion::reach(const FirstEvent& event) {
  const double h = phase_.last().length;
  double length = h * std::visit([](const auto& first) { return first.share; }, event);
  for (int k = 0; k < most_newton_steps; ++k) {
    phase_.cut(length);
    const Jet f = value_at_end(event);
    if (!(f.first < 0.0)) return;
    const double correction = -f.value / f.first;
    if (length + correction <= 0.0) return;
    if (std::abs(correction) <= shifted_share * phase_.scales().time) {
      phase_.shift_end(correction);
      return;
    }
    if (std::abs(correction) > trusted_share * h) return;
    length += correction;
  }
}

MotionPiece EventMotion::last_piece() const {
  const SmoothStep& step = phase_.last();
  return {MotionPiece::Kind::smooth,
          clock_,
          step.length,
          phase_.state(),
          step.motion,
          phase_.equations().contacts(),
          {},
          phase_.equations().touches(),
          system_->rods.empty() ? std::vector<char>{} : modes_.resting};
}

/// The phase that the last step ends, its contacts as they are there.
FormerPhase EventMotion::ended_phase() const {
  FormerPhase ended{modes_, true};
  ended.modes.closed.contacts = phase_.equations().contacts();
  follow(*system_, phase_.last().end, ended.modes.closed.contacts);
  return ended;
}

State EventMotion::look(const MotionPiece& piece, double t) {
  State state = piece.start;
  if (t <= piece.begin) return state;
  look_at(motion_of(*system_, piece), (t - piece.begin) / piece.length, state);
  if (!piece.closed.empty() || !system_->rods.empty()) {
    looker_.close(piece.closed, piece.resting, piece.touches);
    project_places(looker_, state);
    project_velocities(looker_, state);
    for (const std::vector<int>& cubes : flying_groups(*system_, piece.closed, piece.resting))
      keep_momenta(*system_, cubes, piece.start, t - piece.begin, state);
  }
  return state;
}

}  // namespace wuerfel
