#include "core/time/track.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wuerfel {
namespace {

/// Frames per L / V, events per frame that are too many, and the longest stepping.
constexpr double frames_per_time = 20.0;
constexpr long most_events = 25;
constexpr long most_events_again = 5;  ///< where stepping was needed not long ago
constexpr long fewest_events = 3;
/// An event costs as much as the group is large: large groups are given fewer of them.
constexpr long most_events_and_cubes = 300;
/// With `--integrator event`: beyond this the motion would not get on.
constexpr long most_events_ever = 1000;
constexpr int most_patience = 32;
/// Steps per frame at first where the user did not choose them; one at least.
constexpr double steps_per_frame = 2.0;
/// Steps of second order have the root of the tolerance as their local error; in crowds, which
/// forget where they come from within a few impacts, so many times that. They are halved where it
/// is more, where energy rises by more than this share of what the group has in motion, or where
/// overlap beyond this share of a side is left, but not below a sixteenth; what still overlaps then
/// stops short. They are doubled where error
/// and rise would be fine at twice the length.
constexpr double rise_share = 1e-4;
constexpr double overlap_share = 2e-10;
constexpr double shortest_share = 1.0 / 16.0;
constexpr double crowd_error = 20.0;
constexpr double doubled_error = 0.1;
constexpr double doubled_rise = 0.2;
/// Steps shorter than this share of L / V are not taken: velocities are read off differences of
/// positions, which have no digits then.
constexpr double same_time = 1e-7;
/// Touching after stepping: gaps of contacts under load have been closed to rounding.
constexpr double touching_share = 1e-9;
/// Share of V below which a group that was stepped is at rest where its forces balance.
constexpr double rest_speed = 1e-4;
constexpr int looks_per_piece = 4;

}  // namespace

Track::Track(const System& system, const MotionSettings& settings)
    : system_(&system), settings_(settings), events_(system, settings) {}

RattleStepper& Track::stepper() {
  if (!stepper_) stepper_ = std::make_unique<RattleStepper>(*system_, settings_);
  return *stepper_;
}

void Track::start(const State& state,
                  double t,
                  double touching,
                  std::vector<char> resting,
                  const Stepping& stepping) {
  scales_ = scales_of(*system_, state);
  pieces_.clear();
  patience_ = stepping.patience;
  handed_back_ = t;
  frame_events_ = former_events_ = 0;
  // Impacts that are due happen here, and what rests is found, whoever moves the group afterwards.
  ContactLimits limits;
  limits.touching = std::max(touching, limits.touching);
  events_.start(state, t, limits, std::move(resting), book_);
  last_events_ = 0;
  stepping_ = false;
  const bool always = settings_.integrator == Integrator::rattle;
  if (events_.at_rest()) return;
  if (!(always || events_.wedged() || stepping.until > t)) return;
  stepping_ = true;
  clock_ = t;
  state_ = events_.state();
  ceiling_ = energy(*system_, state_);
  until_ = always ? std::numeric_limits<double>::infinity() : std::max(stepping.until, t + frame());
  longest_ = always ? settings_.step : frame();
  step_ = always ? settings_.step : longest_ / steps_per_frame;
}

Track::Stepping Track::stepping() const {
  return stepping_ ? Stepping{until_, patience_} : Stepping{-1.0, patience_};
}

Track::Stepping later(const Track::Stepping& a, const Track::Stepping& b) {
  return {std::max(a.until, b.until), std::max(a.patience, b.patience)};
}

double Track::clock() const { return stepping_ ? clock_ : events_.clock(); }

const std::vector<char>& Track::resting() const { return events_.resting(); }

