/// Scenes that tests put together from cubes, and scenes posed.
#pragma once

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/model/system.h"
#include "core/scene/scene_parser.h"

namespace wuerfel::test {

inline constexpr double g = 9.81;  ///< m/s^2, of scenes that say nothing else

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

/// A rectangle, `size` m.
inline SceneCube sized_cube(const std::string& name,
                            const Vec2& position,
                            const Vec2& size,
                            double angle = 0.0) {
  SceneCube c = cube(name, position, angle);
  c.size = size;
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
  cubes.reserve(count);
  for (int i = 0; i < count; ++i)
    cubes.push_back(cube("t" + std::to_string(i), {0.1 * (i % 2), 0.5 + i}));
  return cubes;
}

/// Unit cubes one on the other, each shifted by `lean` m.
inline std::vector<SceneCube> leaning_tower(int count, double lean) {
  std::vector<SceneCube> cubes;
  cubes.reserve(count);
  for (int i = 0; i < count; ++i)
    cubes.push_back(cube("c" + std::to_string(i), {lean * i, 0.5 + i}));
  return cubes;
}

/// Two unit cubes, b `gap` m to the right of a.
inline Scene side_by_side(double gap) {
  Scene scene;
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.0 + gap, 0.0})};
  return scene;
}

/// A scene at its start.
struct Mechanism {
  explicit Mechanism(const Scene& scene)
      : system(make_system(scene)), state(initial_state(scene)) {}
  System system;
  State state;
};

/// Masses 1 and 0.5, rods 1 and 0.8, at rest at the angles 2 and 2.5 from below.
inline Scene double_pendulum() {
  const Vec2 p_1(std::sin(2.0), -std::cos(2.0));
  const Vec2 p_2 = p_1 + 0.8 * Vec2(std::sin(2.5), -std::cos(2.5));
  Scene scene;
  scene.points.push_back({"one", 1.0, p_1, Vec2::Zero(), {}});
  scene.points.push_back({"two", 0.5, p_2, Vec2::Zero(), {}});
  scene.rods.push_back({"upper", {"one", Vec2::Zero()}, {"", Vec2::Zero()}, 1.0});
  scene.rods.push_back({"lower", {"one", Vec2::Zero()}, {"two", Vec2::Zero()}, 0.8});
  return scene;
}

/// A scene of assets/scenes by its name.
inline Scene shipped_scene(const std::string& name,
                           const std::vector<std::string>& overrides = {}) {
  std::ifstream file(std::string(SCENES) + "/" + name + ".toml", std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return parse_scene(text.str(), name + ".toml", overrides);
}

}  // namespace wuerfel::test
