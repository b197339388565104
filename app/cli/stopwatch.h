/// What a run costs: wall-clock and processor time.
#pragma once

#include <chrono>

namespace wuerfel {

class Stopwatch {
 public:
  /// Whose processor time counts: that of all threads of this process or of the calling thread, and of
  /// the processes that these have waited for.
  enum class Of { process, thread };

  explicit Stopwatch(Of whom = Of::process);

  /// s since construction.
  [[nodiscard]] double wall() const;
  /// s of processor time since construction.
  [[nodiscard]] double cpu() const;
  /// s of processor time that were spent before construction: loading the program, where the watch
  /// is started first of all.
  [[nodiscard]] double cpu_before() const { return cpu_start_; }

 private:
  Of whom_;
  std::chrono::steady_clock::time_point wall_start_;
  double cpu_start_ = 0.0;
};

}  // namespace wuerfel
