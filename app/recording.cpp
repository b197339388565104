#include "app/recording.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace wuerfel {

// Rods, points, contacts and sides follow from the poses; forces do not.
bool Recording::equal(const Scenery& a, const Scenery& b) {
  const auto same_force = [](const SnapshotForce& f, const SnapshotForce& g) {
    return f.point == g.point && f.force == g.force && f.kind == g.kind;
  };
  const auto same_tension = [](const SnapshotRod& r, const SnapshotRod& s) {
    return r.tension == s.tension;
  };
  return a.poses == b.poses && std::ranges::equal(a.forces, b.forces, same_force)
         && std::ranges::equal(a.rods, b.rods, same_tension);
}

void Recording::add(const Snapshot& snapshot) {
  Scenery scenery;
  scenery.poses.reserve(snapshot.boxes.size());
  for (const SnapshotBox& box : snapshot.boxes) {
    scenery.poses.push_back({box.center, box.angle, box.velocity, box.spin});
  }
  scenery.forces = snapshot.forces;
  scenery.rods = snapshot.rods;
  scenery.points = snapshot.points;
  scenery.contacts = snapshot.contacts;
  scenery.sides = snapshot.sides;
  if (sceneries_.empty() || !equal(sceneries_.back(), scenery))
    sceneries_.push_back(std::move(scenery));

  frames_.push_back({snapshot.time, snapshot.energy, sceneries_.size() - 1});
  if (frames_.size() == 1) cast_ = snapshot;
}

Snapshot Recording::frame(std::size_t k) const {
  assert(k < frames_.size());
  const Frame& frame = frames_[k];
  const Scenery& scenery = sceneries_[frame.scenery];
  Snapshot snapshot = cast_;
  snapshot.time = frame.time;
  snapshot.energy = frame.energy;
  snapshot.revision = frame.scenery;
  for (std::size_t b = 0; b < snapshot.boxes.size(); ++b) {
    SnapshotBox& box = snapshot.boxes[b];
    const Pose& pose = scenery.poses[b];
    box.center = pose.center;
    box.angle = pose.angle;
    box.velocity = pose.velocity;
    box.spin = pose.spin;
  }
  snapshot.forces = scenery.forces;
  snapshot.rods = scenery.rods;
  snapshot.points = scenery.points;
  snapshot.contacts = scenery.contacts;
  snapshot.sides = scenery.sides;
  return snapshot;
}

std::vector<SnapshotTrail> Recording::trails(std::size_t k) const {
  std::vector<SnapshotTrail> trails;
  for (std::size_t b = 0; b < cast_.boxes.size(); ++b) {
    const SnapshotBox& box = cast_.boxes[b];
    if (box.fixed) continue;
    SnapshotTrail& trail = trails.emplace_back();
    trail.color_index = box.color_index;
    trail.color = box.color;
    for (std::size_t s = 0; s <= frames_[k].scenery; ++s) {
      const Vec2& center = sceneries_[s].poses[b].center;
      if (trail.path.empty() || trail.path.back() != center) trail.path.push_back(center);
    }
  }
  return trails;
}

}  // namespace wuerfel
