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

/// Bounds of second derivatives, taken from the stages of a step, with this much in reserve.
constexpr double reserve = 1.5;

/// Shares of a step closer than this are one moment.
constexpr double same_share = 1e-14;
/// A bracket this narrow is left to the steps that polish it.
constexpr double found_share = 1e-13;
constexpr int most_intervals = 4000;

/// A plane is looked at as a box without extent, whose side of this number faces out.
constexpr int plane_side = 2;

double larger(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

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
  return {make_box(s.position, s.angle, b.size), s.velocity, s.spin};
}

MovingBox EventSearch::body_at(const WatchedStep& step, int body, double share) const {
  if (!system_->is_cube(body)) return body_of({}, body);
  const std::size_t at = components * static_cast<std::size_t>(body);
  const auto value = [&](std::size_t k) { return step.motion->component(share, at + k); };
  return {make_box({value(0), value(1)}, value(2), system_->body(body).size),
          {value(3), value(4)},
          value(5)};
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

double EventSearch::curvature(const WatchedStep& step, const Watch& watch) const {
  struct Bound {
    Vec2 position_0 = Vec2::Zero(), position_1 = Vec2::Zero();
    Vec2 velocity_0 = Vec2::Zero(), velocity_1 = Vec2::Zero();
    TwistRange range;
    double spin = 0.0, turn = 0.0, radius = 0.0;
  };
  const auto bound = [&](int body) {
    Bound b;
    const Body& of = system_->body(body);
    if (!system_->is_cube(body)) {
      b.position_0 = b.position_1 = of.kind == BodyKind::plane ? of.point : of.box.center;
      return b;
    }
    const std::size_t at = components * static_cast<std::size_t>(body);
    const auto value = [&](double share, std::size_t k) {
      return step.motion->component(share, at + k);
    };
    b.position_0 = {value(0.0, 0), value(0.0, 1)};
    b.position_1 = {value(1.0, 0), value(1.0, 1)};
    b.velocity_0 = {value(0.0, 3), value(0.0, 4)};
    b.velocity_1 = {value(1.0, 3), value(1.0, 4)};
    b.range = (*step.range)[static_cast<std::size_t>(body)];
    b.turn = larger(b.range.low.angular, b.range.high.angular);
    b.spin = larger(value(0.0, 5), value(1.0, 5)) + 0.5 * step.length * b.turn;
    b.radius = 0.5 * of.size.norm();
    return b;
  };
  const Bound p = bound(watch.on);
  const Bound q = bound(watch.from);
  const Vec2 a(larger(p.range.high.linear.x() - q.range.low.linear.x(),
                      q.range.high.linear.x() - p.range.low.linear.x()),
               larger(p.range.high.linear.y() - q.range.low.linear.y(),
                      q.range.high.linear.y() - p.range.low.linear.y()));
  const double spin = std::max(p.spin, q.spin);
  const double turn = std::max(p.turn, q.turn);
  const double radius = std::max(p.radius, q.radius);
  const double speed =
      std::max((p.velocity_0 - q.velocity_0).norm(), (p.velocity_1 - q.velocity_1).norm())
      + 0.5 * step.length * a.norm();
  // Between a plane and a cube only the cube turns: its distance from the plane's point is not
  // felt.
  const bool turning_frame = watch.kind == Watch::Kind::separation || system_->is_cube(watch.from);
  const double distance = turning_frame ? std::max((p.position_0 - q.position_0).norm(),
                                                   (p.position_1 - q.position_1).norm())
                                              + 0.5 * step.length * speed + radius
                                        : 0.0;
  const double centers = a.norm() + (turn + spin * spin) * radius;
  return reserve
         * (centers + 2.0 * spin * (speed + spin * radius) * (turning_frame ? 1.0 : 0.0)
            + (spin * spin + turn) * distance);
}

void EventSearch::search(const WatchedStep& step, Watch& watch, std::optional<Crossing>& first) {
  const bool pair = watch.kind == Watch::Kind::separation;
  const double length = step.length;
  const double curve = std::max(curvature(step, watch) * length * length, 1e-300);
  const double armed = armed_times * zero(watch);
  const auto look_at = [&](double share) {
    const MovingBox on = body_at(step, watch.on, share);
    const MovingBox from = body_at(step, watch.from, share);
    if (pair) return look_at_separation(from, on, share);
    Look look;
    look.share = share;
    look.reading = read_corner(on, watch.corner, from, watch.side, watch.kind);
    return look;
  };
  double shift = watch.shift;
  const auto scaled = [&](const Look& look) {
    return Reading{look.reading.value + shift, look.reading.rate * length};
  };
  const auto clear = [&](const Look& a, const Look& b) {
    const double width = b.share - a.share;
    if (!pair) return no_zero_between(scaled(a), scaled(b), width, curve);
    return side_stays_clear(a, b, a.pair_side, shift, length, curve)
           || (b.pair_side != a.pair_side
               && side_stays_clear(a, b, b.pair_side, shift, length, curve));
  };
  std::vector<std::pair<Look, Look>> open;
  open.emplace_back(look_at(0.0), look_at(first ? first->share : 1.0));
  for (int count = 0; !open.empty(); ++count) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (a.reading.value > armed) shift = 0.0;
    const double width = b.share - a.share;
    const bool crossed = b.reading.value + shift <= 0.0;
    if (!crossed && clear(a, b)) continue;
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
    const Reading low = scaled(a);
    const Reading high = scaled(b);
    const bool falls = crossed && low.rate < 0.0 && high.rate < 0.0
                       && std::min(-low.rate, -high.rate) > curve * width;
    if (falls && count % 4 != 3) {
      const double newton =
          count % 2 == 0 ? b.share - high.value / high.rate : a.share - low.value / low.rate;
      const double beside = newton + (count % 2 == 0 ? -0.25 : 0.25) * found_share;
      if (beside > a.share && beside < b.share) at = beside;
    }
    const Look middle = look_at(at);
    const bool left = middle.reading.value + shift <= 0.0;
    if (!left) open.emplace_back(middle, b);
    if (left || !falls) open.emplace_back(a, middle);
  }
  watch.shift = shift;
}

std::optional<Crossing> EventSearch::first(const WatchedStep& step) {
  std::optional<Crossing> found;
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
