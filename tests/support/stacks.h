/// Stacks whose margins are known in closed form.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "core/statics/still_scene.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {

inline StillScene still(const Scene& scene) { return stopped_scene(scene, {}); }

/// Unit cubes that overhang a table's edge at 0, the longest possible times 1 + eps: with n - i cubes
/// from cube i on upwards the centre of these lies eps / 2 beyond the edge below.
inline Scene harmonic(int n, double eps) {
  Scene scene;
  scene.fixed.push_back({"table", {50.0, 1.0}, {-25.0, -0.5}, 0.0, {}});
  double x = 0.0;
  for (int i = 0; i < n; ++i) {
    x += (1.0 + eps) / (2.0 * (n - i));
    scene.cubes.push_back(cube("b" + std::to_string(i), {x - 0.5, i + 0.5}));
  }
  return scene;
}

inline void set_friction(double mu, Scene& scene) {
  for (SceneCube& c : scene.cubes)
    c.material.friction = mu;
  for (ScenePlane& p : scene.planes)
    p.material.friction = mu;
  for (SceneFixed& f : scene.fixed)
    f.material.friction = mu;
}

inline Scene with_friction(Scene scene, double mu) {
  set_friction(mu, scene);
  return scene;
}

inline Scene mirrored(Scene scene) {
  scene.gravity.x() *= -1.0;
  for (SceneCube& c : scene.cubes) {
    c.position.x() *= -1.0;
    c.velocity.x() *= -1.0;
    c.angle *= -1.0;
    c.spin *= -1.0;
  }
  for (SceneFixed& f : scene.fixed) {
    f.position.x() *= -1.0;
    f.angle *= -1.0;
  }
  for (ScenePlane& p : scene.planes) {
    p.point.x() *= -1.0;
    p.normal.x() *= -1.0;
  }
  return scene;
}

inline Scene longer(Scene scene, double times) {
  for (SceneCube& c : scene.cubes) {
    c.position *= times;
    c.size *= times;
  }
  for (SceneFixed& f : scene.fixed) {
    f.position *= times;
    f.size *= times;
  }
  for (ScenePlane& p : scene.planes)
    p.point *= times;
  return scene;
}

inline Scene heavier(Scene scene, double times) {
  for (SceneCube& c : scene.cubes)
    c.mass *= times;
  return scene;
}

}  // namespace wuerfel::test
