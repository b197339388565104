// Where forces run through the bodies: lines of thrust with their hinges, quiet paths below the arrows,
// chains through crowds.
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

constexpr double thrust_width = 2.4;
constexpr double dash = 8.0;
constexpr double dash_gap = 5.0;
constexpr double widest_chain = 0.3;   ///< of the side of a typical cube
constexpr double thinnest_path = 1.2;  ///< px
constexpr double widest_path = 6.0;    ///< px, of the longest arrow's force

/// A way of a force through a body.
struct Path {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  double newton = 0.0;
};

void add_dashes(const FrameParts& parts, const Path& path) {
  SegmentShape stroke;
  stroke.half_width = 0.5F * parts.weight(thrust_width);
  stroke.round = 0.0F;
  stroke.color = parts.style.thrust;
  const Vec2 way = path.to - path.from;
  const double length = way.norm();
  const double period = parts.metres((dash + dash_gap) * parts.unit);
  const double drawn = parts.metres(dash * parts.unit);
  for (int k = 0; k * period < length && k < 1000; ++k) {
    const double end = std::min(k * period + drawn, length);
    stroke.from = parts.pixel(path.from + k * period / length * way);
    stroke.to = parts.pixel(path.from + end / length * way);
    parts.list.add(stroke);
  }
}

/// The joints of a box: those that carry it, and those by which it carries.
struct Loads {
  std::vector<const SnapshotJoint*> below;
  std::vector<const SnapshotJoint*> above;
};

std::vector<Loads> loads_of_boxes(const Snapshot& snapshot) {
  std::vector<Loads> of(snapshot.boxes.size());
  for (const SnapshotJoint& joint : snapshot.joints) {
    if (joint.body >= 0) of[joint.body].below.push_back(&joint);
    if (joint.other >= 0 && joint.other < std::ssize(of)) of[joint.other].above.push_back(&joint);
  }
  return of;
}

/// Where the forces of a box meet: at the centre of one that carries nothing, else in their middle.
Vec2 hub(const SnapshotBox& box, const Loads& of) {
  if (of.above.empty()) return box.center;
  Vec2 sum = Vec2::Zero();
  double total = 0.0;
  for (const auto* side : {&of.above, &of.below}) {
    for (const SnapshotJoint* joint : *side) {
      sum += joint->force.norm() * joint->point;
      total += joint->force.norm();
    }
  }
  return sum / total;
}

/// From the joints above a box to those below it: straight where there is one of each, else by way of
/// the hub.
std::vector<Path> paths_of(const Snapshot& snapshot) {
  const std::vector<Loads> of = loads_of_boxes(snapshot);
  std::vector<Path> paths;
  for (std::size_t i = 0; i < of.size(); ++i) {
    const auto& [below, above] = of[i];
    if (below.empty()) continue;
    if (below.size() == 1 && above.size() == 1) {
      paths.push_back({above.front()->point, below.front()->point, below.front()->force.norm()});
      continue;
    }
    const Vec2 middle = hub(snapshot.boxes[i], of[i]);
    for (const auto* side : {&above, &below}) {
      for (const SnapshotJoint* joint : *side)
        paths.push_back({joint->point, middle, joint->force.norm()});
    }
  }
  return paths;
}

/// Whether the resultant acts at an end of the face: the body is about to turn about it.
bool is_hinge(const SnapshotJoint& joint) {
  constexpr double share = 5e-3;
  const double nearest =
      std::min((joint.point - joint.from).norm(), (joint.point - joint.to).norm());
  return nearest <= share * (joint.to - joint.from).norm();
}

}  // namespace

void add_thrust(const FrameParts& parts) {
  const std::vector<Path> paths = paths_of(parts.snapshot);
  SegmentShape halo;
  halo.half_width = 0.5F * parts.weight(thrust_width) + parts.weight(0.8 * parts.style.halo_width);
  halo.color = with_alpha(parts.style.halo, 1.0);
  for (const Path& path : paths) {
    if (parts.style.halo.a == 0) break;
    halo.from = parts.pixel(path.from);
    halo.to = parts.pixel(path.to);
    parts.list.add(halo);
  }
  for (const Path& path : paths)
    add_dashes(parts, path);
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    if (!is_hinge(joint)) continue;
    DiscShape hinge;
    hinge.center = parts.pixel(joint.point);
    hinge.radius = parts.weight(5.0);
    hinge.outline_width = parts.weight(2.2);
    hinge.fill = with_alpha(parts.style.joint, 1.0);
    hinge.outline = parts.style.thrust;
    parts.list.add(hinge);
  }
}

// The wider, the larger the force.
void add_paths(const FrameParts& parts) {
  const ForceScale& scale = parts.options.force_scale;
  const double full = scale.longest / scale.metres_per_newton;
  SegmentShape line;
  line.color = with_alpha(parts.style.ink, path_alpha);
  for (const Path& path : paths_of(parts.snapshot)) {
    const double share = std::min(path.newton / full, 1.0);
    line.half_width = 0.5F * parts.weight(thinnest_path + (widest_path - thinnest_path) * share);
    line.from = parts.pixel(path.from);
    line.to = parts.pixel(path.to);
    parts.list.add(line);
  }
}

void add_chains(const FrameParts& parts) {
  const ForceScale& scale = parts.options.force_scale;
  SegmentShape chain;
  chain.color = with_alpha(parts.style.chain, 0.85);
  const auto& boxes = parts.snapshot.boxes;
  for (const SnapshotJoint& joint : parts.snapshot.joints) {
    const double length = std::min(scale.metres_per_newton * joint.force.norm(), scale.longest);
    const double width = widest_chain * length * parts.view.pixels_per_metre;
    if (width < 0.25) continue;
    chain.half_width = static_cast<float>(0.5 * width);
    const Pixel place = parts.pixel(joint.point);
    const bool box = joint.other >= 0 && joint.other < std::ssize(boxes);
    const Vec2 other =
        box ? boxes[joint.other].center
            : Vec2(joint.point - 0.4 * boxes[joint.body].size.minCoeff() * joint.normal);
    for (const Pixel end : {parts.pixel(boxes[joint.body].center), parts.pixel(other)}) {
      chain.from = place;
      chain.to = end;
      parts.list.add(chain);
    }
  }
}

}  // namespace wuerfel::internal
