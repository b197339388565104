#include "core/time/crowding.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// Events per frame that are too many, and the longest stepping.
constexpr long most_events = 25;
constexpr long most_events_again = 5;  ///< where stepping was needed not long ago
constexpr long fewest_events = 3;
/// An event costs as much as the group is large: large groups are given fewer of them.
constexpr long most_events_and_cubes = 300;
/// Beyond so many steps of what touches the motion would not get on; with `--integrator event` beyond so many events. A window,
/// after which the cubes may be grouped anew and are counted from none, is not over before.
constexpr long most_steps = 500;
constexpr int most_patience = 32;

}  // namespace

void Crowding::begin(double time, double t, int patience) {
  frame_ = time / frames_per_time;
  patience_ = patience;
  step_to(t);
}

double Crowding::frames_after(double t, double frames) const {
  return (std::round(t / frame_) + frames) * frame_;
}

void Crowding::count(double t, long events, long steps) {
  const auto now = static_cast<long>(std::floor(t / frame_));
  if (now != number_) {
    former_events_ = now == number_ + 1 ? events_ : 0;
    events_ = steps_ = 0;
    number_ = now;
  }
  events_ += events;
  steps_ += steps;
}

bool Crowding::crowds() const { return events_ > affordable() || steps_ > most_steps; }

bool Crowding::calm() const { return std::max(events_, former_events_) <= affordable(); }

long Crowding::affordable() const {
  if (only_events_) return most_steps;
  return std::clamp(most_events_and_cubes / std::max(1, cubes_), fewest_events,
                    patience_ > 1 ? most_events_again : most_events);
}

double Crowding::step_from(double t) {
  // Soon after the last time: longer. After a long time without: as at first.
  if (t - stepped_to_ > most_patience * frame_) patience_ = 1;
  const double until = (std::floor(t / frame_) + 1.0 + patience_) * frame_;
  patience_ = std::min(2 * patience_, most_patience);
  return until;
}

void Crowding::step_to(double t) {
  stepped_to_ = t;
  events_ = former_events_ = steps_ = 0;
}

}  // namespace wuerfel
