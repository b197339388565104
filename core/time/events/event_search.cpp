#include "core/time/events/event_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/model/system.h"

namespace wuerfel {
namespace {

/// What starts nearer to zero than this share of the smaller side is watched from where it has left
/// zero by three times as much.
constexpr double zero_share = 1e-10;
constexpr double armed_times = 3.0;

/// Accelerations, taken from the stages of a step, have this much in reserve.
constexpr double reserve = 1.5;

/// Shares of a step closer than this are one moment.
constexpr double same_share = 1e-14;
/// A bracket this narrow is left to the steps that polish it.
constexpr double found_share = 1e-13;
constexpr int most_intervals = 4000;

double larger(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

}  // namespace

EventSearch::EventSearch(const System& system) : system_(&system), view_(system) {}

double EventSearch::zero(const Watch& watch) const {
  const double scale =
      std::min(system_->body(watch.on).smaller_side(), system_->body(watch.from).smaller_side());
  return std::max(zero_share * scale, rounding_);
}

Reading EventSearch::read(const State& state, const Watch& watch) const {
  const MovingBox on = view_.body_of(state, watch.on);
  const MovingBox from = view_.body_of(state, watch.from);
  Reading reading = watch.kind == Watch::Kind::separation
                        ? look_at_separation(from, on, 0.0).reading
                        : read_corner(on, watch.corner, from, watch.side, watch.kind);
  reading.value += watch.shift;
  return reading;
}

void EventSearch::begin(const State& state,
                        const std::vector<Contact>& closed,
                        const std::vector<char>& resting) {
  view_.set_resting(resting);
  rounding_ = 0.0;
  for (const BodyState& s : state)
    rounding_ = std::max(rounding_, gap_rounding(s.position, s.position));
  watches_.clear();
  unarmed_.clear();
  closed_pairs_.clear();
  watch_closed(closed);
  watch_planes(closed);
  for (Watch& watch : watches_) {
    const double start = read(state, watch).value;
    if (start <= armed_times * zero(watch)) watch.shift = zero(watch) + std::max(0.0, -start);
  }
  // Pairs that touch without being closed: they open, and may come back.
  std::vector<Box> boxes;
  pose_boxes(*system_, state, boxes);
  bounds_.clear();
  for (int i = 0; i < system_->count() && system_->body(i).kind != BodyKind::plane; ++i) {
    const Box& box = boxes[i];
    const Vec2 extent = box.extent() + Vec2::Constant(4.0 * zero_share * box.smaller_side());
    bounds_.push_back({box.center - extent, box.center + extent});
  }
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(bounds_)) {
    if (view_.is_still(pair.first) && view_.is_still(pair.second)) continue;
    if (std::ranges::binary_search(closed_pairs_, pair)) continue;
    Watch watch{Watch::Kind::separation, pair.first, pair.second, 0, 0, 0.0};
    const double start = separation(boxes[pair.first], boxes[pair.second]);
    if (start > armed_times * zero(watch)) continue;
    watch.shift = zero(watch) + std::max(0.0, -start);
    unarmed_.push_back(watch);
  }
}

void EventSearch::watch_closed(const std::vector<Contact>& closed) {
  for (const Contact& c : closed) {
    if (system_->body(c.from).kind == BodyKind::plane) continue;
    const IndexPair pair = std::minmax(c.on, c.from);
    int of_pair = 0;
    for (const Contact& d : closed) {
      if (IndexPair(std::minmax(d.on, d.from)) == pair) ++of_pair;
    }
    closed_pairs_.push_back(pair);
    const auto add = [&](Watch::Kind kind, int corner) {
      watches_.push_back({kind, c.on, c.from, corner, c.side, 0.0});
    };
    if (of_pair == 1) {
      add(Watch::Kind::gap, next_corner(c.corner));
      add(Watch::Kind::gap, (c.corner + 3) & 3);
      add(Watch::Kind::to_start, c.corner);
      add(Watch::Kind::to_end, c.corner);
      continue;
    }
    // Flush: both corners of one side on the line of the other. The sides run in opposite senses,
    // so that the corner with the smaller number (but for the turn from 3 to 0) comes first along
    // c.side.
    const bool first = std::ranges::any_of(closed, [&](const Contact& d) {
      return d.on == c.on && d.from == c.from && d.corner == next_corner(c.corner);
    });
    add(first ? Watch::Kind::to_end : Watch::Kind::to_start, c.corner);
  }
  std::ranges::sort(closed_pairs_);
}

void EventSearch::watch_planes(const std::vector<Contact>& closed) {
  std::vector<ContactId> on_planes;
  for (const Contact& c : closed) {
    if (system_->body(c.from).kind == BodyKind::plane) on_planes.push_back(c.id());
  }
  std::ranges::sort(on_planes);
  for (int p = 0; p < system_->count(); ++p) {
    if (system_->body(p).kind != BodyKind::plane) continue;
    for (int i = 0; i < system_->cubes; ++i) {
      if (view_.is_still(i)) continue;
      for (int k = 0; k < 4; ++k) {
        if (!std::ranges::binary_search(on_planes, ContactId{i, p, k, 0}))
          watches_.push_back({Watch::Kind::gap, i, p, k, StepView::plane_side, 0.0});
      }
    }
  }
}

void EventSearch::find_candidates(const WatchedStep& step) {
  candidates_.clear();
  bounds_.clear();
  if (system_->cubes == 1 && system_->count() == 1) return;
  for (int i = 0; i < system_->count() && system_->body(i).kind != BodyKind::plane; ++i) {
    const Body& body = system_->body(i);
    const double radius = body.radius();
    if (!system_->is_cube(i)) {
      const Vec2 extent = body.box.extent();
      bounds_.push_back({body.box.center - extent, body.box.center + extent});
      continue;
    }
    const std::size_t at = components * i;
    const Vec2 start(step.motion->component(0.0, at), step.motion->component(0.0, at + 1));
    const Vec2 end(step.motion->component(1.0, at), step.motion->component(1.0, at + 1));
    const TwistRange& range = (*step.range)[i];
    const Vec2 a(larger(range.low.linear.x(), range.high.linear.x()),
                 larger(range.low.linear.y(), range.high.linear.y()));
    // A path leaves its chord by no more than a h^2 / 8.
    const Vec2 extent =
        Vec2::Constant(radius * (1.0 + 1e-9)) + (reserve / 8.0) * step.length * step.length * a;
    bounds_.push_back({start.cwiseMin(end) - extent, start.cwiseMax(end) + extent});
  }
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(bounds_)) {
    if (view_.is_still(pair.first) && view_.is_still(pair.second)) continue;
    if (std::ranges::binary_search(closed_pairs_, pair)) continue;
    candidates_.push_back({Watch::Kind::separation, pair.first, pair.second, 0, 0, 0.0});
  }
}

