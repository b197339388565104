/// Scenes that tests put together from cubes.
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace wuerfel::test {

inline SceneCube cube(const std::string& name,
                      const Vec2& position,
                      double angle = 0.0,
                      double spin = 0.0) {
  SceneCube c;
  c.name = name;
  c.position = position;
  c.angle = angle;
  c.spin = spin;
  return c;
}

/// On a floor at height 0.
inline Scene on_floor(std::vector<SceneCube> cubes) {
  Scene scene;
  scene.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY(), {}});
  scene.cubes = std::move(cubes);
  return scene;
}

/// Unit cubes one on the other, every second one shifted by 0.1 m.
inline std::vector<SceneCube> tower(int count) {
  std::vector<SceneCube> cubes;
  for (int i = 0; i < count; ++i)
    cubes.push_back(cube("t" + std::to_string(i), {0.1 * (i % 2), 0.5 + i}));
  return cubes;
}

}  // namespace wuerfel::test
