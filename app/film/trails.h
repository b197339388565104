/// Where cubes have been.
#pragma once

#include <cstddef>
#include <vector>

#include "core/snapshot.h"

namespace wuerfel {

/// Follows the centres of all cubes. A path has at most 2048 places: where it would have more,
/// every second one is left out from then on, so that memory is bounded.
class Trails {
 public:
  /// The next moment.
  void add(const Snapshot& snapshot);
  /// Up to the last moment, which is always the end of a path.
  [[nodiscard]] const std::vector<SnapshotTrail>& paths() const { return paths_; }

 private:
  void thin_out();

  std::vector<SnapshotTrail> paths_;
  std::size_t moments_ = 0;
  std::size_t stride_ = 1;      // moments from one place to the next
  bool last_is_extra_ = false;  // the last places are no multiples of the stride
};

}  // namespace wuerfel
