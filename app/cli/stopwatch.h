/// What a run costs: wall-clock and processor time.
#pragma once

#include <chrono>

namespace wuerfel {

class Stopwatch {
 public:
  Stopwatch();

  /// s since construction.
  [[nodiscard]] double wall() const;
  /// s of all threads of this process and of the processes it has waited for, since construction.
  [[nodiscard]] double cpu() const;
  /// s of processor time that were spent before construction: loading the program, where the watch
  /// is started first of all.
  [[nodiscard]] double cpu_before() const { return cpu_start_; }

 private:
  std::chrono::steady_clock::time_point wall_start_;
  double cpu_start_ = 0.0;
};

}  // namespace wuerfel
