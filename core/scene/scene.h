/// Scene: what a scene file says, as plain values with generators and placements already resolved.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/vec2.h"

namespace wuerfel {

/// Surface properties of one body; a pair takes the geometric mean of its two values.
struct Material {
  double friction = 0.0;     ///< Coulomb coefficient, >= 0
  double restitution = 0.0;  ///< Newton coefficient, 0 .. 1
  bool operator==(const Material&) const = default;
};

/// Fixed half-plane.
struct ScenePlane {
  std::string name;
  Vec2 point = Vec2::Zero();    ///< m, a point of the boundary
  Vec2 normal = Vec2::UnitY();  ///< unit vector out of the solid
  Material material;
  bool operator==(const ScenePlane&) const = default;
};

/// Rectangle that never moves.
struct SceneFixed {
  std::string name;
  Vec2 size = Vec2::Ones();      ///< m, width and height, > 0
  Vec2 position = Vec2::Zero();  ///< m, centre
  double angle = 0.0;            ///< rad, counter-clockwise
  Material material;
  bool operator==(const SceneFixed&) const = default;
};

/// A cube (Würfel, Stein): a uniform rigid rectangle.
struct SceneCube {
  std::string name;
  Vec2 size = Vec2::Ones();      ///< m, width and height, > 0
  double mass = 1.0;             ///< kg, > 0
  Vec2 position = Vec2::Zero();  ///< m, centre
  double angle = 0.0;            ///< rad, counter-clockwise
  Vec2 velocity = Vec2::Zero();  ///< m/s, of the centre
  double spin = 0.0;             ///< rad/s
  Material material;
  std::optional<std::array<std::uint8_t, 3>> color;  ///< RGB; none: the theme's palette decides
  bool operator==(const SceneCube&) const = default;
};

/// A free point mass.
struct ScenePoint {
  std::string name;
  double mass = 1.0;             ///< kg, > 0
  Vec2 position = Vec2::Zero();  ///< m
  Vec2 velocity = Vec2::Zero();  ///< m/s
  Material material;
  bool operator==(const ScenePoint&) const = default;
};

/// A place on a body, or fixed in the world.
struct ScenePlace {
  std::string body;  ///< empty: fixed in the world
  Vec2 at =
      Vec2::Zero();  ///< m, in the frame of the unturned body from its centre, or in the world
  bool operator==(const ScenePlace&) const = default;
};

/// A rod (Stange) of one's own: keeps two places at a distance.
struct SceneRod {
  std::string name;
  ScenePlace from;
  ScenePlace to;
  double length = 1.0;  ///< m, > 0
  bool operator==(const SceneRod&) const = default;
};

/// A pin: two places that coincide stay together.
struct ScenePin {
  std::string name;
  ScenePlace from;
  ScenePlace to;
  bool collide = false;  ///< whether the two bodies may touch each other
  bool operator==(const ScenePin&) const = default;
};

/// Override of the surface properties of one pair of bodies, by name.
struct ScenePair {
  std::array<std::string, 2> bodies;
  std::optional<double> friction;
  std::optional<double> restitution;
  bool operator==(const ScenePair&) const = default;
};

struct Scene {
  std::string title;
  Vec2 gravity{0.0, -9.81};  ///< m/s^2: the paper's force field F_i (an acceleration)
  double duration = 5.0;     ///< s
  Material material;         ///< what bodies take that say nothing
  std::vector<ScenePlane> planes;
  std::vector<SceneFixed> fixed;
  std::vector<SceneCube> cubes;
  std::vector<ScenePair> pairs;
  std::vector<ScenePoint> points;
  std::vector<SceneRod> rods;
  std::vector<ScenePin> pins;
  bool operator==(const Scene&) const = default;
};

/// Name of a body that moves; cubes are numbered first, then points.
inline const std::string& moving_name(const Scene& scene, int i) {
  const int cubes = static_cast<int>(scene.cubes.size());
  return i < cubes ? scene.cubes[i].name : scene.points[i - cubes].name;
}

}  // namespace wuerfel
