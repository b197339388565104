#include "core/time/stepping/resting_islands.h"

#include <algorithm>
#include <utility>

namespace wuerfel {
namespace {

/// What a step from rest leaves of so many g h is rounding; where there is a certificate, what programs leave.
constexpr double rounding_share = 1e-13;
constexpr double residual_share = 1e-9;

/// Whether somebody pushed at an island who no longer touches it: what held it then does not hold it at rest.
bool was_visited(const Stride& stride, const Island& island) {
  const std::vector<ContactId> own = sorted_ids(island.contacts);
  const auto is_mine = [&](int body) { return std::ranges::binary_search(island.cubes, body); };
  return std::ranges::any_of(stride.blows, [&](const auto& entry) {
    const auto& [id, blow] = entry;
    return blow.acts() && (is_mine(blow.start.on) || is_mine(blow.start.from))
           && !std::ranges::binary_search(own, id);
  });
}

}  // namespace

bool is_at(const RestingIsland& island, const State& state) {
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    const BodyState& s = state[island.cubes[k]];
    const BodyState& place = island.places[k];
    if (s.position != place.position || s.angle != place.angle) return false;
  }
  return true;
}

bool rests_at(const RestingIsland& island, const State& state) {
  return is_at(island, state)
         && std::ranges::all_of(island.cubes, [&](int cube) { return is_still(state[cube]); });
}

/// Whether the step began at rest and changed nothing, but for so many g h.
bool RestingIslands::stays(const Stride& stride,
                           const Island& island,
                           const State& end,
                           double share) const {
  const double rounding = share * stride.scales.gravity * stride.h;
  return std::ranges::all_of(island.cubes, [&](int cube) {
    const BodyState& a = stride.start[cube];
    const BodyState& b = end[cube];
    const Body& body = system_->body(cube);
    const Twist way{b.position - a.position, b.angle - a.angle};
    return fastest_corner(body, a) <= rounding && fastest_corner(body, b) <= rounding
           && fastest_corner(body, way) <= rounding * stride.h;
  });
}

void RestingIslands::find(const Stride& stride, const std::vector<Island>& islands, State& end) {
  for (const Island& island : islands) {
    // Where nothing rubs gaps are kept open by what depends on the step.
    if (!island.rods.empty() || !rubs(*system_, island)) continue;
    const bool rested = of(island, stride.start) != nullptr;
    if (!stays(stride, island, end, rested ? residual_share : rounding_share)) continue;
    if (!rested && was_visited(stride, island)) continue;
    for (const int cube : island.cubes) {
      end[cube] = stride.start[cube];
      stop(end[cube]);
    }
    work_->friction.forget(island);
    if (!rested) certify(stride, island, end);
  }
}

void RestingIslands::certify(const Stride& stride, const Island& island, const State& end) {
  RestingIsland rest{island.cubes, {}, {}, {}};
  for (const int cube : island.cubes)
    rest.places.push_back(end[cube]);
  for (const Contact& c : island.contacts) {
    const auto blow = stride.blows.find(c.id());
    if (blow == stride.blows.end() || !blow->second.acts()) continue;
    rest.contacts.push_back(blow->second.start);
    rest.forces.push_back((blow->second.first + blow->second.second) / stride.h);
  }
  resting_[island.cubes.front()] = std::move(rest);
}

const RestingIsland* RestingIslands::of(const Island& island, const State& start) const {
  const auto found = resting_.find(island.cubes.front());
  if (found == resting_.end()) return nullptr;
  const RestingIsland& rest = found->second;
  return rest.cubes == island.cubes && rests_at(rest, start) ? &rest : nullptr;
}

}  // namespace wuerfel
