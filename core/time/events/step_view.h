/// A step of all bodies as the search for events sees it: watched functions at its moments, and
/// whether they stay positive between two of them.
#pragma once

#include <vector>

#include "core/time/events/gap_bounds.h"
#include "core/time/events/motion_piece.h"

namespace wuerfel {

struct WatchedStep {
  const DenseStep* motion = nullptr;
  double length = 0.0;                             ///< s
  const std::vector<TwistRange>* range = nullptr;  ///< one per cube
};

class StepView {
 public:
  explicit StepView(const System& system) : system_(&system) {}

  /// Cubes that rest, one entry per cube; or none.
  void set_resting(const std::vector<char>& resting) { resting_ = resting; }
  void set(const WatchedStep& step);

  [[nodiscard]] bool is_still(int body) const;
  /// A body at a state. A plane is a box without extent, whose side `plane_side` faces out.
  [[nodiscard]] MovingBox body_of(const State& state, int body) const;
  static constexpr int plane_side = 2;
  /// A watched function at a share of the step.
  [[nodiscard]] Look look_at(const Watch& watch, double share) const;
  /// Bounds between two looks, in units of the step, for sides of `from`; `swapped`: of `on`.
  [[nodiscard]] GapBounds bounds_of(const Watch& watch,
                                    const Look& a,
                                    const Look& b,
                                    bool swapped) const;
  /// A reading with its shift, in units of the step.
  [[nodiscard]] Reading in_steps(const Reading& reading, double shift) const;
  /// Whether a watched function, with `shift` added, has no zero between two looks.
  [[nodiscard]] bool stays_positive(const Watch& watch,
                                    const Look& a,
                                    const Look& b,
                                    double shift) const;

 private:
  [[nodiscard]] MovingBox body_at(int body, double share) const;
  [[nodiscard]] bool side_stays_clear(
      const Watch& watch, const Look& a, const Look& b, int pair_side, double shift) const;

  const System* system_;
  WatchedStep step_;
  std::vector<char> resting_;
  std::vector<MovingBox> begin_;  ///< at the ends of the step, one per body
  std::vector<MovingBox> end_;
};

}  // namespace wuerfel
