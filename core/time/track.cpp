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
constexpr long most_events_and_cubes = 750;
/// With `--integrator event`: beyond this the motion would not get on.
constexpr long most_events_ever = 1000;
constexpr int most_patience = 32;
/// Steps per frame where the user did not choose them.
constexpr double steps_per_frame = 2.0;
/// A step is halved where energy rises by more than this share of what the group has in motion, but
/// not below a sixteenth; what energy still rises is taken from the velocities.
constexpr double rise_share = 1e-4;
constexpr double shortest_share = 1.0 / 16.0;
/// It is halved, twice at most, where it leaves more overlap than this share of a side.
constexpr double overlap_share = 1e-9;
constexpr double shortest_for_overlap = 0.25;
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
    : system_(&system),
      settings_(settings),
      events_(system, settings),
      stepper_(system, settings),
      looker_(system, settings) {}

void Track::start(const State& state,
                  double t,
                  double touching,
                  std::vector<char> resting,
                  const Stepping& stepping) {
  scales_ = scales_of(*system_, state);
  pieces_.clear();
  patience_ = stepping.patience;
  handed_back_ = t;
  frame_events_ = 0;
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
  const double frame = scales_.time / frames_per_time;
  until_ = always ? std::numeric_limits<double>::infinity() : std::max(stepping.until, t + frame);
  step_ = always ? settings_.step : frame / steps_per_frame;
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
  events_.advance(limit, pieces_, book_);
  count_events();
}

void Track::count_events() {
  if (events_.at_rest()) return;
  const double frame = scales_.time / frames_per_time;
  const auto now = static_cast<long>(std::floor(events_.clock() / frame));
  if (now != frame_) {
    frame_ = now;
    frame_events_ = 0;
  }
  frame_events_ += events_.events() - last_events_;
  last_events_ = events_.events();
  if (events_.wedged() || frame_events_ > affordable_events()) hand_over();
}

long Track::affordable_events() const {
  if (settings_.integrator == Integrator::event) return most_events_ever;
  return std::clamp(most_events_and_cubes / std::max(1, system_->cubes), fewest_events,
                    patience_ > 1 ? most_events_again : most_events);
}

void Track::hand_over() {
  const double frame = scales_.time / frames_per_time;
  clock_ = events_.clock();
  state_ = events_.state();
  // Soon after the last time: longer. After a long time without: as at first.
  if (clock_ - handed_back_ > most_patience * frame) patience_ = 1;
  until_ = (std::floor(clock_ / frame) + 1.0 + patience_) * frame;
  patience_ = std::min(2 * patience_, most_patience);
  step_ = frame / steps_per_frame;
  stepping_ = true;
  ++book_.cost.hand_overs;
}

void Track::step(double limit) {
  const double end = std::min(limit, until_);
  const double whole = std::min({step_, stepper_.longest_step(state_), end - clock_});
  double h = end - clock_ - whole < same_time * scales_.time ? end - clock_ : whole;
  const double shortest = h * shortest_share;
  const double shortest_clean = h * shortest_for_overlap;
  Bookkeeping before = book_;
  State next = state_;
  const double moving = kinetic_energy(*system_, state_) + scales_.weight * scales_.length;
  while (true) {
    next = state_;
    const double rise = stepper_.step(next, clock_, h, book_);
    const bool clean = stepper_.overlap_left() <= overlap_share || h <= shortest_clean;
    if ((rise <= rise_share * moving && clean) || h <= shortest) {
      if (rise > 0.0) {
        // J v >= 0 stays true for a share of v.
        const double kinetic = kinetic_energy(*system_, next);
        const double share = kinetic > rise ? std::sqrt(1.0 - rise / kinetic) : 0.0;
        for (BodyState& s : next) {
          s.velocity *= share;
          s.spin *= share;
        }
      }
      break;
    }
    const Cost cost = book_.cost;
    book_ = before;
    book_.cost = cost;
    h *= 0.5;
  }
  pieces_.push_back({MotionPiece::Kind::stepped, clock_, h, state_, {}, {}});
  state_ = std::move(next);
  clock_ = h == end - clock_ ? end : clock_ + h;
  if (clock_ >= until_) hand_back();
}

void Track::hand_back() {
  stepper_.close_gaps(state_);
  handed_back_ = clock_;
  last_events_ = 0;
  frame_events_ = 0;
  stepping_ = false;
  events_.start(state_, clock_, {touching_share, rest_speed}, {}, book_);
  if (events_.wedged()) hand_over();
}

State Track::at(double t) {
  if (t >= clock()) return stepping_ ? state_ : events_.state();
  auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), t,
                                [](double time, const MotionPiece& p) { return time < p.begin; });
  if (piece == pieces_.begin()) return stepping_ ? state_ : events_.state();
  --piece;
  if (t <= piece->begin || piece->kind == MotionPiece::Kind::rest) return piece->start;
  if (piece->kind == MotionPiece::Kind::smooth) return events_.look(*piece, t);
  State state = piece->start;
  const double dt = t - piece->begin;
  if (dt < same_time * scales_.time) {
    for (BodyState& s : state) {
      s.position += dt * s.velocity;
      s.angle += dt * s.spin;
    }
    return state;
  }
  Bookkeeping aside;
  looker_.step(state, piece->begin, t - piece->begin, aside);
  return state;
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
