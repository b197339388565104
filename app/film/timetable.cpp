#include "app/film/timetable.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {

std::vector<double> frame_times(double end, const FrameRate& rate) {
  // 0.57 s at 100 frames/s are 57 frames after the first although the product is 56.99999999999999.
  const double exact = end * rate.fps / rate.speed;
  const auto last = static_cast<long>(std::floor(exact + 1e-9 * std::max(1.0, exact)));
  std::vector<double> times;
  times.reserve(last + 1);
  for (long k = 0; k <= last; ++k) {
    times.push_back(std::min(end, static_cast<double>(k) * rate.speed / rate.fps));
  }
  return times;
}

std::vector<Instant> timetable(double end,
                               const std::vector<double>& frames,
                               const std::vector<double>& samples) {
  std::vector<Instant> instants;
  instants.reserve(frames.size() + samples.size() + 1);
  for (const double t : frames)
    instants.push_back({.t = t, .frame = true});
  for (const double t : samples)
    instants.push_back({.t = t, .sample = true});
  instants.push_back({.t = end});
  std::ranges::stable_sort(instants, {}, &Instant::t);

  // Equal instants become one that is everything they were.
  std::vector<Instant> merged;
  for (const Instant& instant : instants) {
    if (merged.empty() || merged.back().t != instant.t) {
      merged.push_back(instant);
    } else {
      merged.back().frame |= instant.frame;
      merged.back().sample |= instant.sample;
    }
  }
  return merged;
}

}  // namespace wuerfel
