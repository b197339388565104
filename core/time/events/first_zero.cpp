#include "core/time/events/first_zero.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// A function has left zero where it is this many times what counts as zero.
constexpr double left_zero_times = 3.0;
/// Second derivatives come from a polynomial: this share of their bound is left to its error.
constexpr double second_error = 1e-6;

/// How much the function may bend downwards at most.
double downwards(const Jet& a, const Jet& b, double width, const DerivativeBounds& bounds) {
  const double least =
      std::min(0.5 * (a.second + b.second - bounds.third * width), std::min(a.second, b.second));
  return std::clamp(-least, 0.0, bounds.second) + second_error * bounds.second;
}

/// Time up to which a function that bends downwards by at most `bend` stays positive.
double positive_for(double value, double rate, double bend) {
  const double root = std::sqrt(rate * rate + 2.0 * bend * value);
  return rate < 0.0 ? 2.0 * value / (root - rate) : (rate + root) / bend;
}

}  // namespace

// The first zero that is possible after the one end must lie beyond the last that is possible
// before the other.
bool no_zero_between(const Jet& a, const Jet& b, double width, const DerivativeBounds& bounds) {
  if (a.value <= 0.0 || b.value <= 0.0) return false;
  // Below its chord a function stays by no more than this.
  if (std::min(a.value, b.value) > 0.125 * bounds.second * width * width) return true;
  const double bend = std::max(downwards(a, b, width, bounds), 1e-300);
  return positive_for(a.value, a.first, bend) + positive_for(b.value, -b.first, bend) >= width;
}

bool Arming::has_left_zero(double value) const { return value > left_zero_times * zero; }

Arming Arming::at_start(double value, double zero) {
  Arming arming{zero, 0.0};
  if (!arming.has_left_zero(value)) arming.shift = zero + std::max(0.0, -value);
  return arming;
}

double next_share(
    const Sample& a, const Sample& b, double shift, bool falls, int count, double resolution) {
  const double middle = 0.5 * (a.share + b.share);
  if (!falls || count % 4 == 3) return middle;
  const bool from_end = count % 2 == 0;
  const Sample& start = from_end ? b : a;
  const double beyond = (from_end ? -0.25 : 0.25) * resolution;
  const double at = start.share - (start.jet.value + shift) / start.jet.first + beyond;
  return at > a.share && at < b.share ? at : middle;
}

}  // namespace wuerfel