/// Whether a function that has crossed zero does nothing but fall between two looks.
bool EventSearch::only_falls(const Watch& watch, const Look& a, const Look& b) const {
  const Reading low = view_.in_steps(a.reading, 0.0);
  const Reading high = view_.in_steps(b.reading, 0.0);
  if (low.rate >= 0.0 || high.rate >= 0.0) return false;
  const double bend = view_.bounds_of(watch, a, b, a.pair_side >= 4).bend;
  return std::min(-low.rate, -high.rate) > bend * (b.share - a.share);
}

/// Where to look next: where the function only falls, Newton's steps from both ends close the
/// bracket; bisection goes on wherever they do not help.
double EventSearch::next_share(
    const Look& a, const Look& b, double shift, bool falls, int count) const {
  const double middle = 0.5 * (a.share + b.share);
  if (!falls || count % 4 == 3) return middle;
  const bool from_end = count % 2 == 0;
  const Look& start = from_end ? b : a;
  const Reading r = view_.in_steps(start.reading, shift);
  const double at = start.share - r.value / r.rate + (from_end ? -0.25 : 0.25) * found_share;
  return at > a.share && at < b.share ? at : middle;
}

void EventSearch::search(Watch& watch, std::optional<Crossing>& first) {
  const double armed = armed_times * zero(watch);
  double shift = watch.shift;
  const auto found_at = [&](double share) {
    first = Crossing{share, watch};
    first->watch.shift = shift;
  };
  open_.clear();
  open_.emplace_back(view_.look_at(watch, 0.0), view_.look_at(watch, first ? first->share : 1.0));
  for (int count = 0; !open_.empty(); ++count) {
    const auto [a, b] = open_.back();
    open_.pop_back();
    if (a.reading.value > armed) shift = 0.0;
    const double width = b.share - a.share;
    const bool crossed = b.reading.value + shift <= 0.0;
    if (!crossed && view_.stays_positive(watch, a, b, shift)) continue;
    if (crossed && width <= found_share) return found_at(b.share);
    if (width <= same_share) continue;  // grazes zero
    if (count > most_intervals) {
      ++given_up_;
      if (crossed) found_at(b.share);
      return;
    }
    const bool falls = crossed && only_falls(watch, a, b);
    const Look middle = view_.look_at(watch, next_share(a, b, shift, falls, count));
    const bool left = middle.reading.value + shift <= 0.0;
    if (!left) open_.emplace_back(middle, b);
    if (left || !falls) open_.emplace_back(a, middle);
  }
  watch.shift = shift;
}

std::optional<Crossing> EventSearch::first(const WatchedStep& step) {
  std::optional<Crossing> found;
  view_.set(step);
  for (const Watch& watch : watches_) {
    Watch copy = watch;
    search(copy, found);
  }
  find_candidates(step);
  for (Watch& watch : candidates_) {
    for (const Watch& unarmed : unarmed_) {
      if (unarmed.same_place(watch)) watch.shift = unarmed.shift;
    }
    search(watch, found);
  }
  return found;
}

void EventSearch::passed(const State& state) {
  for (Watch& watch : watches_) {
    if (watch.shift == 0.0) continue;
    if (read(state, watch).value - watch.shift > armed_times * zero(watch)) watch.shift = 0.0;
  }
  std::erase_if(unarmed_, [&](const Watch& watch) {
    return read(state, watch).value - watch.shift > armed_times * zero(watch);
  });
}

}  // namespace wuerfel
