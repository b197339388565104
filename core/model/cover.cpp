#include "core/model/cover.h"

#include <algorithm>

namespace wuerfel {
namespace {

/// Shares of the smaller side: a side is covered where a point this far outside of it lies in another body, whose
/// surface counts to it up to the second.
constexpr double outside_share = 1e-7;
constexpr double surface_share = 1e-9;

/// The part of [low, high] where `at_start` + alpha `slope` <= `limit`.
void clip(double at_start, double slope, double limit, double& low, double& high) {
  const double rest = limit - at_start;
  if (slope == 0.0) {
    if (rest < 0.0) high = -1.0;
  } else if (slope > 0.0) {
    high = std::min(high, rest / slope);
  } else {
    low = std::max(low, rest / slope);
  }
}

/// A side moved out a little, as a path from p_i (alpha 0) to p_j (alpha 1).
struct Path {
  Vec2 start;
  Vec2 way;
};

Path outside_of(const Box& box, int e) {
  const Vec2 p_i = box.corner(next_corner(e));
  return {p_i + outside_share * box.smaller_side() * box.normal(e), box.corner(e) - p_i};
}

void add_interval(int e, double low, double high, Cover& cover) {
  if (high - low > same_alpha) cover.side[e].emplace_back(low, high);
}

}  // namespace

bool Cover::covers(int e, double alpha) const {
  return std::ranges::any_of(side[e], [&](const auto& interval) {
    return (interval.first <= same_alpha || alpha > interval.first + same_alpha)
           && (interval.second >= 1.0 - same_alpha || alpha < interval.second - same_alpha);
  });
}

bool Cover::empty() const {
  return std::ranges::all_of(side, [](const auto& intervals) { return intervals.empty(); });
}

void add_cover(const Box& box, const Box& other, Cover& cover) {
  for (int e = 0; e < Box::corners; ++e) {
    const Path path = outside_of(box, e);
    double low = 0.0;
    double high = 1.0;
    for (int f = 0; f < Box::corners; ++f) {
      const Vec2 n = other.normal(f);
      clip(n.dot(path.start - other.center) - other.reach(f), n.dot(path.way),
           surface_share * other.smaller_side(), low, high);
    }
    add_interval(e, low, high, cover);
  }
}

void add_cover(const Box& box, const Vec2& point, const Vec2& normal, Cover& cover) {
  for (int e = 0; e < Box::corners; ++e) {
    const Path path = outside_of(box, e);
    double low = 0.0;
    double high = 1.0;
    clip(normal.dot(path.start - point), normal.dot(path.way), surface_share * box.smaller_side(),
         low, high);
    add_interval(e, low, high, cover);
  }
}

}  // namespace wuerfel