void Track::advance(double limit) {
  if (stepping_) {
    step(limit);
    return;
  }
  const State start = events_.state();
  const double t = events_.clock();
  const std::size_t pieces = pieces_.size();
  const std::size_t logged = book_.events.size();
  const Audit before = book_.audit;
  book_.audit.max_overlap = 0.0;
  events_.advance(limit, pieces_, book_);
  const bool unsure = book_.audit.searches_given_up > before.searches_given_up;
  if (book_.audit.max_overlap > overlap_share
      || (unsure && stepper().measure_overlap(events_.state()) > overlap_share)) {
    // An event was missed. Stepping does not need to know of it.
    const long given_up = book_.audit.searches_given_up;
    book_.audit = before;
    book_.audit.searches_given_up = given_up;
    book_.events.resize(logged);
    pieces_.resize(pieces);
    hand_over(start, t);
    return;
  }
  book_.audit.max_overlap = std::max(book_.audit.max_overlap, before.max_overlap);
  consider_events();
}

double Track::frame() const { return scales_.time / frames_per_time; }

void Track::count_events(double t, long more) {
  const auto now = static_cast<long>(std::floor(t / frame()));
  if (now != frame_) {
    former_events_ = now == frame_ + 1 ? frame_events_ : 0;
    frame_events_ = 0;
    frame_ = now;
  }
  frame_events_ += more;
}

/// Whether events crowd, or the cubes are wedged.
void Track::consider_events() {
  if (events_.at_rest()) return;
  count_events(events_.clock(), events_.events() - last_events_);
  last_events_ = events_.events();
  if (events_.wedged() || frame_events_ > affordable_events())
    hand_over(events_.state(), events_.clock());
}

long Track::affordable_events() const {
  if (settings_.integrator == Integrator::event) return most_events_ever;
  return std::clamp(most_events_and_cubes / std::max(1, system_->cubes), fewest_events,
                    patience_ > 1 ? most_events_again : most_events);
}

void Track::hand_over(const State& state, double t) {
  clock_ = t;
  state_ = state;
  ceiling_ = energy(*system_, state_);
  // Soon after the last time: longer. After a long time without: as at first.
  if (clock_ - handed_back_ > most_patience * frame()) patience_ = 1;
  until_ = (std::floor(clock_ / frame()) + 1.0 + patience_) * frame();
  patience_ = std::min(2 * patience_, most_patience);
  longest_ = frame();
  step_ = longest_ / steps_per_frame;
  stepping_ = true;
  ++book_.cost.hand_overs;
}

void Track::step(double limit) {
  const double end = std::min(limit, until_);
  if (end - clock_ < same_time * scales_.time) {
    clock_ = end;
    if (clock_ >= until_) go_on_or_hand_back();
    return;
  }
  RattleStepper& stepper = this->stepper();
  const double whole = std::min({step_, stepper.longest_step(state_), end - clock_});
  double h = end - clock_ - whole < same_time * scales_.time ? end - clock_ : whole;
  const double shortest = h * shortest_share;
  const double bearable =
      rise_share * (kinetic_energy(*system_, state_) + scales_.weight * scales_.length);
  const Bookkeeping before = book_;
  State next = state_;
  double rise = 0.0;
  const bool always = settings_.integrator == Integrator::rattle;
  const double allowed = (always ? 1.0 : crowd_error) * std::sqrt(settings_.tolerance);
  const auto undo = [&] {
    const Cost cost = book_.cost;
    book_ = before;
    book_.cost = cost;
  };
  while (true) {
    next = state_;
    rise = stepper.step(next, clock_, h, book_);
    const bool clean = stepper.overlap_left() <= overlap_share;
    const bool exact = stepper.error() <= allowed && rise <= bearable;
    if (clean && (exact || h <= shortest)) break;
    undo();
    if (h <= shortest) {
      rise = stepper.stop_short(next, clock_, book_);
      ++book_.audit.unresolved;
      break;
    }
    h *= 0.5;
  }
  if (whole == step_) {
    const bool easy = stepper.error() <= doubled_error * allowed && rise <= doubled_rise * bearable;
    step_ = std::clamp(h == whole && easy ? 2.0 * h : h, shortest_share * longest_, longest_);
  }
  for (std::size_t k = before.events.size(); k < book_.events.size(); ++k)
    ceiling_ -= book_.events[k].loss;
  bring_down(next);
  pieces_.push_back({MotionPiece::Kind::stepped, clock_, h, state_, {}, {}});
  state_ = std::move(next);
  clock_ = h == end - clock_ ? end : clock_ + h;
  count_events(clock_, static_cast<long>(book_.events.size() - before.events.size()));
  if (clock_ >= until_) go_on_or_hand_back();
}

