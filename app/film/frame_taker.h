/// Snapshots for pictures: forces averaged over the time before them, and impacts of a moment ago. A
/// force that lasts less than a frame is as short as it is in the film, and an impact between two
/// frames is seen.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/film/timetable.h"
#include "core/snapshot.h"
#include "core/time/simulation.h"

namespace wuerfel {

/// How far a picture looks back.
struct LookBack {
  double average = 0.0;  ///< s, over which forces are averaged, impulses included; 0: not at all
  double impacts = 0.0;  ///< s, for which impacts leave a mark; 0: none
  double loads = 0.0;    ///< s, over which loads are averaged that colours tell; 0: as forces
};

/// An average is of the looks at both ends of so many equal parts of its time (trapezoidal rule). The
/// first is that of the frame before, the last that of the frame itself.
constexpr int parts_of_average = 2;

/// The instants and, before each frame, those at which its forces are looked at; loads of frames that
/// were asked for farther back.
std::vector<TimetableEntry> with_looks(std::vector<TimetableEntry> instants, const LookBack& back);

class FrameTaker {
 public:
  /// Of frames that were not asked for `passing` is enough.
  FrameTaker(const SnapshotRequest& request, const SnapshotRequest& passing, const LookBack& back)
      : request_(request), passing_(passing), back_(back) {}

  /// What a motion shows at one of its instants, and at that moment; nothing where there is no frame.
  std::optional<Snapshot> take(const Simulation& simulation,
                               const Moment& moment,
                               const TimetableEntry& instant);

 private:
  using Joints = std::vector<SnapshotJoint>;
  using Loads = std::vector<double>;
  struct Look {
    double t;
    std::shared_ptr<const Joints> joints;  // of the time that forces are averaged over
    std::shared_ptr<const Loads> loads;
  };
  /// A snapshot of what has not moved since.
  struct Seen {
    SnapshotRequest request;
    std::shared_ptr<const Snapshot> snapshot;
    std::shared_ptr<const Loads> loads;
  };

  const Seen& see(const Simulation& simulation,
                  const Moment& moment,
                  const SnapshotRequest& request);
  void remember(double t, const Seen& seen);
  void forget(double t);
  void notice_impacts(const std::vector<Event>& events, double t);
  [[nodiscard]] const Look* look_at(double t, double close) const;
  [[nodiscard]] Joints averaged(const Snapshot& snapshot) const;
  [[nodiscard]] Loads averaged_loads(double t) const;
  [[nodiscard]] std::vector<SnapshotImpact> marks(double t) const;

  SnapshotRequest request_;
  SnapshotRequest passing_;
  LookBack back_;
  std::deque<Look> looks_;  // by their times, the latest last
  std::deque<Event> impacts_;
  std::size_t noticed_ = 0;  // of the motion's events
  Moment last_;
  std::vector<Seen> seen_;  // at the last moment, and still as it was
};

}  // namespace wuerfel
