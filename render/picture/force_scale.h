/// How long arrows are: one scale for a whole run, so that lengths can be compared from frame to
/// frame.
#pragma once

#include <array>
#include <cstdint>

#include "core/snapshot.h"

namespace wuerfel {

/// The largest of 1, 2, 5, 10, 20, 50 ... (and 0.5, 0.2 ...) that is not above `value` > 0.
double round_down_125(double value);

/// m, that a body is about as large as: the geometric mean of its sides, of a thin one a quarter of the longer one.
double typical_side_of(const SnapshotBox& box);

struct ForceScale {
  double metres_per_newton = 0.0;  ///< 0: no arrows
  double longest = 1e300;          ///< m; a longer arrow is cut there and marked as broken
  double hidden_below = 0.0;       ///< N; smaller forces are dots

  /// Whether an arrow is shorter than its force asks for. A millionth is rounding: arrows of equal
  /// forces look alike.
  [[nodiscard]] bool cuts(double newton) const {
    return newton * metres_per_newton > longest * (1.0 + 1e-6);
  }
};

/// Where the arrow of a joint lies: it comes from inside the body that pushes and ends where it
/// pushes. It stays inside that body.
struct JointArrow {
  Vec2 tail = Vec2::Zero();  ///< m
  Vec2 tip = Vec2::Zero();   ///< m
  bool cut = false;          ///< the force is larger than the arrow says

  [[nodiscard]] double length() const { return (tip - tail).norm(); }
};
JointArrow joint_arrow(const Snapshot& snapshot,
                       const SnapshotJoint& joint,
                       const ForceScale& scale);

/// What a run's forces look like, in constant memory: a histogram of their magnitudes over octaves.
class ForceRange {
 public:
  void include(const Snapshot& snapshot);
  void include(double magnitude);  ///< N
  double ordinary() const;         ///< N, that at most a twentieth of all forces exceeds
  double largest() const { return largest_; }    ///< N
  double smallest() const { return smallest_; }  ///< N, greater than 0; 0 where there was none
  /// Whether any of the forces is longer than its arrow.
  bool cuts(const ForceScale& scale) const;
  double typical_side()
      const;  ///< m, mean over the cubes seen (geometric mean of width and height)

  /// The scale at which the largest force is 0.8 typical sides long, but a typical weight at least
  /// 0.15 and at most 0.5. What is longer than 0.8 sides is cut. The largest twentieth of all forces
  /// does not count: a few peaks must not make all others small.
  ForceScale scale() const;

 private:
  static constexpr int bins_per_octave = 8;
  static constexpr int octaves = 400;
  std::array<std::uint64_t, static_cast<std::size_t>(bins_per_octave* octaves)> histogram_{};
  std::uint64_t count_ = 0;
  double largest_ = 0.0;
  double smallest_ = 0.0;
  double steepest_ = 0.0;  ///< N/m, of force over the room for its arrow
  double side_sum_ = 0.0;
  std::uint64_t side_count_ = 0;
  double weight_ = 0.0;  ///< N, the median of m g over the cubes
};

/// The scale for the option --force-scale: `metres_per_newton` given, cut at six typical sides.
ForceScale fixed_force_scale(double metres_per_newton, const ForceRange& range);

}  // namespace wuerfel
