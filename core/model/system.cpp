#include "core/model/system.h"

namespace wuerfel {

System make_system(const Scene& scene) {
  System system;
  system.title = scene.title;
  system.gravity = scene.gravity;
  system.cubes = static_cast<int>(scene.cubes.size());
  system.bodies.reserve(scene.cubes.size() + scene.fixed.size() + scene.planes.size());
  for (const SceneCube& cube : scene.cubes) {
    Body body;
    body.name = cube.name;
    body.size = cube.size;
    body.mass = cube.mass;
    body.inertia = cube.mass * cube.size.squaredNorm() / 12.0;
    system.bodies.push_back(std::move(body));
  }
  for (const SceneFixed& fixed : scene.fixed) {
    Body body;
    body.name = fixed.name;
    body.kind = BodyKind::fixed;
    body.size = fixed.size;
    body.box = make_box(fixed.position, fixed.angle, fixed.size);
    system.bodies.push_back(std::move(body));
  }
  for (const ScenePlane& plane : scene.planes) {
    Body body;
    body.name = plane.name;
    body.kind = BodyKind::plane;
    body.point = plane.point;
    body.normal = plane.normal.normalized();
    system.bodies.push_back(std::move(body));
  }
  return system;
}

State initial_state(const Scene& scene) {
  State state;
  state.reserve(scene.cubes.size());
  for (const SceneCube& cube : scene.cubes) {
    state.push_back({cube.position, cube.angle, cube.velocity, cube.spin});
  }
  return state;
}

void pose_boxes(const System& system, const State& state, std::vector<Box>& boxes) {
  boxes.resize(system.bodies.size());
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const Body& body = system.bodies[i];
    boxes[i] = i < state.size() ? make_box(state[i].position, state[i].angle, body.size) : body.box;
  }
}

double kinetic_energy(const System& system, const State& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Body& body = system.bodies[i];
    sum += 0.5 * body.mass * state[i].velocity.squaredNorm()
           + 0.5 * body.inertia * state[i].spin * state[i].spin;
  }
  return sum;
}

double energy(const System& system, const State& state) {
  double sum = kinetic_energy(system, state);
  for (std::size_t i = 0; i < state.size(); ++i) {
    sum -= system.bodies[i].mass * system.gravity.dot(state[i].position);
  }
  return sum;
}

}  // namespace wuerfel
