/// The system of cubes (System von Würfeln): what does not change while it moves.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/box.h"
#include "core/model/state.h"
#include "core/scene/overlap.h"
#include "core/scene/scene.h"

namespace wuerfel {

struct Body {
  std::string name;
  BodyKind kind = BodyKind::cube;
  Vec2 size = Vec2::Zero();     ///< m; of boxes
  double mass = 0.0;            ///< kg; of cubes
  double inertia = 0.0;         ///< kg m^2, m (w^2 + h^2) / 12 about the centre; of cubes
  Box box;                      ///< pose of a fixed box
  Vec2 point = Vec2::Zero();    ///< m; of planes
  Vec2 normal = Vec2::UnitY();  ///< unit vector out of the solid; of planes
};

/// Bodies are numbered: cubes first, in the order of the scene, then fixed boxes, then planes.
struct System {
  std::string title;
  Vec2 gravity = Vec2::Zero();  ///< m/s^2
  std::vector<Body> bodies;
  int cubes = 0;

  [[nodiscard]] const Body& body(int i) const { return bodies[i]; }
  [[nodiscard]] bool is_cube(int i) const { return i < cubes; }
  [[nodiscard]] int count() const { return static_cast<int>(bodies.size()); }
};

System make_system(const Scene& scene);

/// The state that the scene starts from.
State initial_state(const Scene& scene);

/// Poses of all boxes, cubes and fixed, numbered as bodies; planes have an empty box.
void pose_boxes(const System& system, const State& state, std::vector<Box>& boxes);

/// Kinetic energy, J.
double kinetic_energy(const System& system, const State& state);

/// Kinetic and potential energy, J; zero height is the origin.
double energy(const System& system, const State& state);

}  // namespace wuerfel
