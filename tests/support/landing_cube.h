/// A step that is made up by hand.
#pragma once

#include "core/time/stepping/stride.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {

/// A cube without weight that comes down at 1 m/s from 0.04 m above the ground, and is stopped by
/// half a newton second at either corner, in the first half of a step of 0.1 s.
class LandingCube {
 public:
  explicit LandingCube(double friction = 0.0, double restitution = 0.0)
      : m_(scene(friction, restitution)) {
    stride.h = 0.1;
    stride.scales = scales_of(m_.system, m_.state);
    stride.start = stride.half = m_.state;
    stride.half[0].velocity.setZero();
    stride.before = end = stride.half;
    for (const Contact& c : ContactFinder().find(m_.system, m_.state, 0.1))
      stride.blows[c.id()] = {c, c, {0.0, 0.5}, Vec2::Zero()};
  }
  [[nodiscard]] const System& system() const { return m_.system; }
  Stride stride;
  State end;

 private:
  static Scene scene(double friction, double restitution) {
    Scene scene = on_floor({cube("a", {0.0, 0.54})});
    scene.cubes[0].material.friction = scene.planes[0].material.friction = friction;
    scene.cubes[0].material.restitution = scene.planes[0].material.restitution = restitution;
    scene.gravity = Vec2::Zero();
    scene.cubes[0].velocity = {0.0, -1.0};
    return scene;
  }
  Mechanism m_;
};

}  // namespace wuerfel::test
