#include "app/film/timetable.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "app/cli/exit_code.h"

namespace wuerfel {

long frame_count(double end, const FrameRate& rate) {
  constexpr double most_frames = 1e7;
  // 0.57 s at 100 frames/s are 57 frames after the first although the product is 56.99999999999999.
  const double exact = end * rate.fps / rate.speed;
  if (!(exact < most_frames)) {
    throw UsageError(fmt::format(
        "{:.3g} frames are more than {:.0f}; fewer are needed with a shorter --until or "
        "--hold, a smaller --fps, or --fit instant for a figure",
        exact, most_frames));
  }
  return static_cast<long>(std::floor(exact + 1e-9 * std::max(1.0, exact))) + 1;
}

void require_possible_steps(double end, const MotionSettings& motion) {
  constexpr double most_steps = 1e14;
  const bool by_steps =
      motion.integrator != Integrator::automatic && motion.integrator != Integrator::event;
  if (by_steps && !(end <= most_steps * motion.step)) {
    throw UsageError(fmt::format("--step: {:.3g} steps to the end at {} s are more than {:.0g}",
                                 end / motion.step, end, most_steps));
  }
}

std::vector<double> frame_times(double end, const FrameRate& rate) {
  const long count = frame_count(end, rate);
  std::vector<double> times;
  times.reserve(count);
  for (long k = 0; k < count; ++k)
    times.push_back(std::min(end, static_cast<double>(k) * rate.speed / rate.fps));
  return times;
}

std::vector<TimetableEntry> timetable(double end,
                                      const std::vector<double>& frames,
                                      const std::vector<double>& samples,
                                      const std::vector<double>& marks) {
  std::vector<TimetableEntry> instants;
  instants.reserve(frames.size() + samples.size() + marks.size() + 1);
  for (const double t : frames)
    instants.push_back({.t = t, .frame = true});
  for (const double t : samples)
    instants.push_back({.t = t, .sample = true});
  for (const double t : marks)
    instants.push_back({.t = t});
  instants.push_back({.t = end});
  return merged(std::move(instants), {});
}

void mark_scales(std::vector<TimetableEntry>& instants) {
  constexpr std::ptrdiff_t enough = 40;
  const auto frames = std::ranges::count(instants, true, &TimetableEntry::frame);
  const std::ptrdiff_t every = std::max<std::ptrdiff_t>(frames / enough, 1);
  std::ptrdiff_t k = 0;
  for (TimetableEntry& instant : instants)
    if (instant.frame) instant.scales = k++ % every == 0;
}

std::vector<TimetableEntry> merged(std::vector<TimetableEntry> instants,
                                   const std::vector<TimetableEntry>& more) {
  instants.insert(instants.end(), more.begin(), more.end());
  std::ranges::stable_sort(instants, {}, &TimetableEntry::t);
  std::vector<TimetableEntry> result;
  for (const TimetableEntry& instant : instants) {
    if (result.empty() || result.back().t != instant.t) {
      result.push_back(instant);
    } else {
      result.back().frame |= instant.frame;
      result.back().sample |= instant.sample;
      result.back().look |= instant.look;
    }
  }
  return result;
}

}  // namespace wuerfel
