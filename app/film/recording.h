/// A motion to be drawn when its end is known: view and arrow scales are one for all pictures.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/cli/progress.h"
#include "app/cli/stop_signal.h"
#include "app/film/frame_taker.h"
#include "app/film/timetable.h"
#include "app/output/accuracy.h"
#include "core/scene/scene.h"
#include "core/settings.h"
#include "core/snapshot.h"
#include "core/time/simulation.h"
#include "render/picture/body_color.h"
#include "render/picture/force_scale.h"
#include "render/picture/layers.h"

namespace wuerfel {

/// A motion that can be gone through again and again, each time with the same bits.
struct MotionSource {
  const Scene& scene;
  MotionSettings motion;
  std::vector<TimetableEntry> instants;
  SnapshotRequest request;
  SnapshotRequest passing;  ///< of frames that are only on the way to those asked for
  LookBack back;
  const StopSignal& stop;
  Progress::Style style = Progress::Style::silent;  ///< of how far it is

  /// Simulates it from the start and shows its frames; how exact it was up to the last instant that
  /// was asked for, or to the end. Throws Interrupted.
  AccuracyWatch show_frames(const std::function<void(const Snapshot&)>& show) const;
  /// Whether the scales of arrows fit the frame of this instant; of any, where there is no timetable.
  [[nodiscard]] bool scales_at(double t) const;
};

/// What a whole motion tells of the arrows.
struct MotionRange {
  ForceRange forces;
  double fastest = 0.0;               ///< m/s
  double largest_rod = 0.0;           ///< N
  double largest_acceleration = 0.0;  ///< m/s^2
  double gravity = 0.0;               ///< m/s^2
  ForceRange loads;                   ///< on one cube
  double largest_load = 0.0;          ///< N, that its colour tells
  double most_possible = 0.0;         ///< N, of the ranges of forces; may be infinite
  Legend seen;                        ///< kinds of forces
  bool linked = false;                ///< a rod or a pin bears a force

  void include(const Snapshot& snapshot);

 private:
  void include(const SnapshotRange& range);
  /// What the legend has to explain.
  void notice(const Snapshot& snapshot);
};

/// The frames of a motion. What never changes (names, sizes, colours, fixed boxes, planes) is kept
/// once; what moves once per frame, and not again where nothing did. Memory is bounded: a motion
/// that would take more than the limit is not kept but simulated again when it is asked for.
class Recording {
 public:
  static constexpr std::size_t default_limit = std::size_t{512} << 20U;  // bytes

  /// `source` lives longer than the recording.
  explicit Recording(const MotionSource& source, std::size_t limit = default_limit)
      : source_(&source), limit_(limit) {}

  void add(Snapshot snapshot);
  /// Boxes that pictures show besides those of the frames, and that views have room for.
  void add_besides(std::vector<SnapshotBox> boxes) { besides_ = std::move(boxes); }
  [[nodiscard]] const std::vector<SnapshotBox>& besides() const { return besides_; }
  /// What scales fit: forces and loads of the frames chosen for it, and all else of all frames.
  [[nodiscard]] MotionRange range() const;
  /// Of all frames.
  [[nodiscard]] const MotionRange& seen() const { return seen_; }
  /// All frames in their order.
  void for_each(const std::function<void(const Snapshot&)>& show) const;

 private:
  struct Pose {
    Vec2 center;
    Vec2 velocity;
    double angle;
    double spin;
    Vec2 acceleration;
    double angular_acceleration;
    bool operator==(const Pose&) const = default;
  };
  /// All that a picture shows besides what never changes and the time.
  struct Scenery {
    std::vector<Pose> boxes;
    std::vector<SnapshotForce> forces;
    std::vector<SnapshotJoint> joints;
    std::vector<SnapshotImpact> impacts;
    std::vector<double> loads;
    std::vector<SnapshotRod> rods;
    std::vector<SnapshotPoint> points;
    std::vector<SnapshotContact> contacts;
    std::vector<SnapshotSide> sides;
    std::vector<SnapshotMass> masses;
    std::vector<SnapshotLink> links;
    std::vector<SnapshotCause> causes;
    std::vector<SnapshotMotion> mechanism;
    bool operator==(const Scenery&) const = default;
    [[nodiscard]] std::size_t bytes() const;
  };
  struct Frame {
    double time;
    double energy;
    std::shared_ptr<const Scenery> scenery;
  };

  [[nodiscard]] bool kept() const { return bytes_ <= limit_; }

  const MotionSource* source_;
  std::size_t limit_;
  MotionRange chosen_;
  MotionRange seen_;
  Snapshot first_;
  std::vector<Frame> frames_;
  std::vector<SnapshotBox> besides_;
  std::size_t bytes_ = 0;
};

}  // namespace wuerfel
