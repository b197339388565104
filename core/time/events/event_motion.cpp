#include "core/time/events/event_motion.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// Smooth phases are integrated to this share of the tolerance that the user asked for.
constexpr double inner_share = 0.01;
/// A force that starts below this share of the weight is watched from where it has left zero.
constexpr double zero_force = 1e-11;
/// Growth and shrinking of steps (Hairer, Norsett, Wanner, section II.4).
constexpr double safety = 0.9;
constexpr double most_growth = 6.0;
constexpr double most_shrinking = 0.2;
/// Units of L / V: the first step, the first free fall, the shortest step, time that is forced to
/// pass where events follow one another without any.
constexpr double first_step = 0.1;
constexpr double first_fall = 4.0;
constexpr double fall_growth = 4.0;
/// The angle by which cubes turn at most within one free fall, rad.
constexpr double most_turning = 50.0;
constexpr double shortest_step = 1e-11;
constexpr double forced_time = 1e-9;
constexpr double instant_share = 1e-13;
constexpr int most_instant_events = 60;
/// Corrections of an event's time end at this share of L / V.
constexpr double located_share = 1e-15;
/// Below this share of L / V a correction is made by accelerations; what they change by meanwhile
/// is rounding.
constexpr double moved_share = 1e-8;
constexpr int most_corrections = 4;
/// The bracket that the search leaves of an event in a step.
constexpr double found_share = 1e-13;

/// x^(-1/8), from square roots.
double eighth_root_inverse(double x) { return 1.0 / std::sqrt(std::sqrt(std::sqrt(x))); }

}  // namespace

EventMotion::EventMotion(const System& system, const MotionSettings& settings)
    : system_(&system),
      settings_(settings),
      law_(system, settings),
      closed_(system),
      looker_(system),
      search_(system),
      releases_(system, settings),
      holds_(system),
      next_holds_(system) {}

void EventMotion::start(const State& state,
                        double t,
                        const ContactLimits& limits,
                        std::vector<char> resting,
                        Bookkeeping& book) {
  state_ = state;
  scratch_ = state;
  clock_ = t;
  step_ = 0.0;
  events_ = 0;
  instant_events_ = 0;
  closure_.closed.clear();
  closure_.resting = std::move(resting);
  begin_phase(limits, book);
}

bool EventMotion::at_rest() const {
  return std::ranges::all_of(closure_.resting, [](char r) { return r != 0; });
}

void EventMotion::begin_phase(const ContactLimits& limits, Bookkeeping& book) {
  closure_.closed = closed_.contacts();
  const double before = energy(*system_, state_);
  law_.apply(state_, clock_, limits, closure_, book);
  closed_.close(closure_.closed, closure_.resting);
  closed_.project_positions(state_);
  closed_.project_velocities(state_);
  // Impacts take energy, and so does what is put on closed contacts: of wedged cubes a lot.
  const double loss = before - energy(*system_, state_);
  if (loss > 0.0) book.losses.push_back({clock_, loss});
  search_.begin(state_, closed_.contacts(), closure_.resting);
  scales_ = scales_of(*system_, state_);
  const double tolerance = inner_share * settings_.tolerance;
  scale_.clear();
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const double length = tolerance * scales_.length;
    const double speed = tolerance * scales_.speed;
    for (const double s :
         {length, length, tolerance, speed, speed, tolerance * scales_.speed / scales_.length})
      scale_.push_back(s);
  }
  fall_ = first_fall * scales_.time;
  if (step_ <= 0.0) step_ = first_step * scales_.time;
  pack(state_, y_);
  pull_ = std::numeric_limits<double>::infinity();
  (*this)(y_, rate_);
  holds_.begin(closed_, zero_force * scales_.weight);
}

void EventMotion::operator()(const std::vector<double>& y, std::vector<double>& rate) {
  unpack(y, scratch_);
  closed_.accelerate(scratch_, accelerations_);
  rate.resize(y.size());
  double* at = rate.data();
  for (std::size_t i = 0; i < scratch_.size(); ++i) {
    const Twist& a = accelerations_[i];
    at[0] = scratch_[i].velocity.x();
    at[1] = scratch_[i].velocity.y();
    at[2] = scratch_[i].spin;
    at[3] = a.linear.x();
    at[4] = a.linear.y();
    at[5] = a.angular;
    at += components;
  }
  if (!holds_.empty()) pull_ = std::min(pull_, holds_.smallest(closed_));
}

void EventMotion::advance(double limit, std::deque<MotionPiece>& pieces, Bookkeeping& book) {
  if (at_rest()) {
    pieces.push_back({MotionPiece::Kind::rest, clock_, 0.0, state_, {}, {}, {}});
    clock_ = std::numeric_limits<double>::infinity();
    return;
  }
  ++book.cost.steps;
  if (settings_.skips.free_bodies && closed_.contacts().empty()) {
    fall(limit, pieces, book);
  } else {
    integrate(limit, pieces, book);
  }
}

