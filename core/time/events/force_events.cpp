#include "core/time/events/force_events.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// A gap's acceleration beyond this share of g is an opening.
constexpr double opening_share = 1e-8;
/// Rates of loads are differences over this share of a step.
constexpr double difference_share = 1e-4;
/// Derivatives of loads come from a cubic; their bounds are this many times what it says.
constexpr double cubic_reserve = 2.0;
/// A load that was seen negative within a step is looked for at least this closely.
constexpr double closest_look = 0.125;

/// Loads along a step. Looks at its ends are remembered, for all loads need them.
class LoadsInStep {
 public:
  explicit LoadsInStep(SmoothPhase& phase) : phase_(phase), state_(phase.state()) {}

  struct Loads {
    std::vector<double> value;
    std::vector<double> rate;  ///< per step
  };
  Loads at(double share) {
    Loads loads;
    const double ahead = share < 0.5 ? difference_share : -difference_share;
    find(share + ahead, loads.rate);
    find(share, loads.value);
    for (std::size_t k = 0; k < loads.value.size(); ++k)
      loads.rate[k] = (loads.rate[k] - loads.value[k]) / ahead;
    return loads;
  }
  const Loads& at_begin() {
    if (begin_.value.empty()) begin_ = at(0.0);
    return begin_;
  }
  const Loads& at_end() {
    if (!end_.value.empty()) return end_;
    end_ = at(1.0);
    // The polynomial may miss by rounding what the state at the end shows.
    end_.value = phase_.last().loads;
    return end_;
  }

 private:
  void find(double share, std::vector<double>& loads) {
    look_at(phase_.last().motion, share, state_);
    phase_.loads_at(state_, loads);
  }

  SmoothPhase& phase_;
  State state_;
  Loads begin_;
  Loads end_;
};

/// One load, as first_zero takes it.
struct LoadInStep {
  using Look = Sample;
  static constexpr double resolution = found_share;
  LoadsInStep& loads;
  int number;
  bool seen_negative;

  [[nodiscard]] Sample at(double share) const {
    if (share == 0.0) return sample(share, loads.at_begin());
    if (share == 1.0) return sample(share, loads.at_end());
    return sample(share, loads.at(share));
  }
  [[nodiscard]] Sample sample(double share, const LoadsInStep::Loads& found) const {
    return {share, {found.value[number], found.rate[number], 0.0}};
  }
  /// Second derivatives at both ends of the cubic through them.
  [[nodiscard]] static std::pair<double, double> bending(const Sample& a, const Sample& b) {
    const double w = b.share - a.share;
    const double slope = (b.jet.value - a.jet.value) / w;
    return {(6.0 * slope - 4.0 * a.jet.first - 2.0 * b.jet.first) / w,
            (2.0 * a.jet.first + 4.0 * b.jet.first - 6.0 * slope) / w};
  }
  [[nodiscard]] double second_bound(const Sample& a, const Sample& b) const {
    const auto [from, to] = bending(a, b);
    return cubic_reserve * std::max(std::abs(from), std::abs(to));
  }
  [[nodiscard]] bool positive_between(const Sample& a, const Sample& b, double shift) const {
    const double w = b.share - a.share;
    if (seen_negative && w > closest_look) return false;
    const auto [from, to] = bending(a, b);
    const Jet start{a.jet.value + shift, a.jet.first, from};
    const Jet end{b.jet.value + shift, b.jet.first, to};
    return no_zero_between(start, end, w,
                           {second_bound(a, b), cubic_reserve * std::abs(to - from) / w});
  }
};

/// Whether redundant contacts stay closed, as first_zero takes it: 1 or -1.
struct ClosedInStep {
  using Look = Sample;
  static constexpr double resolution = 1e-10;
  SmoothPhase& phase;
  double most;  ///< m/s^2, of a gap that does not open
  Workspace& work;

  [[nodiscard]] Sample at(double share) const {
    // At the beginning the modes have just been found.
    if (share == 0.0) return {share, {1.0, 0.0, 0.0}};
    State state = phase.state();
    look_at(phase.last().motion, share, state);
    phase.project(state);
    const bool opens = phase.equations().rubs()
                           ? would_let_go(state, phase.closed(), most, work)
                           : would_open(state, phase.equations().touches(), most, work);
    return {share, {opens ? -1.0 : 1.0, 0.0, 0.0}};
  }
  [[nodiscard]] static bool positive_between(const Sample& a, const Sample& b, double /*shift*/) {
    return a.jet.value > 0.0 && b.jet.value > 0.0;
  }
  [[nodiscard]] static double second_bound(const Sample& /*a*/, const Sample& /*b*/) { return 0.0; }
};

}  // namespace

void ForceEvents::begin(const SmoothPhase& phase, double share) {
  loads_.clear();
  first_slip_ = phase.equations().first_slip(phase.loads());
  const Scales& scales = phase.scales();
  for (const double load : phase.loads()) {
    const bool is_force = static_cast<int>(loads_.size()) < first_slip_;
    loads_.push_back(Arming::at_start(load, share * (is_force ? scales.weight : scales.speed)));
  }
}

void ForceEvents::passed(const std::vector<double>& loads) {
  for (std::size_t k = 0; k < loads_.size(); ++k)
    loads_[k].pass(loads[k]);
}

/// Of the loads from number `from` on.
std::optional<ForceEvents::First> ForceEvents::first_release(SmoothPhase& phase,
                                                             int from,
                                                             double until) const {
  std::optional<First> result;
  LoadsInStep loads(phase);
  const std::vector<BorneRange>& ranges = phase.last().load_range;
  for (int k = from; k < static_cast<int>(loads_.size()); ++k) {
    const double least = ranges[k].low + loads_[k].shift;
    // What is further from zero than its range over all evaluations has no zero between them.
    if (least > ranges[k].high - ranges[k].low) continue;
    LoadInStep load{loads, k, least < 0.0};
    const FirstZero found = first_zero(load, result ? result->share : until, loads_[k]);
    if (found.share) result = {*found.share, k, found.arming};
  }
  return result;
}

std::optional<ForceEvents::First> ForceEvents::first_opening(SmoothPhase& phase,
                                                             double until,
                                                             double gravity,
                                                             Workspace& work) const {
  const std::vector<BorneRange>& ranges = phase.last().load_range;
  const auto is_negative = [&](int k) { return ranges[k].low + loads_[k].shift < 0.0; };
  bool negative = false;
  for (int k = 0; k < first_slip_; ++k)
    negative = negative || is_negative(k);
  if (!negative) return {};
  ClosedInStep closed{phase, opening_share * gravity, work};
  // cppcheck-suppress danglingTemporaryLifetime ; the product is kept as a value
  const FirstZero found = first_zero(closed, until, Arming{});
  if (!found.share) return {};
  return First{*found.share, {}, {}};
}

std::optional<ForceEvents::First> ForceEvents::first(SmoothPhase& phase,
                                                     double until,
                                                     double gravity,
                                                     Workspace& work) const {
  if (loads_.empty()) return {};
  if (!phase.redundant()) return first_release(phase, 0, until);
  const std::optional<First> slip = first_release(phase, first_slip_, until);
  const std::optional<First> opening =
      first_opening(phase, slip ? slip->share : until, gravity, work);
  return opening ? opening : slip;
}

}  // namespace wuerfel
