/// A step of all bodies as the search for events sees it: event functions at its moments, and
/// whether they stay positive between two of them.
#pragma once

#include <vector>

#include "core/time/events/event_function.h"
#include "core/time/events/motion_piece.h"

namespace wuerfel {

class StepView {
 public:
  /// An event function at one moment of a step.
  struct Look : Sample {
    MovingPair pair;
    PairSide side;  ///< that separates the pair; of separations
  };

  explicit StepView(const System& system) : system_(&system) {}

  /// A phase begins in which these cubes, one entry per cube, rest. `rounding` (m) is what rounding
  /// of the positions leaves of gaps: separations that are less than twice that count as zero, or
  /// rounding would say when a body arrives that slides at the height of another one's side.
  void begin(const std::vector<char>& resting, double rounding);
  /// A step of `length` s; `range`: accelerations within it, one per cube. Both must outlive what
  /// is asked about it.
  void set(const DenseStep& motion, double length, const std::vector<TwistRange>& range);

  /// Whether a body neither moves nor will within the phase.
  [[nodiscard]] bool is_still(int body) const;
  [[nodiscard]] Look look_at(const EventFunction& f, double share) const;
  /// Bound of the second derivative between two looks, in units of the step.
  [[nodiscard]] double second_bound(const EventFunction& f, const Look& a, const Look& b) const;
  /// Whether f + shift has no zero between two looks.
  [[nodiscard]] bool positive_between(const EventFunction& f,
                                      const Look& a,
                                      const Look& b,
                                      double shift) const;
  /// Centre of a box at a share of the step.
  [[nodiscard]] Vec2 center_at(int body, double share) const;
  /// Farthest that a cube's way leaves its chord, along both axes, m.
  [[nodiscard]] Vec2 bulge(int cube) const;

 private:
  [[nodiscard]] MovingBox body_at(int body, double share) const;
  [[nodiscard]] DerivativeBounds bounds(const EventFunction& f,
                                        const Look& a,
                                        const Look& b,
                                        bool side_of_on) const;
  [[nodiscard]] bool side_stays_clear(const EventFunction& f,
                                      const Look& a,
                                      const Look& b,
                                      const PairSide& side,
                                      double shift) const;
  [[nodiscard]] Jet in_steps(const Jet& jet, double shift) const;

  const System* system_;
  const DenseStep* motion_ = nullptr;
  const std::vector<TwistRange>* range_ = nullptr;
  double length_ = 0.0;  ///< s
  std::vector<char> resting_;
  double separated_ = 0.0;        ///< m, from which on a separation is positive
  std::vector<MovingBox> begin_;  ///< at the ends of the step, one per body
  std::vector<MovingBox> end_;
};

/// An event function within a step, as first_zero takes it.
struct FunctionInStep {
  using Look = StepView::Look;
  static constexpr double resolution = found_share;
  const StepView& view;
  const EventFunction& f;

  [[nodiscard]] Look at(double share) const { return view.look_at(f, share); }
  [[nodiscard]] bool positive_between(const Look& a, const Look& b, double shift) const {
    return view.positive_between(f, a, b, shift);
  }
  [[nodiscard]] double second_bound(const Look& a, const Look& b) const {
    return view.second_bound(f, a, b);
  }
};

/// A body as a state says, without accelerations.
MovingBox body_of(const System& system, const State& state, int body);
/// An event function at a state, value and rate, without its addition.
Jet value_at(const System& system, const State& state, const EventFunction& f);

}  // namespace wuerfel
