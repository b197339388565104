/// A run to be drawn later: view and force scale are one for the whole film, so the film must be
/// known first.
#pragma once

#include <vector>

#include "core/snapshot.h"

namespace wuerfel {

/// Snapshots kept compactly: what never changes (names, sizes, colours, fixed boxes, planes) once,
/// the rest once per frame, and where nothing moved not again.
class Recording {
 public:
  void add(const Snapshot& snapshot);

  [[nodiscard]] std::size_t size() const { return frames_.size(); }
  [[nodiscard]] double time(std::size_t k) const { return frames_[k].time; }
  [[nodiscard]] bool empty() const { return frames_.empty(); }

  /// The snapshot of frame `k`. Its revision is that of the frame before where nothing but time has
  /// changed.
  [[nodiscard]] Snapshot frame(std::size_t k) const;

  /// Where the cubes' centres have been in the frames 0 .. k.
  [[nodiscard]] std::vector<SnapshotTrail> trails(std::size_t k) const;

 private:
  struct Pose {
    Vec2 center;
    double angle;
    Vec2 velocity;
    double spin;
    bool operator==(const Pose&) const = default;
  };
  /// What changes while cubes move.
  struct Scenery {
    std::vector<Pose> poses;
    std::vector<SnapshotForce> forces;
    std::vector<SnapshotRod> rods;
    std::vector<SnapshotPoint> points;
    std::vector<SnapshotContact> contacts;
    std::vector<SnapshotSide> sides;
  };
  struct Frame {
    double time;
    double energy;
    std::size_t scenery;
  };

  static bool equal(const Scenery& a, const Scenery& b);

  Snapshot cast_;  // the first snapshot: everything that stays
  std::vector<Scenery> sceneries_;
  std::vector<Frame> frames_;
};

}  // namespace wuerfel
