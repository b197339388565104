#include "tests/support/image_scenes.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace wuerfel::test {
namespace {

SnapshotBox cube(const std::string& name, double x, double y, double angle, int color) {
  SnapshotBox box;
  box.name = name;
  box.center = Vec2(x, y);
  box.angle = angle;
  box.color_index = color;
  return box;
}

/// Corners and centre of a cube as point masses with sides and spokes as rods.
void add_points_and_rods(const SnapshotBox& box, double tension, Snapshot& snapshot) {
  const Vec2 along = 0.5 * Vec2(std::cos(box.angle), std::sin(box.angle));
  const Vec2 across = perp(along);
  const std::array<Vec2, 4> corners{box.center - along - across, box.center + along - across,
                                    box.center + along + across, box.center - along + across};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    snapshot.points.push_back({corners.at(i), 1.0 / 12.0});
    snapshot.rods.push_back({corners.at(i), corners.at((i + 1) % corners.size()), -tension});
    snapshot.rods.push_back({corners.at(i), box.center, (i % 2 == 0 ? 0.5 : -0.25) * tension});
  }
  snapshot.points.push_back({box.center, 2.0 / 3.0});
}

/// The two ends of a cube's lower side rest on something.
void add_support(int body, double left, double right, Snapshot& snapshot) {
  const SnapshotBox& box = snapshot.boxes[static_cast<std::size_t>(body)];
  const std::array<std::pair<double, double>, 2> ends{{{-0.5, left}, {0.5, right}}};
  for (const auto& [offset, newton] : ends) {
    const Vec2 place(box.center.x() + offset, box.center.y() - 0.5);
    snapshot.forces.push_back({place, Vec2(0.0, newton), ForceKind::contact, body});
    snapshot.contacts.push_back(
        {place - Vec2::UnitX(), place + Vec2::UnitX(), place, Vec2::UnitY()});
  }
}

/// `body` rests on `other`, below the middle of `body` shifted by `aside`, with a face so wide.
void add_joint(
    int body, int other, double aside, double width, const Vec2& force, Snapshot& snapshot) {
  const SnapshotBox& box = snapshot.boxes[static_cast<std::size_t>(body)];
  SnapshotJoint joint;
  joint.body = body;
  joint.other = other;
  const Vec2 middle(box.center.x() + aside, box.center.y() - 0.5);
  joint.from = middle + Vec2(0.5 * width, 0.0);
  joint.to = middle - Vec2(0.5 * width, 0.0);
  joint.point = middle + Vec2(0.1 * width, 0.0);
  joint.force = force;
  joint.unique = width == 1.0;
  snapshot.joints.push_back(joint);
}

void add_joints(Snapshot& snapshot) {
  const int floor = static_cast<int>(snapshot.boxes.size());
  add_joint(0, floor, 0.0, 1.0, Vec2(6.0, 15.0), snapshot);
  add_joint(1, floor, 0.0, 1.0, Vec2(0.0, 20.0), snapshot);
  add_joint(2, floor, 0.0, 1.0, Vec2(-6.0, 15.0), snapshot);
  add_joint(3, 0, -0.25, 0.5, Vec2(0.0, 5.0), snapshot);
  add_joint(3, 1, 0.25, 0.5, Vec2(0.0, 9.0), snapshot);
  add_joint(4, 1, -0.25, 0.5, Vec2(0.0, 9.0), snapshot);
  add_joint(4, 2, 0.25, 0.5, Vec2(0.0, 5.0), snapshot);
  add_joint(5, 3, -0.25, 0.5, Vec2(0.0, 4.9), snapshot);
  add_joint(5, 4, 0.25, 0.5, Vec2(0.0, 4.9), snapshot);
}

}  // namespace

