#include "core/time/watch.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// The corner of `b` nearest to side e of `a`.
int nearest_to_side(const Box& a, int e, const Box& b) {
  const Vec2 n = a.normal(e);
  int best = 0;
  double least = n.dot(b.arm[0]);
  for (int k = 1; k < 4; ++k) {
    const double height = n.dot(b.arm[static_cast<std::size_t>(k)]);
    if (height < least) {
      least = height;
      best = k;
    }
  }
  return best;
}

/// One of the eight sides of a pair: 0 .. 3 of the first body, 4 .. 7 of the second.
struct PairSide {
  const MovingBox* from;
  const MovingBox* on;
  int side;
};

PairSide side_of_pair(const Look& look, int index) {
  if (index < 4) return {&look.from, &look.on, index};
  return {&look.on, &look.from, index - 4};
}

}  // namespace

Reading read_corner(
    const MovingBox& b, int corner, const MovingBox& a, int side, Watch::Kind kind) {
  const Vec2 r = b.box.arm[static_cast<std::size_t>(corner)];
  const Vec2 d = (b.box.center - a.box.center) + r;
  const Vec2 d_rate = b.velocity - a.velocity + b.spin * perp(r);
  const Vec2 n = a.box.normal(side);
  if (kind == Watch::Kind::gap || kind == Watch::Kind::separation) {
    return {n.dot(d) - a.box.reach(side), n.dot(d_rate) + a.spin * perp(n).dot(d)};
  }
  // From p_i to p_j: the normal is perp(p_j - p_i).
  const Vec2 t = -perp(n);
  const Reading along{t.dot(d), t.dot(d_rate) + a.spin * perp(t).dot(d)};
  const double half = 0.5 * a.box.length(side);
  if (kind == Watch::Kind::to_start) return {half + along.value, along.rate};
  return {half - along.value, -along.rate};
}

// The first zero that is possible after the one end must lie beyond the last that is possible
// before the other.
bool no_zero_between(const Reading& a, const Reading& b, double width, double curvature) {
  if (a.value <= 0.0 || b.value <= 0.0) return false;
  if (curvature * width * width <= 1e-12 * std::min(a.value, b.value) && a.rate * width > -a.value
      && b.rate * width < b.value)
    return true;
  const double after =
      (a.rate + std::sqrt(a.rate * a.rate + 2.0 * curvature * a.value)) / curvature;
  const double before =
      (-b.rate + std::sqrt(b.rate * b.rate + 2.0 * curvature * b.value)) / curvature;
  return after + before >= width;
}

bool side_stays_clear(
    const Look& a, const Look& b, int index, double shift, double length, double curvature) {
  const double width = b.share - a.share;
  const PairSide at_a = side_of_pair(a, index);
  const PairSide at_b = side_of_pair(b, index);
  for (int k = 0; k < 4; ++k) {
    Reading from = read_corner(*at_a.on, k, *at_a.from, at_a.side, Watch::Kind::gap);
    Reading to = read_corner(*at_b.on, k, *at_b.from, at_b.side, Watch::Kind::gap);
    from = {from.value + shift, from.rate * length};
    to = {to.value + shift, to.rate * length};
    if (!no_zero_between(from, to, width, curvature)) return false;
  }
  return true;
}

Look look_at_separation(const MovingBox& from, const MovingBox& on, double share) {
  Look look;
  look.share = share;
  look.from = from;
  look.on = on;
  double best = side_separation(from.box, 0, on.box);
  for (int index = 1; index < 8; ++index) {
    const PairSide s = side_of_pair(look, index);
    const double here = side_separation(s.from->box, s.side, s.on->box);
    if (here > best) {
      best = here;
      look.pair_side = index;
    }
  }
  const PairSide s = side_of_pair(look, look.pair_side);
  look.reading = read_corner(*s.on, nearest_to_side(s.from->box, s.side, s.on->box), *s.from,
                             s.side, Watch::Kind::gap);
  return look;
}

}  // namespace wuerfel
