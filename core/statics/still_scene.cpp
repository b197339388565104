#include "core/statics/still_scene.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/vec2.h"
#include "core/statics/sets.h"

namespace wuerfel {

int StillScene::island_of(int cube) const {
  const auto of = std::ranges::find_if(
      found.islands, [cube](const IslandForces& f) { return has(f.island.cubes, cube); });
  return of == found.islands.end() ? -1 : static_cast<int>(of - found.islands.begin());
}

std::vector<char> StillScene::concerned(int island) const {
  std::vector<char> result(system.cubes, 0);
  for (int m = 0; m < static_cast<int>(found.islands.size()); ++m) {
    if (m != island && !found.islands[m].rests) continue;
    for (const int cube : found.islands[m].island.cubes)
      result[cube] = 1;
  }
  return result;
}

double StillScene::weight(int cube) const {
  const double g = system.gravity.norm();
  return system.body(cube).mass * (g > 0.0 ? g : 1.0);
}

Vec2 StillScene::down() const {
  const double g = system.gravity.norm();
  return g > 0.0 ? Vec2(system.gravity / g) : Vec2(0.0, -1.0);
}

bool StillScene::is_level(const Vec2& normal) const {
  constexpr double no_slope = 1e-14;  // sine of an angle that rounding leaves
  return !(std::abs(det(normal, down())) > no_slope * normal.norm());
}

StillScene still_scene(const System& system, const State& state, const MotionSettings& settings) {
  StillScene still{system, state, forces_at(system, settings, state, Detail::uniqueness)};
  still.verdict = judge(system, state, still.found);
  return still;
}

StillScene stopped_scene(const Scene& scene, const MotionSettings& settings) {
  State state = initial_state(scene);
  for (BodyState& s : state)
    stop(s);
  return still_scene(make_system(scene), state, settings);
}

}  // namespace wuerfel
