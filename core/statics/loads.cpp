#include "core/statics/loads.h"

#include <algorithm>

namespace wuerfel {
namespace {

Load no_load_on(const Island& island) { return Load(3 * island.cubes.size(), 0.0); }

/// Where the unknowns of a cube begin.
int first_unknown(const Island& island, int cube) {
  const auto at = std::ranges::lower_bound(island.cubes, cube);
  return 3 * static_cast<int>(at - island.cubes.begin());
}

}  // namespace

Load weights(const StillScene& still, const Island& island) {
  Load load;
  for (const int cube : island.cubes) {
    const Vec2 weight = still.system.body(cube).mass * still.system.gravity;
    load.insert(load.end(), {weight.x(), weight.y(), 0.0});
  }
  return load;
}

Load force_at(
    const StillScene& still, const Island& island, int cube, const Vec2& point, const Vec2& force) {
  Load load = no_load_on(island);
  const int k = first_unknown(island, cube);
  load[k] = force.x();
  load[k + 1] = force.y();
  load[k + 2] = det(point - still.state[cube].position, force);
  return load;
}

Load torque_on(const Island& island, int cube, double torque) {
  Load load = no_load_on(island);
  load[first_unknown(island, cube) + 2] = torque;
  return load;
}

Load share_of_weights(const StillScene& still, const Island& island, const Vec2& direction) {
  Load load;
  for (const int cube : island.cubes) {
    const Vec2 force = still.weight(cube) * direction;
    load.insert(load.end(), {force.x(), force.y(), 0.0});
  }
  return load;
}

}  // namespace wuerfel
