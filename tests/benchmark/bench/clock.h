/// How long a piece of work takes, least of many repeats.
#pragma once

#include <algorithm>
#include <limits>
#include <time.h>

namespace wuerfel {

/// s of processor time of all threads of this process.
inline double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct BestTime {
  double seconds = std::numeric_limits<double>::infinity();
  long repeats = 0;
};

/// Repeats `work` until `budget` s of processor time are used, once at least. Short work is done
/// several times between two looks at the clock.
template <class Work>
BestTime best_time(double budget, Work&& work) {
  constexpr double shortest = 50e-6;  // s between two looks at the clock
  constexpr double most_rounds = 2000;
  BestTime best;
  double used = 0.0;
  long batch = 1;
  for (int round = 0; round == 0 || (round < most_rounds && used < budget); ++round) {
    const double start = processor_seconds();
    for (long k = 0; k < batch; ++k)
      work();
    const double seconds = (processor_seconds() - start) / static_cast<double>(batch);
    used += seconds * static_cast<double>(batch);
    best.seconds = std::min(best.seconds, seconds);
    best.repeats += batch;
    batch = std::clamp(static_cast<long>(shortest / std::max(seconds, 1e-9)), 1L, 1000L);
  }
  return best;
}

}  // namespace wuerfel