/// Energy of second order steps sways about its true value. What exceeds that of the beginning less
/// what impacts have taken is removed from the velocities: J v >= 0 is true of a share of v, too.
void Track::bring_down(State& state) const {
  const double excess = energy(*system_, state) - ceiling_;
  if (excess <= 0.0) return;
  const double kinetic = kinetic_energy(*system_, state);
  const double share = kinetic > excess ? std::sqrt(1.0 - excess / kinetic) : 0.0;
  for (BodyState& s : state) {
    s.velocity *= share;
    s.spin *= share;
  }
}

void Track::go_on_or_hand_back() {
  // Where events still crowd another frame of stepping saves the attempt.
  if (std::max(frame_events_, former_events_) > affordable_events()) {
    until_ = (std::round(clock_ / frame()) + 1.0) * frame();
  } else {
    hand_back();
  }
}

void Track::hand_back() {
  stepper().close_gaps(state_);
  handed_back_ = clock_;
  last_events_ = 0;
  frame_events_ = former_events_ = 0;
  stepping_ = false;
  events_.start(state_, clock_, {touching_share, rest_speed}, {}, book_);
  if (events_.wedged()) hand_over(events_.state(), events_.clock());
}

State Track::at(double t) {
  if (t >= clock()) return stepping_ ? state_ : events_.state();
  auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), t,
                                [](double time, const MotionPiece& p) { return time < p.begin; });
  if (piece == pieces_.begin()) return stepping_ ? state_ : events_.state();
  --piece;
  if (t <= piece->begin || piece->kind == MotionPiece::Kind::rest) return piece->start;
  if (piece->kind == MotionPiece::Kind::smooth) return events_.look(*piece, t);
  const auto next = std::next(piece);
  if (!looker_) looker_ = std::make_unique<RattleStepper>(*system_, settings_);
  return looker_->look(piece->start, next == pieces_.end() ? state_ : next->start, piece->length,
                       (t - piece->begin) / piece->length);
}

void Track::forget_before(double t) {
  while (pieces_.size() > 1 && pieces_[1].begin <= t)
    pieces_.pop_front();
}

void Track::sweep(double t, std::vector<BoundingBox>& bounds) const {
  const auto add = [&](const State& state) {
    for (std::size_t i = 0; i < state.size(); ++i) {
      const Vec2 reach = Vec2::Constant(0.5 * system_->body(static_cast<int>(i)).size.norm());
      bounds[i].low = bounds[i].low.cwiseMin(state[i].position - reach);
      bounds[i].high = bounds[i].high.cwiseMax(state[i].position + reach);
    }
  };
  add(stepping_ ? state_ : events_.state());
  State state;
  for (auto piece = pieces_.begin(); piece != pieces_.end(); ++piece) {
    const auto next = std::next(piece);
    const double end = next == pieces_.end() ? clock() : next->begin;
    if (end < t) continue;
    add(piece->start);
    if (piece->kind != MotionPiece::Kind::smooth) continue;
    // Between its ends a smooth piece leaves the chord: it is looked at along the way.
    state = piece->start;
    for (int k = 1; k < looks_per_piece; ++k) {
      look_at(piece->motion, (end - piece->begin) / piece->length * k / looks_per_piece, state);
      add(state);
    }
  }
}

}  // namespace wuerfel
