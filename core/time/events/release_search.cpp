#include "core/time/events/release_search.h"

#include <algorithm>

namespace wuerfel {
namespace {

/// A gap's acceleration beyond this share of g is an opening.
constexpr double opening_share = 1e-8;
/// Samples of forces within a step whose stages saw one vanish.
constexpr int force_samples = 8;
/// Brackets of forces within a step, and of openings, which change accelerations continuously.
constexpr double found_share = 1e-13;
constexpr int most_bisections = 100;
constexpr double opening_width = 1e-10;

}  // namespace

double ReleaseSearch::hold_at(const State& state, const Holds& holds, ClosedContacts& closed) {
  closed.accelerate(state, accelerations_);
  return holds.smallest(closed);
}

std::optional<double> ReleaseSearch::first_release(const DenseStep& motion,
                                                   double until,
                                                   const State& next,
                                                   const Holds& holds,
                                                   ClosedContacts& closed) {
  State state = next;
  const auto force_at = [&](double share) {
    look_at(motion, share, state);
    return hold_at(state, holds, closed);
  };
  double low = 0.0;
  double high = 0.0;
  double at_low = force_at(0.0);
  double at_high = at_low;
  if (at_low <= 0.0) return 0.0;
  for (int k = 1; k <= force_samples; ++k) {
    high = until * k / force_samples;
    at_high = force_at(high);
    if (at_high < 0.0) break;
    low = high;
    at_low = at_high;
  }
  if (at_high >= 0.0) {
    // The polynomial may miss by rounding what the state at the end shows.
    if (until == 1.0 && hold_at(next, holds, closed) < 0.0) return 1.0;
    return {};
  }
  // False position with the bracket halved where that is slow.
  for (int k = 0; high - low > found_share && k < most_bisections; ++k) {
    double at = low + (high - low) * (k % 3 == 2 ? 0.5 : at_low / (at_low - at_high));
    at = std::clamp(at, low + 0.1 * found_share, high - 0.1 * found_share);
    const double force = force_at(at);
    (force < 0.0 ? high : low) = at;
    (force < 0.0 ? at_high : at_low) = force;
  }
  return high;
}

std::optional<double> ReleaseSearch::first_opening(const DenseStep& motion,
                                                   double until,
                                                   const State& next,
                                                   double gravity,
                                                   ClosedContacts& closed,
                                                   Bookkeeping& book) {
  State state = next;
  const auto opens_at = [&](double share) {
    look_at(motion, share, state);
    return opening_.opens(state, closed, opening_share * gravity, book);
  };
  if (!opens_at(until)) return {};
  double low = 0.0;
  double high = until;
  while (high - low > opening_width) {
    const double at = 0.5 * (low + high);
    (opens_at(at) ? high : low) = at;
  }
  return high;
}

}  // namespace wuerfel
