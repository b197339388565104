/// Small mechanisms for tests: blocks, ground and posts, posed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/model/system.h"

namespace wuerfel::test {

inline SceneCube block(const std::string& name,
                       const Vec2& position,
                       const Vec2& size = Vec2::Ones(),
                       double angle = 0.0) {
  SceneCube c;
  c.name = name;
  c.position = position;
  c.size = size;
  c.angle = angle;
  return c;
}

/// A fixed box.
inline SceneFixed post(const std::string& name, const Vec2& position, const Vec2& size) {
  SceneFixed f;
  f.name = name;
  f.position = position;
  f.size = size;
  return f;
}

/// Blocks on a floor at height 0.
inline Scene on_ground(std::vector<SceneCube> cubes) {
  Scene scene;
  scene.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY(), {}});
  scene.cubes = std::move(cubes);
  return scene;
}

/// A scene at its start.
struct Mechanism {
  explicit Mechanism(const Scene& scene)
      : system(make_system(scene)), state(initial_state(scene)) {}
  System system;
  State state;
};

}  // namespace wuerfel::test
