#include "core/time/meetings.h"

#include <algorithm>

#include "core/constraints/neighbours.h"
#include "core/geometry/union_find.h"

namespace wuerfel {
namespace {

/// Prediction of sweeps: this much of the path of free flight.
constexpr double sweep_reserve = 1.2;
/// Cubes within this share of their half diagonal belong together.
constexpr double apart_share = 1e-3;

/// Numbers by their set.
Parts parts_of(UnionFind& sets, int count) {
  Parts parts;
  std::vector<int> number(count, -1);
  for (int i = 0; i < count; ++i) {
    int& k = number[sets.root(i)];
    if (k < 0) {
      k = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    parts[k].push_back(i);
  }
  return parts;
}

}  // namespace

Parts Meetings::within(const State& state, const std::vector<char>& resting, double length) {
  predict(state, resting, length);
  const int cubes = static_cast<int>(state.size());
  UnionFind sets(cubes);
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(bounds_))
    sets.unite(pair.first, pair.second);
  for (const Rod& rod : system_->rods)
    if (!is_held(rod)) sets.unite(rod.i.body, rod.j.body);
  for (int i = 1; !apart_ && i < cubes; ++i)
    sets.unite(0, i);
  return parts_of(sets, cubes);
}

/// Bounds of what the cubes may sweep within `length` s.
void Meetings::predict(const State& state, const std::vector<char>& resting, double length) {
  const Vec2 g = system_->gravity;
  bounds_.resize(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Body& body = system_->bodies[i];
    const BodyState& s = state[i];
    if (length == 0.0 || resting[i] != 0) {
      const Box box = make_box(s.position, s.angle, body.size);
      bounds_[i] = posed_bounds(box, apart_share * box.smaller_side());
      continue;
    }
    const double radius = (1.0 + 2.0 * apart_share) * body.radius();
    const Vec2 free = length * s.velocity + 0.5 * length * length * g;
    // Where contacts act a cube may go anywhere within what its speed and gravity allow.
    const double reach =
        (sweep_reserve - 1.0) * (length * s.velocity.norm() + 0.5 * length * length * g.norm());
    bounds_[i] = predicted_bounds(s.position, s.position + free, Vec2::Constant(radius + reach));
  }
}

Parts Meetings::joined(const std::vector<BoundingBox>& swept,
                       const std::vector<int>& group_of,
                       int groups) {
  UnionFind sets(groups);
  bool met = false;
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(swept))
    met = sets.unite(group_of[pair.first], group_of[pair.second]) || met;
  if (!met) return {};
  Parts parts(groups);
  for (std::size_t i = 0; i < group_of.size(); ++i)
    parts[sets.root(group_of[i])].push_back(static_cast<int>(i));
  std::erase_if(parts, [](const std::vector<int>& p) { return p.empty(); });
  std::ranges::sort(parts);
  return parts;
}

}  // namespace wuerfel