/// Free fall is a parabola, of any length.
void EventMotion::fall(double limit, std::deque<MotionPiece>& pieces, Bookkeeping& book) {
  double fastest = 0.0;
  for (const BodyState& s : state_)
    fastest = std::max(fastest, std::abs(s.spin));
  // The search for events looks at every turn.
  const double turning =
      fastest > 0.0 ? most_turning / fastest : std::numeric_limits<double>::infinity();
  const double h = std::min({fall_, turning, limit - clock_});
  fall_ *= fall_growth;
  dense_.coefficients.assign(y_.size() * DenseStep::terms, 0.0);
  double* c = dense_.coefficients.data();
  for (std::size_t i = 0; i < y_.size(); ++i, c += DenseStep::terms) {
    const bool position = i % components < components / 2;
    const double half = position ? 0.5 * h * h * rate_[i + components / 2] : 0.0;
    c[0] = y_[i];
    c[1] = h * rate_[i] + half;
    c[2] = -half;
  }
  range_.resize(state_.size());
  for (std::size_t i = 0; i < range_.size(); ++i)
    range_[i] = {accelerations_[i], accelerations_[i]};
  const auto crossing = search_.first({&dense_, h, &range_});
  note_given_up(book);
  next_ = state_;
  const double elapsed = crossing ? fall_to(*crossing, h) : h;
  if (!crossing) look_at(dense_, 1.0, next_);
  pieces.push_back({MotionPiece::Kind::smooth, clock_, h, state_, dense_, {}, {}});
  finish(elapsed, crossing.has_value(), book);
}

/// Falls to where a watched function vanishes: Newton's method on the parabola.
double EventMotion::fall_to(const Crossing& crossing, double h) {
  double length = crossing.share * h;
  for (int k = 0; k < most_corrections; ++k) {
    look_at(dense_, length / h, next_);
    const Reading reading = search_.read(next_, crossing.watch);
    const double correction = -reading.value / reading.rate;
    if (std::abs(correction) <= located_share * scales_.time) break;
    if (!(std::abs(correction) <= found_share * h) || length + correction <= 0.0) break;
    length += correction;
  }
  return length;
}

void EventMotion::integrate(double limit, std::deque<MotionPiece>& pieces, Bookkeeping& book) {
  const double h = controlled_step(std::min(step_, limit - clock_), book);
  complete_step(h);
  if (instant_events_ > most_instant_events) {
    // Events without end at one instant: time is made to pass, and that is reported.
    ++book.audit.unresolved;
    const double forced = std::min(h, forced_time * scales_.time);
    restep(forced);
    add_piece(pieces);
    finish(forced, false, book);
    return;
  }
  const std::optional<Crossing> crossing = search_.first({&dense_, h, &range_});
  note_given_up(book);
  const double until = crossing ? crossing->share : 1.0;
  std::optional<double> release;
  if (pull_ < 0.0) {
    release = closed_.redundant()
                  ? releases_.first_opening(dense_, until, next_, scales_.gravity, closed_, book)
                  : releases_.first_release(dense_, until, next_, holds_, closed_);
  }
  if (!crossing && !release) {
    add_piece(pieces);
    finish(h, false, book);
    return;
  }
  const double length = release ? reach_release(*release * h) : reach_crossing(*crossing, h);
  add_piece(pieces);
  finish(length, true, book);
}

void EventMotion::note_given_up(Bookkeeping& book) {
  book.audit.searches_given_up += search_.given_up() - given_up_;
  given_up_ = search_.given_up();
}

/// Takes the step, shortened until its error is small enough; returns its length.
double EventMotion::controlled_step(double h, Bookkeeping& book) {
  const bool cut = h < step_;
  double error = 0.0;
  bool rejected = false;
  while (true) {
    pull_ = std::numeric_limits<double>::infinity();
    method_.step(*this, y_, rate_, h);
    error = method_.error(scale_);
    if (error <= 1.0) break;
    if (h <= shortest_step * scales_.time) {
      // Rows that nearly depend on one another: accelerations are no smooth function any more.
      ++book.audit.wedged;
      closure_.wedged = true;
      break;
    }
    rejected = true;
    h *= std::isfinite(error) ? std::max(most_shrinking, safety * eighth_root_inverse(error))
                              : most_shrinking;
  }
  const double growth =
      error > 0.0 ? std::min(most_growth, safety * eighth_root_inverse(error)) : most_growth;
  const double proposed = h * (rejected ? std::min(growth, 1.0) : growth);
  // A step that was cut short says nothing against the length that was proposed before.
  step_ = cut && !rejected ? std::max(step_, proposed) : proposed;
  return h;
}

