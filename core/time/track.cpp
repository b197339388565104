#include "core/time/track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/dynamics/momentum_balance.h"
#include "core/time/events/corrections.h"
#include "core/time/promises.h"
#include "core/time/rod_events.h"

namespace wuerfel {
namespace {

/// Beyond so many cubes a group that was handed over goes back only to be found at rest: the linear
/// algebra of one smooth phase costs as much as many steps.
constexpr int most_event_cubes = 100;
/// Beyond so many cubes a group that rubs or bounces is stepped only: equations with friction are dense.
constexpr int most_rubbing_cubes = 12;
/// Where the user did not choose a step: the first one and the longest, in frames.
constexpr double first_step = 0.5;
constexpr double longest_step = 8.0;
/// Frames after which it is asked again whether what stands is held, at the latest: what gives way for less goes unseen.
constexpr double held_for = 1.0;

}  // namespace

Track::Track(const System& system, const MotionSettings& settings, const MotionPolicy& policy)
    : system_(&system),
      settings_(settings),
      policy_(policy),
      only_steps_((system.rubs || system.bounces) && system.cubes > most_rubbing_cubes),
      events_(system, settings),
      history_(system, settings),
      crowding_(system.cubes, policy_.only_events) {}

void Track::begin_steps(const State& state, double t, double until) {
  if (!steps_) steps_ = std::make_unique<ControlledStepping>(*system_, settings_, policy_);
  const bool chosen = policy_.step > 0.0;
  steps_->begin(state, chosen ? policy_.step : first_step * crowding_.frame(),
                chosen ? policy_.step : longest_step * crowding_.frame());
  stepping_ = true;
  moving_.assign(state.size(), 0);
  clock_ = t;
  until_ = until;
}

void Track::start(const State& state,
                  double t,
                  double touching,
                  std::vector<char> resting,
                  const Stepping& stepping) {
  scales_ = scales_of(*system_, state);
  history_.pieces().clear();
  crowding_.begin(scales_.time, t, stepping.patience);
  stepping_ = false;
  part_.reset();
  if (only_steps_) return go_on_from(state, t, touching, std::move(resting));
  // What is stepped anyway meets its impacts in steps.
  if (stepping.until > t && !policy_.only_steps)
    return begin_steps(state, t, std::max(stepping.until, t + crowding_.frame()));
  // Impacts that are due happen here, and what rests is found, whoever moves the group afterwards.
  const ContactLimits limits{std::max(touching, event_touching)};
  const bool fits = events_.start(state, t, limits, std::move(resting), book_);
  last_events_ = 0;
  if (fits && (events_.at_rest() || !(policy_.only_steps || events_.wedged()))) {
    (void)move_part(touching);
    return;
  }
  const bool settles = system_->rubs || system_->bounces;
  begin_steps(fits ? events_.state() : state, t,
              !policy_.only_steps ? t + crowding_.frame()
              : settles           ? t + longest_step * crowding_.frame()
                                  : std::numeric_limits<double>::infinity());
}

/// Whether everything rests where it is, once velocities that do not count are taken away: books the rest.
bool Track::rest_from(const State& state, double t, double touching, std::vector<char> resting) {
  if (!is_slower_than(*system_, state, slowest_motion * scales_.speed)) return false;
  State still = state;
  for (BodyState& s : still)
    stop(s);
  const ContactLimits limits{std::max(touching, event_touching)};
  if (!events_.would_rest(still, limits)) return false;
  Bookkeeping found;
  if (!(events_.start(still, t, limits, std::move(resting), found) && events_.at_rest()))
    return false;
  found.losses.push_back({t, energy(*system_, state) - energy(*system_, still), false, t});
  found.settled += unexplained(*system_, state, still);
  add(found, book_);
  return true;
}

Stepping Track::stepping() const { return {stepping_ ? until_ : -1.0, crowding_.patience()}; }

Stepping later(const Stepping& a, const Stepping& b) {
  return {std::max(a.until, b.until), std::max(a.patience, b.patience)};
}

/// A large group goes on from a state: it rests, most of it stands, or it is stepped.
void Track::go_on_from(const State& state, double t, double touching, std::vector<char> resting) {
  if (rest_from(state, t, touching, std::move(resting)) || part_from(state, t, touching, held_for))
    return;
  begin_steps(state, t, t + longest_step * crowding_.frame());
}

/// Whether most of the cubes stand, and only the others go on, in steps of at most so many frames.
bool Track::part_from(const State& state, double t, double touching, double longest) {
  if (!policy_.parts) return false;
  if (!work_) work_ = std::make_unique<Workspace>(*system_, settings_);
  part_ = PartialMotion::find(state, t, touching, settings_, policy_, *work_);
  keep_cost(std::exchange(work_->solves, {}), book_);
  if (!part_) return false;
  part_->set_longest_step(longest * crowding_.frame());
  const State& begun = part_->state();
  book_.losses.push_back({t, energy(*system_, state) - energy(*system_, begun), false, t});
  book_.settled += unexplained(*system_, state, begun);
  MotionPiece piece;
  piece.kind = MotionPiece::Kind::part;
  piece.begin = t;
  piece.start = begun;
  piece.part = part_;
  history_.pieces().push_back(std::move(piece));
  return true;
}

/// Where forces are many and few cubes move the others need no equations.
bool Track::move_part(double touching) {
  return (system_->rubs || system_->bounces) && !events_.at_rest() && events_.redundant()
         && part_from(events_.state(), events_.clock(), touching, held_for);
}

void Track::advance_part(double limit) {
  const std::size_t logged = book_.events.size();
  part_->advance(limit, book_);
  crowding_.count(part_->clock(), static_cast<long>(book_.events.size() - logged), 1);
  const bool rests = part_->goes_on() && part_->at_rest();
  if (part_->goes_on() && !rests) return;
  const std::shared_ptr<PartialMotion> part = std::exchange(part_, nullptr);
  if (rests) return rest_there(part->state(), part->clock());
  // Somewhere in that step the others give way: as near to it as steps begin.
  const bool far = part->refused() > 0.5 * (first_step + held_for) * crowding_.frame();
  if (far && part_from(part->state(), part->clock(), touching_tolerance, first_step)) return;
  go_on_after(*part);
}

/// The whole group moves again.
void Track::go_on_after(const PartialMotion& part) {
  const double t = part.clock();
  if (only_steps_) return begin_steps(part.state(), t, crowding_.frames_after(t, longest_step));
  if (part.is_stepped()) return hand_over(part.state(), t);
  follow_from(part.state(), t, {}, part.resting());
}

/// From event to event from a state on; where that leaves overlap, or cubes are wedged, in steps.
void Track::follow_from(const State& state,
                        double t,
                        const ContactLimits& limits,
                        std::vector<char> resting) {
  last_events_ = 0;
  const bool fits = events_.start(state, t, limits, std::move(resting), book_);
  if (!fits || events_.wedged()) hand_over(fits ? events_.state() : state, t);
}

/// Nobody moves any more, and all are known to be held.
void Track::rest_there(const State& state, double t) {
  Bookkeeping found;
  const ContactLimits limits{touching_tolerance, slowest_motion};
  if (events_.start(state, t, limits, std::vector<char>(state.size(), 1), found)
      && events_.at_rest()) {
    add(found, book_);
    return;
  }
  begin_steps(state, t, crowding_.frames_after(t, longest_step));
}

double Track::clock() const {
  if (part_) return part_->clock();
  return stepping_ ? clock_ : events_.clock();
}

const State& Track::state() const {
  if (part_) return part_->state();
  return stepping_ ? steps_->state() : events_.state();
}

const std::vector<char>& Track::resting() const {
  if (part_) return part_->resting();
  return stepping_ ? moving_ : events_.resting();
}

void Track::advance(double limit) {
  if (part_) return advance_part(limit);
  const Audit before = book_.audit;
  const double t = clock();
  const std::size_t known = book_.breaches.size();
  stepping_ ? step(limit) : follow_events(limit);
  if (broken_promises(book_.audit) == broken_promises(before)) return;
  std::vector<Breach> named(book_.breaches.begin() + static_cast<std::ptrdiff_t>(known),
                            book_.breaches.end());
  note_breaches(before, t, moving_names(), book_);
  // Of rods their names are told: of those that contradicted each other, which are known, or lost their lengths.
  for (std::size_t k = known + named.size(); k < book_.breaches.size(); ++k) {
    Breach& breach = book_.breaches[k];
    if (breach.promise != Promise::rods) continue;
    const Breach* contradiction = first_breach(named, Promise::rods);
    breach.bodies = contradiction != nullptr ? contradiction->bodies : lost_rods(*system_, state());
  }
}

std::vector<std::string> Track::moving_names() const {
  std::vector<std::string> names;
  for (int i = 0; i < system_->cubes; ++i)
    if (resting()[i] == 0) names.push_back(system_->body(i).name);
  return names;
}

void Track::follow_events(double limit) {
  const State start = events_.state();
  const double t = events_.clock();
  const std::size_t pieces = history_.pieces().size();
  const std::size_t logged = book_.events.size();
  const std::size_t lost = book_.losses.size();
  const Audit before = book_.audit;
  const Push unexplained_before = book_.unexplained;
  book_.audit.max_overlap = 0.0;
  events_.advance(limit, history_.pieces(), book_);
  if (leaves_overlap(before) || book_.audit.wedged > before.wedged) {
    // An event was missed, or no accelerations lead there. Stepping does not need to know of either.
    const Audit tried = book_.audit;
    book_.audit = before;
    book_.audit.searches_given_up = tried.searches_given_up;
    book_.audit.wedged = tried.wedged;
    book_.events.resize(logged);
    book_.losses.resize(lost);
    book_.unexplained = unexplained_before;
    history_.pieces().resize(pieces);
    hand_over(start, t);
    return;
  }
  book_.audit.max_overlap = std::max(book_.audit.max_overlap, before.max_overlap);
  consider_events();
}

/// Whether the events left overlap: at the last one, or where a search could not be sure.
bool Track::leaves_overlap(const Audit& before) {
  const double share = bearable_overlap(events_.state(), scales_);
  if (book_.audit.max_overlap > share) return true;
  return book_.audit.searches_given_up > before.searches_given_up && events_.overlap() > share;
}

/// Whether events crowd, or the cubes are wedged.
void Track::consider_events() {
  if (events_.at_rest()) return;
  const bool touches = !history_.pieces().back().closed.empty();
  crowding_.count(events_.clock(), events_.events() - last_events_, touches ? 1 : 0);
  const bool new_phase = events_.events() > last_events_;
  last_events_ = events_.events();
  if (events_.wedged() || crowding_.crowds()) {
    hand_over(events_.state(), events_.clock());
  } else if (new_phase) {
    (void)move_part(event_touching);
  }
}

bool Track::take_blows() {
  events_.take_blows(book_);
  consider_events();
  return book_.audit.max_overlap <= bearable_overlap(events_.state(), scales_);
}

void Track::hand_over(const State& state, double t) {
  begin_steps(state, t, crowding_.step_from(t));
  ++book_.cost.hand_overs;
}

void Track::step(double limit) {
  const std::size_t logged = book_.events.size();
  const State start = steps_->state();
  // Steps of a user's length are not cut where rest is looked for.
  const double last = policy_.only_steps ? limit : std::min(limit, until_);
  const double end = steps_->advance(clock_, last, book_);
  history_.pieces().push_back({MotionPiece::Kind::stepped,
                               clock_,
                               end - clock_,
                               start,
                               {},
                               steps_->loaded(),
                               steps_->record()});
  clock_ = end;
  crowding_.count(clock_, static_cast<long>(book_.events.size() - logged), 0);
  if (clock_ >= until_) go_on_or_hand_back();
}

/// Where events still crowd more stepping saves the attempt.
void Track::go_on_or_hand_back() {
  const bool slow = is_slower_than(*system_, steps_->state(), slowest_motion * scales_.speed);
  if (only_steps_ || policy_.only_steps) {
    until_ = crowding_.frames_after(clock_, longest_step);
    stepping_ = !(slow && rest_with_closed_gaps()) && !hand_to_part();
    return;
  }
  const bool few = system_->cubes <= most_event_cubes || policy_.only_events;
  if (crowding_.calm() && (few || slow)) {
    hand_back();
  } else {
    until_ = crowding_.frames_after(clock_, longest_step);
  }
}

/// Books what it took to close the gaps at the end of a stepping.
void Track::book_closing(const State& closed) {
  const double loss = energy(*system_, steps_->state()) - energy(*system_, closed);
  if (loss > 0.0) book_.losses.push_back({clock_, loss, false, clock_});
  book_.settled += unexplained(*system_, steps_->state(), closed);
}

bool Track::rest_with_closed_gaps() {
  const State state = steps_->with_closed_gaps();
  if (!rest_from(state, clock_, touching_tolerance, {})) return false;
  book_closing(state);
  return true;
}

bool Track::hand_to_part() {
  if (!policy_.parts || !PartialMotion::few_move(*system_, steps_->state())) return false;
  const State state = steps_->with_closed_gaps();
  if (!part_from(state, clock_, touching_tolerance, held_for)) return false;
  book_closing(state);
  return true;
}

void Track::hand_back() {
  crowding_.step_to(clock_);
  stepping_ = false;
  const State state = steps_->with_closed_gaps();
  book_closing(state);
  // Gaps of contacts under load have been closed to rounding.
  follow_from(state, clock_, {touching_tolerance, slowest_motion}, {});
}

std::vector<Contact> Track::loaded_at(double t) const {
  const std::deque<MotionPiece>& pieces = history_.pieces();
  const MotionPiece* piece = t < clock() ? history_.piece_at(t) : nullptr;
  if (piece == nullptr && part_) return part_->loaded_at(t);
  // At the clock of a stepping it is the last step.
  if (piece == nullptr && stepping_ && !pieces.empty()) piece = &pieces.back();
  if (piece == nullptr) return {};
  if (piece->part) return piece->part->loaded_at(t);
  return piece->kind == MotionPiece::Kind::stepped ? piece->closed : std::vector<Contact>{};
}

State Track::at(double t) { return t < clock() ? history_.at(t, state(), events_) : state(); }

void Track::forget_before(double t) { history_.forget_before(t); }

void Track::sweep(double t, std::vector<BoundingBox>& bounds) const {
  history_.sweep(t, clock(), state(), bounds);
}

}  // namespace wuerfel
