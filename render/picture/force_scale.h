/// How long arrows are: one scale for a whole run, so that lengths can be compared from frame to
/// frame.
#pragma once

#include <array>
#include <cstdint>

#include "core/snapshot.h"

namespace wuerfel {

/// The largest of 1, 2, 5, 10, 20, 50 ... (and 0.5, 0.2 ...) that is not above `value` > 0.
double round_down_125(double value);

struct ForceScale {
  double metres_per_newton = 0.0;  ///< 0: no arrows
  double longest = 1e300;          ///< m; a longer arrow is cut there and marked with a second head
  double hidden_below = 0.0;       ///< N; smaller forces are not drawn
};

/// What a run's forces look like, in constant memory: a histogram of their magnitudes over octaves.
class ForceRange {
 public:
  void include(const Snapshot& snapshot);
  double largest() const { return largest_; }  ///< N
  double typical_side()
      const;  ///< m, mean over the cubes seen (geometric mean of width and height)

  /// The scale at which the largest force is 1.5 typical sides long; where a few peaks (the last
  /// hundredth of all arrows) tower above the rest, those are cut at 2.5 sides instead.
  ForceScale scale() const;

 private:
  static constexpr int bins_per_octave = 8;
  static constexpr int octaves = 400;
  std::array<std::uint64_t, static_cast<std::size_t>(bins_per_octave* octaves)> histogram_{};
  std::uint64_t count_ = 0;
  double largest_ = 0.0;
  double side_sum_ = 0.0;
  std::uint64_t side_count_ = 0;
};

/// The scale for the option --force-scale: `metres_per_newton` given, cut at six typical sides.
ForceScale fixed_force_scale(double metres_per_newton, const ForceRange& range);

}  // namespace wuerfel