/// The end of the step that was just taken, on the constraints, and its polynomial.
void EventMotion::complete_step(double h) {
  next_ = state_;
  unpack(method_.next(), next_);
  closed_.project_positions(next_);
  closed_.project_velocities(next_);
  pack(next_, next_y_);
  (*this)(next_y_, next_rate_);
  next_holds_ = holds_;
  next_holds_.arm(closed_);
  method_.dense(*this, y_, next_rate_, dense_);
  range_.resize(state_.size());
  for (std::size_t i = 0; i < range_.size(); ++i) {
    const std::size_t at = components * i + components / 2;
    TwistRange& range = range_[i];
    const auto twist = [&](const std::vector<double>& rate) {
      return Twist{Vec2(rate[at], rate[at + 1]), rate[at + 2]};
    };
    range.low = range.high = twist(next_rate_);
    for (int k = 0; k < Dop853::stages; ++k) {
      const Twist a = twist(method_.stage(k));
      range.low = {range.low.linear.cwiseMin(a.linear), std::min(range.low.angular, a.angular)};
      range.high = {range.high.linear.cwiseMax(a.linear), std::max(range.high.angular, a.angular)};
    }
  }
  length_ = h;
}

/// The step again, with another length.
void EventMotion::restep(double length) {
  method_.step(*this, y_, rate_, length);
  complete_step(length);
}

/// Steps to where a watched function vanishes: Newton's method on true states.
double EventMotion::reach_crossing(const Crossing& crossing, double h) {
  double length = crossing.share * h;
  for (int k = 0; k < most_corrections; ++k) {
    restep(length);
    const Reading reading = search_.read(next_, crossing.watch);
    if (reading.rate == 0.0) break;
    const double correction = -reading.value / reading.rate;
    if (std::abs(correction) <= moved_share * scales_.time && length + correction > 0.0) {
      next_ = moved(next_, correction);
      return length + correction;
    }
    if (std::abs(correction) > 0.01 * h || length + correction <= 0.0) break;
    length += correction;
  }
  return length_;
}

/// Steps to where the smallest force vanishes.
double EventMotion::reach_release(double length) {
  for (int k = 0; k < most_corrections; ++k) {
    restep(length);
    if (closed_.redundant()) break;
    const double force = releases_.hold_at(next_, holds_, closed_);
    const double ahead = 1e-6 * scales_.time;
    const double rate = (releases_.hold_at(moved(next_, ahead), holds_, closed_) - force) / ahead;
    if (rate >= 0.0) break;
    const double correction = -force / rate;
    if (std::abs(correction) <= moved_share * scales_.time && length + correction > 0.0) {
      next_ = moved(next_, correction);
      return length + correction;
    }
    if (std::abs(correction) > 0.01 * length_ || length + correction <= 0.0) break;
    length += correction;
  }
  return length_;
}

/// The state at the end of the step, a moment later, by its rates.
State EventMotion::moved(State state, double time) const {
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double* r = next_rate_.data() + components * i;
    state[i].position += time * Vec2(r[0], r[1]) + 0.5 * time * time * Vec2(r[3], r[4]);
    state[i].angle += time * r[2] + 0.5 * time * time * r[5];
    state[i].velocity += time * Vec2(r[3], r[4]);
    state[i].spin += time * r[5];
  }
  return state;
}

void EventMotion::add_piece(std::deque<MotionPiece>& pieces) const {
  pieces.push_back(
      {MotionPiece::Kind::smooth, clock_, length_, state_, dense_, closed_.contacts(), {}});
}

/// Takes over the state that was reached.
void EventMotion::finish(double elapsed, bool event, Bookkeeping& book) {
  clock_ += elapsed;
  state_ = next_;
  if (event) {
    ++events_;
    instant_events_ = elapsed <= instant_share * scales_.time ? instant_events_ + 1 : 0;
    begin_phase({}, book);
    return;
  }
  instant_events_ = 0;
  search_.passed(state_);
  holds_ = next_holds_;
  pack(state_, y_);
  if (closed_.contacts().empty()) {
    (*this)(y_, rate_);
  } else {
    rate_ = next_rate_;
  }
}

State EventMotion::look(const MotionPiece& piece, double t) {
  State state = piece.start;
  if (t <= piece.begin) return state;
  look_at(piece.motion, (t - piece.begin) / piece.length, state);
  if (!piece.closed.empty()) {
    looker_.close(piece.closed, {});
    looker_.project_positions(state);
    looker_.project_velocities(state);
  }
  return state;
}

}  // namespace wuerfel
