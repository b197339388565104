#include "core/time/events/watch.h"

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
    const double height = n.dot(b.arm[k]);
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
  const Vec2 r = b.box.arm[corner];
  const Vec2 d = (b.box.center - a.box.center) + r;
  const Vec2 d_1 = b.velocity - a.velocity + b.spin * perp(r);
  const Vec2 d_2 = b.acceleration.linear - a.acceleration.linear + b.acceleration.angular * perp(r)
                   - b.spin * b.spin * r;
  // Along a vector that turns with the side.
  const auto along = [&](const Vec2& n) {
    const Vec2 n_1 = perp(n);
    return Reading{n.dot(d), n.dot(d_1) + a.spin * n_1.dot(d),
                   n.dot(d_2) + 2.0 * a.spin * n_1.dot(d_1) + a.acceleration.angular * n_1.dot(d)
                       - a.spin * a.spin * n.dot(d)};
  };
  const Vec2 n = a.box.normal(side);
  if (kind == Watch::Kind::gap || kind == Watch::Kind::separation) {
    Reading gap = along(n);
    gap.value -= a.box.reach(side);
    return gap;
  }
  // From p_i to p_j: the normal is perp(p_j - p_i).
  const double half = 0.5 * a.box.length(side);
  Reading rest = along(kind == Watch::Kind::to_start ? Vec2(-perp(n)) : perp(n));
  rest.value += half;
  return rest;
}

Reading read_pair_side(const Look& look, int pair_side, int k) {
  const PairSide s = side_of_pair(look, pair_side);
  return read_corner(*s.on, k, *s.from, s.side, Watch::Kind::gap);
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
