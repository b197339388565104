#include "core/time/take_snapshot.h"

#include <algorithm>
#include <cmath>

#include "core/constraints/manifold.h"
#include "core/constraints/side.h"
#include "core/dynamics/rod_rows.h"
#include "core/time/shown_joints.h"
#include "core/time/shown_ranges.h"

namespace wuerfel {
namespace {

/// Forces along a side are shown beyond this share of the one across it.
constexpr double least_friction = 1e-12;

void add_bodies(const Scene& scene, const System& system, const State& state, Snapshot& snapshot) {
  for (int i = 0; i < system.count(); ++i) {
    const Body& body = system.body(i);
    if (body.kind == BodyKind::plane) {
      snapshot.planes.push_back({body.name, body.point, body.normal});
      continue;
    }
    if (body.kind == BodyKind::point) {
      snapshot.masses.push_back({body.name, state[i].position, body.mass, state[i].velocity});
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
      box.mass = body.mass;
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

/// Rods between bodies and pins, with their forces as far as they are known.
void add_links(const System& system,
               const State& state,
               const InstantForces& found,
               Snapshot& snapshot) {
  std::vector<double> force(system.rods.size(), 0.0);
  for (const IslandForces& of : found.islands) {
    for (std::size_t k = 0; k < of.forces.rods.size(); ++k)
      force[of.island.rods[k]] = of.forces.rods[k];
  }
  const auto name_of = [&](const RodEnd& end) {
    return end.body < 0 ? std::string() : system.body(end.body).name;
  };
  for (std::size_t k = 0; k < system.rods.size(); ++k) {
    const Rod& rod = system.rods[k];
    if (rod.kind == Rod::Kind::pin_y) continue;
    SnapshotLink link{rod.name,
                      rod.kind == Rod::Kind::pin_x,
                      held_place(rod.i, state).p,
                      held_place(rod.j, state).p,
                      {name_of(rod.i), name_of(rod.j)}};
    link.force =
        link.pin ? Vec2(force[k], force[k + 1]) : Vec2(force[k] * rod_direction(rod, state));
    if (!link.pin) link.tension = -force[k];
    snapshot.links.push_back(std::move(link));
  }
}

void add_accelerations(const System& system, const InstantForces& found, Snapshot& snapshot) {
  for (int i = 0; i < system.cubes - system.points; ++i) {
    snapshot.boxes[i].acceleration = found.accelerations[i].linear;
    snapshot.boxes[i].angular_acceleration = found.accelerations[i].angular;
  }
}

void add_forces(const System& system,
                const IslandForces& of,
                const ForceRanges& ranges,
                Snapshot& snapshot) {
  const double least = of.forces.least_pressing();
  for (std::size_t k = 0; k < of.island.contacts.size(); ++k) {
    const Contact& c = of.island.contacts[k];
    const double normal = of.forces.force[k];
    if (normal <= least) continue;
    const bool on = is_carried(system, c);
    const Vec2 force = (on ? normal : -normal) * c.normal;
    const bool unique = of.detail < Detail::uniqueness || of.forces.unique[k] != 0;
    const int body = box_of(system, on ? c.on : c.from);
    const int other = box_of(system, on ? c.from : c.on);
    snapshot.forces.push_back({c.point, force, ForceKind::contact, body, unique, {}, other});
    if (!ranges.contacts.empty()) snapshot.forces.back().range = shown_range(ranges.contacts[k]);
    if (of.forces.tangential.empty()) continue;
    const double tangential = of.forces.tangential[k];
    if (std::abs(tangential) <= least_friction * normal) continue;
    const Vec2 along = (on ? tangential : -tangential) * perp(c.normal);
    snapshot.forces.push_back({c.point, along, ForceKind::friction, body, unique, {}, other});
  }
}

void add_rods(const System& system,
              const State& state,
              const InstantForces& found,
              bool with_tension,
              Snapshot& snapshot) {
  std::vector<const IslandForces*> island_of(state.size(), nullptr);
  for (const IslandForces& of : found.islands) {
    for (const int cube : of.island.cubes)
      island_of[cube] = &of;
  }
  for (int cube = 0; cube < system.cubes - system.points; ++cube) {
    std::array<double, rods_per_cube> tension{};
    if (with_tension) {
      const IslandForces* of = island_of[cube];
      const Twist& a = found.accelerations[cube];
      tension = of == nullptr ? rod_forces(system, state, cube, a, {}, {})
                              : rod_forces(system, state, cube, a, of->island, of->forces);
    }
    const CubePoints points = points_of(state[cube], system.body(cube).size);
    for (std::size_t m = 0; m < cube_rods.size(); ++m) {
      snapshot.rods.push_back({points.p[cube_rods[m].i], points.p[cube_rods[m].j], tension[m]});
    }
  }
}

void add_points(const System& system, const State& state, Snapshot& snapshot) {
  for (int i = 0; i < system.cubes - system.points; ++i) {
    const Body& body = system.body(i);
    const CubePoints points = points_of(state[i], body.size);
    const auto masses = mass_distribution(body.size, body.mass);
    for (std::size_t k = 0; k < masses.size(); ++k) {
      snapshot.points.push_back({points.p[k], masses[k].mass});
    }
  }
}

void add_contacts(const System& system,
                  const State& state,
                  const Island& island,
                  Snapshot& snapshot) {
  for (const Contact& c : island.contacts) {
    const Vec2 p_i = c.point - c.gap * c.normal - c.alpha * (c.arm_j - c.arm_i);
    const ContactVelocity v = contact_velocity(system, state, c);
    snapshot.contacts.push_back({p_i, p_i + (c.arm_j - c.arm_i), c.point, c.normal, v.v_i, v.v_j,
                                 v.v_k, box_of(system, c.on), box_of(system, c.from)});
  }
}

/// One triangle of Eq. (2) per pair of boxes that are near each other: that of the side that
/// separates them best.
void add_sides(const System& system, const State& state, Snapshot& snapshot) {
  std::vector<Box> boxes;
  pose_boxes(system, state, boxes);
  const auto bounds_of = [&](int i) {
    return bounds_around(boxes[i].center, boxes[i].radius() + 0.5 * boxes[i].smaller_side());
  };
  Neighbours neighbours;
  for (const auto& [i, j] : neighbours.find(system, bounds_of)) {
    const Contact c = nearest_corner(boxes, i, j);
    const Vec2 p_i = boxes[c.from].center + c.arm_i;
    const Vec2 p_j = boxes[c.from].center + c.arm_j;
    snapshot.sides.push_back({p_i, p_j, c.point, side_area(p_i, p_j, c.point)});
  }
}

}  // namespace

Detail detail_of(const SnapshotRequest& request) {
  const bool forces = request.forces || request.joints;
  if (forces && request.unique) return Detail::uniqueness;
  if (forces || request.rod_forces) return Detail::forces;
  return request.accelerations ? Detail::accelerations : Detail::contacts;
}

Snapshot take_snapshot(const Scene& scene,
                       const System& system,
                       const State& state,
                       const InstantForces& found,
                       std::span<const ForceRanges> ranges,
                       const SnapshotRequest& request) {
  Snapshot snapshot;
  snapshot.title = system.title;
  snapshot.gravity = system.gravity;
  snapshot.energy = energy(system, state);
  snapshot.force_residual = found.residual;
  add_bodies(scene, system, state, snapshot);
  if (request.accelerations) add_accelerations(system, found, snapshot);
  add_links(system, state, found, snapshot);
  if (request.points) add_points(system, state, snapshot);
  if (request.sides) add_sides(system, state, snapshot);
  const ForceRanges unknown;
  for (std::size_t m = 0; m < found.islands.size(); ++m) {
    const IslandForces& of = found.islands[m];
    const ForceRanges& possible = ranges.empty() ? unknown : ranges[m];
    if (request.forces) add_forces(system, of, possible, snapshot);
    if (request.joints) add_joints(system, of, possible, snapshot.joints);
    if (request.contacts) add_contacts(system, state, of.island, snapshot);
  }
  if (request.rods) add_rods(system, state, found, request.rod_forces, snapshot);
  return snapshot;
}

}  // namespace wuerfel