Snapshot pyramid_snapshot() {
  Snapshot snapshot;
  snapshot.time = 1.25;
  snapshot.title = "Drei Würfel auf dreien";
  snapshot.energy = 153.27;
  snapshot.energy_start = 171.02;
  snapshot.gravity = Vec2(0.0, -9.81);
  snapshot.planes.push_back({"floor", Vec2(0.0, 0.0), Vec2::UnitY()});
  snapshot.planes.push_back({"slope", Vec2(5.0, 0.0), Vec2(-0.6, 0.8)});
  snapshot.boxes = {cube("a", -2.0, 0.5, 0.0, 0),  cube("b", -1.0, 0.5, 0.0, 1),
                    cube("c", 0.0, 0.5, 0.0, 2),   cube("d", -1.5, 1.5, 0.0, 3),
                    cube("e", -0.5, 1.5, 0.0, 4),  cube("f", -1.0, 2.5, 0.0, 5),
                    cube("g", 1.75, 2.25, 0.5, 6), cube("h", 3.25, 3.0, 1.1, 0)};
  snapshot.boxes[6].velocity = Vec2(0.5, -2.0);
  snapshot.boxes[7].velocity = Vec2(-1.0, -1.0);
  snapshot.boxes[7].color = {{0x7B, 0x4B, 0x94}};
  for (SnapshotBox& box : snapshot.boxes)
    box.mass = 1.0;
  snapshot.boxes[6].acceleration = Vec2(1.0, -8.0);
  snapshot.boxes[6].angular_acceleration = 6.0;
  snapshot.boxes[7].acceleration = snapshot.gravity;
  SnapshotBox shelf = cube("shelf", -3.75, 2.0, -0.125, 0);
  shelf.fixed = true;
  shelf.size = Vec2(1.5, 0.25);
  snapshot.boxes.push_back(shelf);
  add_support(0, 4.0, 11.0, snapshot);
  add_support(1, 10.0, 10.0, snapshot);
  add_support(2, 11.0, 4.0, snapshot);
  add_support(3, 5.0, 9.0, snapshot);
  add_support(4, 9.0, 5.0, snapshot);
  add_support(5, 4.9, 4.9, snapshot);
  snapshot.forces.push_back({Vec2(-2.5, 0.0), Vec2(6.0, 0.0), ForceKind::friction, 0});
  snapshot.forces.push_back({Vec2(0.5, 0.0), Vec2(-6.0, 0.0), ForceKind::friction, 2});
  add_joints(snapshot);
  snapshot.impacts = {{Vec2(1.2, 1.8), 3.0, 0.0}, {Vec2(0.5, 0.0), 1.0, 0.5}};
  for (const SnapshotBox& box : snapshot.boxes) {
    if (!box.fixed) add_points_and_rods(box, 3.0 + box.center.x() - 2.0 * box.center.y(), snapshot);
  }
  for (const std::size_t i : {std::size_t{6}, std::size_t{7}}) {
    SnapshotTrail trail;
    trail.color_index = snapshot.boxes[i].color_index;
    trail.color = snapshot.boxes[i].color;
    for (int k = 20; k >= 0; --k) {
      const double t = 0.05 * k;
      trail.path.emplace_back(snapshot.boxes[i].center - t * snapshot.boxes[i].velocity
                              - Vec2(0.0, t * t));
    }
    snapshot.trails.push_back(trail);
  }
  return snapshot;
}

Snapshot failing_snapshot() {
  Snapshot snapshot = pyramid_snapshot();
  snapshot.joints[3].range = {2.0, 12.0};
  snapshot.joints[4].range = {2.0, 40.0};
  snapshot.joints[7].range = {0.0, 9.8};
  snapshot.forces[0].range = {1.0, 9.0};
  snapshot.causes = {{.part = {6},
                      .centre = Vec2(1.75, 2.25),
                      .corner = Vec2(1.6, 1.6),
                      .beside = Vec2(1.75, 1.6),
                      .outside = 0.15},
                     {.part = {7}, .centre = Vec2(3.25, 3.0)}};
  snapshot.mechanism = {{6, Vec2(0.5, -0.3), -0.6}, {7, Vec2(0.0, -1.0), 0.0}};
  return snapshot;
}

Snapshot two_cubes_snapshot() {
  Snapshot snapshot;
  snapshot.title = "A(p_i, p_j, p_k)";
  snapshot.boxes = {cube("w_ij", 0.0, 0.0, 0.0, 3), cube("w_k", 1.25, 1.25, 0.6, 1)};
  snapshot.sides.push_back({Vec2(-0.5, 0.5), Vec2(0.5, 0.5), Vec2(0.555, 1.12), 0.62});
  snapshot.sides.push_back({Vec2(0.5, -0.5), Vec2(-0.5, -0.5), Vec2(0.0, -0.25), -0.25});
  snapshot.sides.push_back({Vec2(-0.5, -0.5), Vec2(-0.5, 0.5), Vec2(-0.5, 0.0), 0.0});
  return snapshot;
}

FrameOptions literal_options(Layers layers) {
  FrameOptions options;
  options.layers = layers;
  options.force_scale = {0.04, 0.8, 0.3};
  options.metres_per_speed = 0.5;
  options.metres_per_acceleration = 0.05;
  options.full_rod_force = 5.0;
  options.legend = {LegendEntry::contact, LegendEntry::friction,  LegendEntry::several,
                    LegendEntry::range,   LegendEntry::mechanism, LegendEntry::cause};
  return options;
}

View literal_view(const Snapshot& snapshot,
                  const Style& style,
                  const FrameOptions& options,
                  int width,
                  int height) {
  Bounds bounds;
  bounds.include(snapshot, options.force_scale);
  return fit_view(bounds, width, height, frame_insets(style, options, width, height));
}

}  // namespace wuerfel::test
