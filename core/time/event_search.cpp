#include "core/time/event_search.h"

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

/// A plane is looked at as a box without extent, whose side of this number faces out.
constexpr int plane_side = 2;

double larger(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

/// A reading with its shift, in units of a step of `length` s.
Reading scaled(const Reading& r, double shift, double length) {
  return {r.value + shift, r.rate * length, r.bend * length * length};
}

}  // namespace

EventSearch::EventSearch(const System& system) : system_(&system) {}

double EventSearch::zero(const Watch& watch) const {
  const Body& on = system_->body(watch.on);
  const Body& from = system_->body(watch.from);
  const double scale = from.kind == BodyKind::plane
                           ? on.size.minCoeff()
                           : std::min(on.size.minCoeff(), from.size.minCoeff());
  return std::max(zero_share * scale, rounding_);
}

bool EventSearch::is_still(int body) const {
  return !system_->is_cube(body)
         || (!resting_.empty() && resting_[static_cast<std::size_t>(body)] != 0);
}

MovingBox EventSearch::body_of(const State& state, int body) const {
  const Body& b = system_->body(body);
  if (!system_->is_cube(body)) {
    MovingBox fixed;
    fixed.box = b.box;
    if (b.kind == BodyKind::plane) {
      fixed.box.center = b.point;
      fixed.box.axis = -perp(b.normal);
    }
    return fixed;
  }
  const BodyState& s = state[static_cast<std::size_t>(body)];
  return {make_box(s.position, s.angle, b.size), s.velocity, s.spin, {}};
}

MovingBox EventSearch::body_at(const WatchedStep& step, int body, double share) const {
  if (!system_->is_cube(body)) return body_of({}, body);
  const std::size_t at = components * static_cast<std::size_t>(body);
  const auto value = [&](std::size_t k) { return step.motion->component(share, at + k); };
  const auto rate = [&](std::size_t k) { return step.motion->slope(share, at + k) / step.length; };
  return {make_box({value(0), value(1)}, value(2), system_->body(body).size),
          {value(3), value(4)},
          value(5),
          {Vec2(rate(3), rate(4)), rate(5)}};
}

/// Where all bodies are at the ends of a step.
void EventSearch::find_ends(const WatchedStep& step) {
  begin_.clear();
  end_.clear();
  for (int i = 0; i < system_->count(); ++i) {
    begin_.push_back(body_at(step, i, 0.0));
    end_.push_back(system_->is_cube(i) ? body_at(step, i, 1.0) : begin_.back());
  }
}

Look EventSearch::look_at(const WatchedStep& step, const Watch& watch, double share) const {
  const auto at = [&](int body) {
    const auto i = static_cast<std::size_t>(body);
    return share == 0.0 || !system_->is_cube(body) ? begin_[i]
           : share == 1.0                          ? end_[i]
                                                   : body_at(step, body, share);
  };
  if (watch.kind == Watch::Kind::separation)
    return look_at_separation(at(watch.from), at(watch.on), share);
  Look look;
  look.share = share;
  look.on = at(watch.on);
  look.from = at(watch.from);
  look.reading = read_corner(look.on, watch.corner, look.from, watch.side, watch.kind);
  return look;
}

/// Bounds between two looks, in units of the step, for sides of `from`; `swapped`: of `on`.
GapBounds EventSearch::bounds_of(
    const WatchedStep& step, const Watch& watch, const Look& a, const Look& b, bool swapped) const {
  const auto travel = [&](int body, const MovingBox& begin, const MovingBox& end) {
    const bool still = is_still(body);
    return Travel{&begin, &end,
                  still ? TwistRange{} : (*step.range)[static_cast<std::size_t>(body)], still};
  };
  const Travel on = travel(watch.on, a.on, b.on);
  const Travel from = travel(watch.from, a.from, b.from);
  const double h = step.length;
  const double part = (b.share - a.share) * h;
  GapBounds bounds = swapped ? bounds_of_gap(from, on, part, h) : bounds_of_gap(on, from, part, h);
  bounds.bend *= h * h;
  bounds.jerk *= h * h * h;
  return bounds;
}

/// Whether the side `pair_side` keeps all corners of the other body outside between two looks.
bool EventSearch::side_stays_clear(const WatchedStep& step,
                                   const Watch& watch,
                                   const Look& a,
                                   const Look& b,
                                   int pair_side,
                                   double shift) const {
  const GapBounds bounds = bounds_of(step, watch, a, b, pair_side >= 4);
  for (int k = 0; k < 4; ++k) {
    const Reading from = scaled(read_pair_side(a, pair_side, k), shift, step.length);
    const Reading to = scaled(read_pair_side(b, pair_side, k), shift, step.length);
    if (!no_zero_between(from, to, b.share - a.share, bounds)) return false;
  }
  return true;
}

bool EventSearch::stays_positive(
    const WatchedStep& step, const Watch& watch, const Look& a, const Look& b, double shift) const {
  if (watch.kind == Watch::Kind::separation) {
    return side_stays_clear(step, watch, a, b, a.pair_side, shift)
           || (b.pair_side != a.pair_side
               && side_stays_clear(step, watch, a, b, b.pair_side, shift));
  }
  return no_zero_between(scaled(a.reading, shift, step.length),
                         scaled(b.reading, shift, step.length), b.share - a.share,
                         bounds_of(step, watch, a, b, false));
}

