/// Simulations as bytes, and back.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/python/simulation.h"

namespace wuerfel::python {

/// Restart points of a motion from which the times that were looked at can be reached again.
class RestartPoints {
 public:
  /// Up to where the motion is about to be looked at, s: points before it supersede those before them.
  void expect(double t) { goal_ = t; }
  void note(std::string point, std::size_t cubes);
  /// The last one not after t; empty: the start.
  [[nodiscard]] const std::string& before(double t) const;

 private:
  double goal_ = 0.0;
  std::vector<std::pair<double, std::string>> points_;  // by their times, s
};

/// What a simulation can be made of again, to the same bits.
struct SimulationRecord {
  std::string scene;  ///< JSON
  MotionNames motion;
  double t = 0.0;  ///< s
  std::string restart_point;
};

std::string to_bytes(SimulationRecord record);
/// Throws UsageError where the bytes are none, damaged, or another version's.
SimulationRecord record_of(std::string_view bytes);

}  // namespace wuerfel::python
