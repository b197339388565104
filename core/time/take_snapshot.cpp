#include "core/time/take_snapshot.h"

#include "core/constraints/manifold.h"
#include "core/constraints/side.h"
#include "core/dynamics/forces.h"

namespace wuerfel {
namespace {

void add_bodies(const Scene& scene, const System& system, const State& state, Snapshot& snapshot) {
  for (int i = 0; i < system.count(); ++i) {
    const Body& body = system.body(i);
    if (body.kind == BodyKind::plane) {
      snapshot.planes.push_back({body.name, body.point, body.normal});
      continue;
    }
    SnapshotBox box;
    box.name = body.name;
    box.size = body.size;
    if (system.is_cube(i)) {
      const BodyState& s = state[i];
      box.center = s.position;
      box.angle = s.angle;
      box.velocity = s.velocity;
      box.spin = s.spin;
      box.color_index = i;
      box.color = scene.cubes[i].color;
    } else {
      const SceneFixed& fixed = scene.fixed[i - system.cubes];
      box.center = fixed.position;
      box.angle = fixed.angle;
      box.fixed = true;
    }
    snapshot.boxes.push_back(std::move(box));
  }
}

void add_forces(const System& system,
                const Island& island,
                const std::vector<double>& forces,
                Snapshot& snapshot) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const Contact& c = island.contacts[k];
    if (forces[k] <= 0.0) continue;
    // Shown is the force that carries: on the upper body of the two, and on a cube where one is
    // fixed.
    const bool carries = system.gravity.dot(c.normal) <= 0.0;
    const bool on = system.is_cube(c.on) && (carries || !system.is_cube(c.from));
    const Vec2 force = (on ? forces[k] : -forces[k]) * c.normal;
    snapshot.forces.push_back({c.point, force, ForceKind::contact, on ? c.on : c.from});
  }
}

void add_rods(const System& system,
              const Moment& moment,
              int cube,
              const std::vector<Contact>& contacts,
              const std::vector<double>& forces,
              bool with_tension,
              Snapshot& snapshot) {
  const auto n = static_cast<std::size_t>(cube);
  const CubePoints points = points_of(moment.state[n], system.body(cube).size);
  std::array<double, rods_per_cube> tension{};
  if (with_tension) {
    tension = rod_forces(system, moment.state, cube, moment.accelerations[n], contacts, forces);
  }
  for (std::size_t m = 0; m < cube_rods.size(); ++m) {
    snapshot.rods.push_back({points.p[cube_rods[m].i], points.p[cube_rods[m].j], tension[m]});
  }
}

void add_points(const System& system, const State& state, Snapshot& snapshot) {
  for (int i = 0; i < system.cubes; ++i) {
    const Body& body = system.body(i);
    const CubePoints points = points_of(state[i], body.size);
    const auto masses = mass_distribution(body.size, body.mass);
    for (std::size_t k = 0; k < masses.size(); ++k) {
      snapshot.points.push_back({points.p[k], masses[k].mass});
    }
  }
}

void add_contacts(const Island& island, Snapshot& snapshot) {
  for (const Contact& c : island.contacts) {
    const Vec2 p_i = c.point - c.gap * c.normal - c.alpha * (c.arm_j - c.arm_i);
    snapshot.contacts.push_back({p_i, p_i + (c.arm_j - c.arm_i), c.point, c.normal});
  }
}

/// One triangle of Eq. (2) per pair of boxes that are near each other: that of the side that
/// separates them best.
void add_sides(const System& system, const State& state, Snapshot& snapshot) {
  std::vector<Box> boxes;
  pose_boxes(system, state, boxes);
  std::vector<BoundingBox> bounds;
  for (std::size_t i = 0; i < snapshot.boxes.size(); ++i) {
    const Vec2 reach = Vec2::Constant(boxes[i].half.norm() + 0.5 * boxes[i].smaller_side());
    bounds.push_back({boxes[i].center - reach, boxes[i].center + reach});
  }
  BroadPhase broad_phase;
  for (const IndexPair& pair : broad_phase.overlapping_pairs(bounds)) {
    if (!system.is_cube(pair.first)) continue;
    const Contact c = nearest_corner(boxes, pair.first, pair.second);
    const Vec2 p_i = boxes[c.from].center + c.arm_i;
    const Vec2 p_j = boxes[c.from].center + c.arm_j;
    snapshot.sides.push_back({p_i, p_j, c.point, side_area(p_i, p_j, c.point)});
  }
}

}  // namespace

Snapshot take_snapshot(const Scene& scene,
                       const System& system,
                       const Moment& moment,
                       const SnapshotRequest& request) {
  Snapshot snapshot;
  snapshot.time = moment.t;
  snapshot.title = system.title;
  snapshot.energy = energy(system, moment.state);
  add_bodies(scene, system, moment.state, snapshot);
  if (request.points) add_points(system, moment.state, snapshot);
  if (request.sides) add_sides(system, moment.state, snapshot);

  const bool with_forces = request.forces || request.rod_forces;
  std::vector<char> in_island(moment.state.size(), 0);
  for (std::size_t m = 0; m < moment.islands.size(); ++m) {
    const Island& island = moment.islands[m];
    std::vector<double> forces(island.contacts.size(), 0.0);
    if (with_forces) {
      std::vector<Twist> accelerations;
      for (const int cube : island.cubes)
        accelerations.push_back(moment.accelerations[cube]);
      forces = canonical_forces(system, moment.felt, island, accelerations, moment.solutions[m],
                                Uniqueness::ignored)
                   .force;
    }
    if (request.forces) add_forces(system, island, forces, snapshot);
    if (request.contacts) add_contacts(island, snapshot);
    for (const int cube : island.cubes) {
      in_island[cube] = 1;
      if (request.rods) {
        add_rods(system, moment, cube, island.contacts, forces, request.rod_forces, snapshot);
      }
    }
  }
  for (int i = 0; i < system.cubes && request.rods; ++i) {
    if (in_island[i] == 0) {
      add_rods(system, moment, i, {}, {}, request.rod_forces, snapshot);
    }
  }
  return snapshot;
}

}  // namespace wuerfel