Reading EventSearch::read(const State& state, const Watch& watch) const {
  const MovingBox on = body_of(state, watch.on);
  const MovingBox from = body_of(state, watch.from);
  Reading reading = watch.kind == Watch::Kind::separation
                        ? look_at_separation(from, on, 0.0).reading
                        : read_corner(on, watch.corner, from, watch.side, watch.kind);
  reading.value += watch.shift;
  return reading;
}

void EventSearch::begin(const State& state,
                        const std::vector<Contact>& closed,
                        const std::vector<char>& resting) {
  resting_ = resting;
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
    const Box& box = boxes[static_cast<std::size_t>(i)];
    const Vec2 extent = box.arm[2].cwiseAbs().cwiseMax(box.arm[1].cwiseAbs())
                        + Vec2::Constant(4.0 * zero_share * box.smaller_side());
    bounds_.push_back({box.center - extent, box.center + extent});
  }
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(bounds_)) {
    if (is_still(pair.first) && is_still(pair.second)) continue;
    if (std::ranges::binary_search(closed_pairs_, pair)) continue;
    Watch watch{Watch::Kind::separation, pair.first, pair.second, 0, 0, 0.0};
    const double start = separation(boxes[static_cast<std::size_t>(pair.first)],
                                    boxes[static_cast<std::size_t>(pair.second)]);
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
      if (is_still(i)) continue;
      for (int k = 0; k < 4; ++k) {
        if (!std::ranges::binary_search(on_planes, ContactId{i, p, k, 0}))
          watches_.push_back({Watch::Kind::gap, i, p, k, plane_side, 0.0});
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
    const double radius = 0.5 * body.size.norm();
    if (!system_->is_cube(i)) {
      const Vec2 extent = body.box.arm[2].cwiseAbs().cwiseMax(body.box.arm[1].cwiseAbs());
      bounds_.push_back({body.box.center - extent, body.box.center + extent});
      continue;
    }
    const std::size_t at = components * static_cast<std::size_t>(i);
    const Vec2 start(step.motion->component(0.0, at), step.motion->component(0.0, at + 1));
    const Vec2 end(step.motion->component(1.0, at), step.motion->component(1.0, at + 1));
    const TwistRange& range = (*step.range)[static_cast<std::size_t>(i)];
    const Vec2 a(larger(range.low.linear.x(), range.high.linear.x()),
                 larger(range.low.linear.y(), range.high.linear.y()));
    // A path leaves its chord by no more than a h^2 / 8.
    const Vec2 extent =
        Vec2::Constant(radius * (1.0 + 1e-9)) + (reserve / 8.0) * step.length * step.length * a;
    bounds_.push_back({start.cwiseMin(end) - extent, start.cwiseMax(end) + extent});
  }
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(bounds_)) {
    if (is_still(pair.first) && is_still(pair.second)) continue;
    if (std::ranges::binary_search(closed_pairs_, pair)) continue;
    candidates_.push_back({Watch::Kind::separation, pair.first, pair.second, 0, 0, 0.0});
  }
}

void EventSearch::search(const WatchedStep& step, Watch& watch, std::optional<Crossing>& first) {
  const double length = step.length;
  const double armed = armed_times * zero(watch);
  double shift = watch.shift;
  std::vector<std::pair<Look, Look>> open;
  open.emplace_back(look_at(step, watch, 0.0), look_at(step, watch, first ? first->share : 1.0));
  for (int count = 0; !open.empty(); ++count) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (a.reading.value > armed) shift = 0.0;
    const double width = b.share - a.share;
    const bool crossed = b.reading.value + shift <= 0.0;
    if (!crossed && stays_positive(step, watch, a, b, shift)) continue;
    if (crossed && width <= found_share) {
      first = Crossing{b.share, watch};
      first->watch.shift = shift;
      return;
    }
    if (width <= same_share) continue;  // grazes zero
    if (count > most_intervals) {
      ++given_up_;
      if (crossed) {
        first = Crossing{b.share, watch};
        first->watch.shift = shift;
      }
      return;
    }
    // Where the function only falls, Newton's steps from the far end close the bracket; bisection
    // goes on wherever they do not help.
    double at = 0.5 * (a.share + b.share);
    const Reading low = scaled(a.reading, shift, length);
    const Reading high = scaled(b.reading, shift, length);
    const bool falls = crossed && low.rate < 0.0 && high.rate < 0.0
                       && std::min(-low.rate, -high.rate)
                              > bounds_of(step, watch, a, b, a.pair_side >= 4).bend * width;
    if (falls && count % 4 != 3) {
      const double newton =
          count % 2 == 0 ? b.share - high.value / high.rate : a.share - low.value / low.rate;
      const double beside = newton + (count % 2 == 0 ? -0.25 : 0.25) * found_share;
      if (beside > a.share && beside < b.share) at = beside;
    }
    const Look middle = look_at(step, watch, at);
    const bool left = middle.reading.value + shift <= 0.0;
    if (!left) open.emplace_back(middle, b);
    if (left || !falls) open.emplace_back(a, middle);
  }
  watch.shift = shift;
}

std::optional<Crossing> EventSearch::first(const WatchedStep& step) {
  std::optional<Crossing> found;
  find_ends(step);
  for (const Watch& watch : watches_) {
    Watch copy = watch;
    search(step, copy, found);
  }
  find_candidates(step);
  for (Watch& watch : candidates_) {
    for (const Watch& unarmed : unarmed_) {
      if (unarmed.same_place(watch)) watch.shift = unarmed.shift;
    }
    search(step, watch, found);
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
