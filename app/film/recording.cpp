#include "app/film/recording.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/cli/pace.h"
#include "render/picture/frame_options.h"
#include "render/picture/impacts.h"

namespace wuerfel {

namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

}  // namespace

AccuracyWatch MotionSource::show_frames(const std::function<void(const Snapshot&)>& show) const {
  Simulation simulation(scene, motion);
  const double end = instants.empty() ? 0.0 : instants.back().t;
  Progress progress(style, "simulating", end, "s");
  watch_steps(simulation, scene, motion.integrator, end, stop, &progress);
  FrameTaker taker(request, passing, back);
  AccuracyWatch accuracy;
  bool looked = false;
  for (const TimetableEntry& instant : instants) {
    stop.check();
    simulation.advance_to(instant.t);
    if (is_seen(instant)) {
      if (const auto snapshot = taker.take(simulation, simulation.moment(), instant))
        show(*snapshot);
    }
    if (!instant.sample) continue;
    accuracy.look(simulation, 0.0);
    looked = true;
  }
  if (!looked) accuracy.look(simulation, 0.0);
  return accuracy;
}

bool MotionSource::scales_at(double t) const {
  if (instants.empty()) return true;
  const auto instant = std::ranges::lower_bound(instants, t, {}, &TimetableEntry::t);
  return instant != instants.end() && instant->t == t && instant->scales;
}

void MotionRange::include(const Snapshot& snapshot) {
  forces.include(snapshot);
  for (const SnapshotBox& box : snapshot.boxes)
    fastest = std::max(fastest, box.velocity.norm());
  for (const SnapshotMass& mass : snapshot.masses)
    fastest = std::max(fastest, mass.velocity.norm());
  for (const SnapshotContact& contact : snapshot.contacts)
    fastest = std::max({fastest, contact.v_i.norm(), contact.v_j.norm(), contact.v_k.norm()});
  for (const SnapshotRod& rod : snapshot.rods)
    largest_rod = std::max(largest_rod, std::abs(rod.tension));
  for (const SnapshotLink& link : snapshot.links) {
    largest_rod = std::max(largest_rod, std::abs(link.tension));
    linked = linked || !link.force.isZero(0.0);
  }
  for (const SnapshotBox& box : snapshot.boxes)
    largest_acceleration = std::max(largest_acceleration, box.acceleration.norm());
  gravity = snapshot.gravity.norm();
  for (const double load : joint_loads(snapshot))
    loads.include(load);
  largest_load = std::max(largest_load, largest_value(snapshot, ColorBy::load));
  notice(snapshot);
}

void MotionRange::notice(const Snapshot& snapshot) {
  if (!snapshot.joints.empty() || !snapshot.forces.empty()) seen.insert(LegendEntry::contact);
  if (shows_impacts(snapshot)) seen.insert(LegendEntry::impact);
  if (!snapshot.mechanism.empty()) seen.insert(LegendEntry::mechanism);
  if (!snapshot.causes.empty()) seen.insert(LegendEntry::cause);
  for (const SnapshotSide& side : snapshot.sides)
    if (is_negative(side)) seen.insert(LegendEntry::negative);
  for (const SnapshotJoint& joint : snapshot.joints) {
    if (!joint.unique) seen.insert(LegendEntry::several);
    if (joint.range) include(*joint.range);
  }
  for (const SnapshotForce& force : snapshot.forces) {
    if (!force.unique) seen.insert(LegendEntry::several);
    if (force.range) include(*force.range);
    if (force.kind == ForceKind::friction) seen.insert(LegendEntry::friction);
  }
}

void MotionRange::include(const SnapshotRange& range) {
  seen.insert(LegendEntry::range);
  most_possible = std::max(most_possible, range.most);
}

std::size_t Recording::Scenery::bytes() const {
  return sizeof *this + bytes_of(boxes) + bytes_of(forces) + bytes_of(joints) + bytes_of(impacts)
         + bytes_of(loads) + bytes_of(rods) + bytes_of(points) + bytes_of(contacts)
         + bytes_of(sides) + bytes_of(masses) + bytes_of(links) + bytes_of(causes)
         + bytes_of(mechanism);
}

void Recording::add(Snapshot snapshot) {
  seen_.include(snapshot);
  if (source_->scales_at(snapshot.time)) chosen_.include(snapshot);
  if (!kept()) return;
  Scenery scenery{{},
                  std::move(snapshot.forces),
                  std::move(snapshot.joints),
                  std::move(snapshot.impacts),
                  std::move(snapshot.loads),
                  std::move(snapshot.rods),
                  std::move(snapshot.points),
                  std::move(snapshot.contacts),
                  std::move(snapshot.sides),
                  snapshot.masses,
                  snapshot.links,
                  std::move(snapshot.causes),
                  std::move(snapshot.mechanism)};
  scenery.boxes.reserve(snapshot.boxes.size());
  for (const SnapshotBox& box : snapshot.boxes) {
    scenery.boxes.push_back({box.center, box.velocity, box.angle, box.spin, box.acceleration,
                             box.angular_acceleration});
  }
  Frame frame{snapshot.time, snapshot.energy, nullptr};
  bytes_ += sizeof frame;
  if (!frames_.empty() && *frames_.back().scenery == scenery) {
    frame.scenery = frames_.back().scenery;
  } else {
    bytes_ += scenery.bytes();
    frame.scenery = std::make_shared<const Scenery>(std::move(scenery));
  }
  if (frames_.empty()) first_ = std::move(snapshot);
  frames_.push_back(std::move(frame));
  if (!kept()) frames_ = {};
}

MotionRange Recording::range() const {
  MotionRange range = seen_;
  range.forces = chosen_.forces;
  range.loads = chosen_.loads;
  return range;
}

void Recording::for_each(const std::function<void(const Snapshot&)>& show) const {
  if (!kept()) {
    source_->show_frames(show);
    return;
  }
  Snapshot snapshot = first_;
  for (const Frame& frame : frames_) {
    snapshot.time = frame.time;
    snapshot.energy = frame.energy;
    const Scenery& scenery = *frame.scenery;
    for (std::size_t i = 0; i < scenery.boxes.size(); ++i) {
      const Pose& pose = scenery.boxes[i];
      SnapshotBox& box = snapshot.boxes[i];
      std::tie(box.center, box.velocity, box.angle, box.spin, box.acceleration,
               box.angular_acceleration) =
          std::tie(pose.center, pose.velocity, pose.angle, pose.spin, pose.acceleration,
                   pose.angular_acceleration);
    }
    snapshot.forces = scenery.forces;
    snapshot.joints = scenery.joints;
    snapshot.impacts = scenery.impacts;
    snapshot.loads = scenery.loads;
    snapshot.rods = scenery.rods;
    snapshot.points = scenery.points;
    snapshot.contacts = scenery.contacts;
    snapshot.sides = scenery.sides;
    snapshot.masses = scenery.masses;
    snapshot.links = scenery.links;
    snapshot.causes = scenery.causes;
    snapshot.mechanism = scenery.mechanism;
    show(snapshot);
  }
}

}  // namespace wuerfel
