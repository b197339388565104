#include "app/film/recording.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace wuerfel {

namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

}  // namespace

AccuracyWatch MotionSource::show_frames(const std::function<void(const Snapshot&)>& show) const {
  Simulation simulation(scene, motion);
  Progress progress(style, "simulating", instants.empty() ? 0.0 : instants.back().t, "s");
  simulation.set_pulse([&] {
    stop.check();
    progress.reached(simulation.reached());
  });
  for (const Instant& instant : instants) {
    stop.check();
    simulation.advance_to(instant.t);
    if (instant.frame) show(simulation.snapshot(request));
  }
  AccuracyWatch accuracy;
  accuracy.look(simulation, 0.0);
  return accuracy;
}

void MotionRange::include(const Snapshot& snapshot) {
  forces.include(snapshot);
  for (const SnapshotBox& box : snapshot.boxes)
    fastest = std::max(fastest, box.velocity.norm());
  for (const SnapshotRod& rod : snapshot.rods)
    largest_rod = std::max(largest_rod, std::abs(rod.tension));
}

std::size_t Recording::Scenery::bytes() const {
  return sizeof *this + bytes_of(boxes) + bytes_of(forces) + bytes_of(rods) + bytes_of(points)
         + bytes_of(contacts) + bytes_of(sides);
}

void Recording::add(Snapshot snapshot) {
  range_.include(snapshot);
  if (!kept()) return;
  Scenery scenery{{},
                  std::move(snapshot.forces),
                  std::move(snapshot.rods),
                  std::move(snapshot.points),
                  std::move(snapshot.contacts),
                  std::move(snapshot.sides)};
  scenery.boxes.reserve(snapshot.boxes.size());
  for (const SnapshotBox& box : snapshot.boxes)
    scenery.boxes.push_back({box.center, box.velocity, box.angle, box.spin});
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
      std::tie(box.center, box.velocity, box.angle, box.spin) =
          std::tie(pose.center, pose.velocity, pose.angle, pose.spin);
    }
    snapshot.forces = scenery.forces;
    snapshot.rods = scenery.rods;
    snapshot.points = scenery.points;
    snapshot.contacts = scenery.contacts;
    snapshot.sides = scenery.sides;
    show(snapshot);
  }
}

}  // namespace wuerfel
