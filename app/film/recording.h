/// A run to be drawn later: view and force scale are one for all pictures, so the whole motion must
/// be known first.
#pragma once

#include <cstdint>
#include <vector>

#include "app/film/byte_log.h"
#include "core/snapshot.h"

namespace wuerfel {

/// Numbers snapshots so that equal revisions are equal pictures but for the time shown.
class Revisions {
 public:
  /// The numbers behind what a picture of `snapshot` shows, without time and energy.
  using Scenery = std::vector<double>;

  /// Gives the next snapshot its revision: that of the one before where nothing but time and energy
  /// has changed. True where it is new.
  bool stamp(Snapshot& snapshot);
  /// Of the last snapshot.
  [[nodiscard]] const Scenery& scenery() const { return scenery_; }

 private:
  Scenery scenery_;
  std::uint64_t revision_ = 0;
};

/// Snapshots kept compactly: what never changes (names, sizes, colours, fixed boxes, planes) once,
/// the rest once per frame, and where nothing moved not again. Memory is bounded (see ByteLog).
class Recording {
 public:
  void add(Snapshot snapshot);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

  /// Goes through the snapshots from the first to the last.
  class Replay {
   public:
    explicit Replay(const Recording& recording) : recording_(recording) {}
    /// False behind the last. `snapshot` has to be the one of the call before.
    bool next(Snapshot& snapshot);

   private:
    const Recording& recording_;
    std::size_t done_ = 0;
    std::uint64_t at_ = 0;  // bytes
  };

 private:
  Snapshot first_;
  Revisions revisions_;
  ByteLog log_;  // of each frame: time, energy, revision, how many numbers follow, the numbers
  std::size_t size_ = 0;
};

}  // namespace wuerfel
