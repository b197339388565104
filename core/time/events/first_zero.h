/// The first zero of a function within a step: one search for gaps, ends of sides, and forces.
/// An interval is left only where values and derivatives at its ends and bounds between them
/// exclude a zero, so that a dip between two looks is not missed; in the spirit of interval Newton
/// methods [Hansen, Walster 2004].
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/constraints/side.h"

namespace wuerfel {

/// Bounds of the absolute values of the second and the third derivative.
struct DerivativeBounds {
  double second = 0.0;
  double third = 0.0;
};

/// Whether a function that is positive at both ends of an interval of length `width` has no zero
/// between them, by its values and derivatives there and the bounds within. All are in the
/// interval's own unit.
bool no_zero_between(const Jet& a, const Jet& b, double width, const DerivativeBounds& bounds);

/// A function that starts at zero is searched with a small addition until it has left zero: what
/// has just happened is not what happens next.
struct Arming {
  double zero = 0.0;   ///< up to this much counts as zero, in the function's unit
  double shift = 0.0;  ///< to be added

  static Arming at_start(double value, double zero);
  [[nodiscard]] bool has_left_zero(double value) const;
  /// The function has come to `value`.
  void pass(double value) {
    if (has_left_zero(value)) shift = 0.0;
  }
};

struct FirstZero {
  std::optional<double> share;  ///< of the step: where the function is no longer positive
  Arming arming;                ///< as it is there
  bool given_up = false;        ///< the search ended without a proof
};

/// What the search remembers of a look at a function.
struct Sample {
  double share = 0.0;  ///< of the step
  Jet jet;             ///< in units of the step, without the addition
};

/// Where to look next between `a` and `b`: where the function only falls Newton's steps from both
/// ends close the bracket, with a quarter of `resolution` to be on the other side; bisection goes
/// on wherever they do not help. `count`: looks so far.
double next_share(
    const Sample& a, const Sample& b, double shift, bool falls, int count, double resolution);

/// Width of the bracket that a search leaves to Newton's method on true states.
inline constexpr double found_share = 1e-13;
/// Shares closer than this are one moment.
inline constexpr double same_share = 1e-14;
inline constexpr int most_intervals = 4000;

/// The first zero of `f` between the shares 0 and `end` of a step. `f` has a type `Look` derived
/// from Sample, and
///   at(share)                        a look
///   positive_between(a, b, shift)    a proof that f + shift is positive between two looks
///   second_bound(a, b)               a bound of the second derivative there, in units of the step
///   resolution                       width of the bracket that is left to others to polish
template <typename Function>
FirstZero first_zero(Function& f, double end, const Arming& start) {
  using Look = typename Function::Look;
  FirstZero result{{}, start, false};
  double& shift = result.arming.shift;
  std::vector<std::pair<Look, Look>> later;
  Look a = f.at(0.0);
  Look b = f.at(end);
  for (int count = 0;; ++count) {
    result.arming.pass(a.jet.value);
    const double width = b.share - a.share;
    const bool crossed = b.jet.value + shift <= 0.0;
    if (crossed && (width <= Function::resolution || count > most_intervals)) {
      result.share = b.share;
      result.given_up = width > Function::resolution;
      return result;
    }
    const bool cleared = !crossed && f.positive_between(a, b, shift);
    if (cleared || width <= same_share) {  // the latter: it grazes zero
      if (later.empty()) return result;
      std::tie(a, b) = later.back();
      later.pop_back();
      continue;
    }
    if (count > most_intervals) {
      result.given_up = true;
      return result;
    }
    const bool falls = crossed && a.jet.first < 0.0 && b.jet.first < 0.0
                       && std::min(-a.jet.first, -b.jet.first) > f.second_bound(a, b) * width;
    Look middle = f.at(next_share(a, b, shift, falls, count, Function::resolution));
    const bool left = middle.jet.value + shift <= 0.0;
    // What only falls by one side may have been over by another before.
    if (!left && falls && f.positive_between(a, middle, shift)) {
      a = std::move(middle);
      continue;
    }
    if (!left) later.emplace_back(middle, std::move(b));
    b = std::move(middle);
  }
}

}  // namespace wuerfel
