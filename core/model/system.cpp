#include "core/model/system.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/broad_phase.h"

namespace wuerfel {
namespace {

/// The end of a rod: a place on a body that moves, or what that is in the world.
RodEnd end_of(const std::map<std::string_view, int>& number,
              const System& system,
              const ScenePlace& place) {
  if (place.body.empty()) return {-1, place.at, -1};
  const int body = number.at(place.body);
  if (system.is_cube(body)) return {body, place.at, body};
  const Box& box = system.body(body).box;
  const Vec2 arm = place.at.x() * box.axis + place.at.y() * perp(box.axis);
  return {-1, box.center + arm, body};
}

/// A rod is one row, a pin two.
void set_rods(const Scene& scene, System& system) {
  if (scene.rods.empty() && scene.pins.empty()) return;
  std::map<std::string_view, int> number;
  for (const Body& body : system.bodies)
    number.emplace(body.name, body.number);
  const auto add = [&](const auto& joint, Rod::Kind kind, double length) {
    system.rods.push_back({kind, end_of(number, system, joint.from),
                           end_of(number, system, joint.to), length, joint.name,
                           static_cast<int>(system.rods.size())});
  };
  for (const SceneRod& rod : scene.rods)
    add(rod, Rod::Kind::rod, rod.length);
  for (const ScenePin& pin : scene.pins) {
    add(pin, Rod::Kind::pin_x, 0.0);
    add(pin, Rod::Kind::pin_y, 0.0);
    const Rod& row = system.rods.back();
    if (pin.collide || row.i.name < 0 || row.j.name < 0) continue;
    system.strangers.insert(std::minmax(row.i.name, row.j.name));
  }
}

/// Points are measured by the smallest side of a cube; among themselves by the shortest rod.
void set_reach_of_points(System& system) {
  double reach = std::numeric_limits<double>::max();
  for (int i = 0; i < system.cubes - system.points; ++i)
    reach = std::min(reach, system.bodies[i].smaller_side());
  if (system.cubes == system.points) {
    for (const Rod& rod : system.rods)
      if (rod.kind == Rod::Kind::rod) reach = std::min(reach, rod.length);
  }
  if (reach == std::numeric_limits<double>::max()) reach = 1.0;
  for (int i = system.cubes - system.points; i < system.cubes; ++i)
    system.bodies[i].reach = reach;
}

/// Numbers the bodies and takes over what the scene says of pairs.
void set_surfaces(const Scene& scene, System& system) {
  for (int i = 0; i < system.count(); ++i)
    system.bodies[i].number = i;
  for (const ScenePair& pair : scene.pairs) {
    const auto number = [&](const std::string& name) {
      const auto found = std::ranges::find(system.bodies, name, &Body::name);
      return static_cast<int>(found - system.bodies.begin());
    };
    const int i = number(pair.bodies[0]);
    const int j = number(pair.bodies[1]);
    const Material mean = system.surface(i, j);
    system.pairs[std::minmax(i, j)] = {pair.friction.value_or(mean.friction),
                                       pair.restitution.value_or(mean.restitution)};
  }
  // Two bodies of which one moves.
  const auto any_pair = [&](double Material::*value) {
    const auto has = [&](const Body& body) { return body.material.*value > 0.0; };
    const auto first_fixed = system.bodies.begin() + system.cubes;
    return (std::any_of(system.bodies.begin(), first_fixed, has)
            && std::ranges::count_if(system.bodies, has) > 1)
           || std::ranges::any_of(system.pairs,
                                  [&](const auto& pair) { return pair.second.*value > 0.0; });
  };
  system.rubs = any_pair(&Material::friction);
  system.bounces = any_pair(&Material::restitution);
}

}  // namespace

Material System::surface(int i, int j) const {
  const Body& a = body(i);
  const Body& b = body(j);
  if (!pairs.empty()) {
    const auto named = pairs.find(std::minmax(a.number, b.number));
    if (named != pairs.end()) return named->second;
  }
  const auto mean = [](double x, double y) { return x == y ? x : std::sqrt(x * y); };
  return {mean(a.material.friction, b.material.friction),
          mean(a.material.restitution, b.material.restitution)};
}

bool System::may_touch(int i, int j) const {
  const Body& a = body(i);
  const Body& b = body(j);
  if (a.kind == BodyKind::point && b.kind == BodyKind::point) return false;
  return !strangers.contains(std::minmax(a.number, b.number));
}

System make_system(const Scene& scene) {
  System system;
  system.title = scene.title;
  system.gravity = scene.gravity;
  system.points = static_cast<int>(scene.points.size());
  system.cubes = static_cast<int>(scene.cubes.size()) + system.points;
  system.bodies.reserve(system.cubes + scene.fixed.size() + scene.planes.size());
  for (const SceneCube& cube : scene.cubes) {
    Body body;
    body.name = cube.name;
    body.size = cube.size;
    body.mass = cube.mass;
    body.inertia = cube.mass * cube.size.squaredNorm() / 12.0;
    body.material = cube.material;
    system.bodies.push_back(std::move(body));
  }
  for (const ScenePoint& point : scene.points) {
    Body body;
    body.name = point.name;
    body.kind = BodyKind::point;
    body.mass = point.mass;
    body.inertia = point.mass;
    body.material = point.material;
    system.bodies.push_back(std::move(body));
  }
  for (const SceneFixed& fixed : scene.fixed) {
    Body body;
    body.name = fixed.name;
    body.kind = BodyKind::fixed;
    body.size = fixed.size;
    body.box = make_box(fixed.position, fixed.angle, fixed.size);
    body.material = fixed.material;
    system.bodies.push_back(std::move(body));
  }
  for (const ScenePlane& plane : scene.planes) {
    Body body;
    body.name = plane.name;
    body.kind = BodyKind::plane;
    body.point = plane.point;
    body.normal = plane.normal.normalized();
    body.material = plane.material;
    system.bodies.push_back(std::move(body));
  }
  set_surfaces(scene, system);
  set_covers(system);
  set_rods(scene, system);
  set_reach_of_points(system);
  return system;
}

void set_covers(System& system) {
  std::vector<BoundingBox> bounds;
  const int cubes = system.cubes;
  int boxes = cubes;
  for (; boxes < system.count() && system.bodies[boxes].kind == BodyKind::fixed; ++boxes) {
    const Box& box = system.bodies[boxes].box;
    bounds.push_back(posed_bounds(box, touching_tolerance * box.smaller_side()));
  }
  std::vector<Cover> covers(bounds.size());
  BroadPhase broad_phase;
  for (const IndexPair& pair : broad_phase.overlapping_pairs(bounds)) {
    const Box& a = system.bodies[cubes + pair.first].box;
    const Box& b = system.bodies[cubes + pair.second].box;
    add_cover(a, b, covers[pair.first]);
    add_cover(b, a, covers[pair.second]);
  }
  for (int i = cubes; i < boxes; ++i) {
    Cover& cover = covers[i - cubes];
    for (int p = boxes; p < system.count(); ++p)
      add_cover(system.bodies[i].box, system.bodies[p].point, system.bodies[p].normal, cover);
    if (!cover.empty()) system.bodies[i].cover = std::make_shared<const Cover>(std::move(cover));
  }
}

double fastest_corner(const Body& body, const Twist& velocity) {
  return velocity.linear.norm() + body.radius() * std::abs(velocity.angular);
}

double fastest_corner(const Body& body, const BodyState& state) {
  return fastest_corner(body, Twist{state.velocity, state.spin});
}

bool is_slower_than(const System& system, const State& state, double speed) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (fastest_corner(system.bodies[i], state[i]) > speed) return false;
  }
  return true;
}

State initial_state(const Scene& scene) {
  State state;
  state.reserve(scene.cubes.size() + scene.points.size());
  for (const SceneCube& cube : scene.cubes) {
    state.push_back({cube.position, cube.angle, cube.velocity, cube.spin});
  }
  for (const ScenePoint& point : scene.points)
    state.push_back({point.position, 0.0, point.velocity, 0.0});
  return state;
}

void pose_boxes(const System& system, const State& state, std::vector<Box>& boxes) {
  boxes.resize(system.bodies.size());
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const Body& body = system.bodies[i];
    boxes[i] = i < state.size() ? make_box(state[i].position, state[i].angle, body.size) : body.box;
  }
}

double kinetic_energy(const Body& body, const BodyState& state) {
  return 0.5 * body.mass * state.velocity.squaredNorm()
         + 0.5 * body.inertia * state.spin * state.spin;
}

double kinetic_energy(const System& system, const State& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.size(); ++i)
    sum += kinetic_energy(system.bodies[i], state[i]);
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
