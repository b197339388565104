/// When does something happen? The functions of a motion whose zeros are geometric events, and the
/// search for the first of them within a step.
#pragma once

#include <optional>
#include <vector>

#include "core/time/events/step_view.h"

namespace wuerfel {

struct Crossing {
  double share = 1.0;  ///< of the step
  Watch watch;
};

/// Searches with a bound: an interval without a zero is left when the function's values and rates
/// at its ends and the bound of its second derivative exclude one. Nothing is sampled and hoped
/// for.
class EventSearch {
 public:
  explicit EventSearch(const System& system);

  /// A smooth phase begins: what is closed, and from where the other functions start. What starts
  /// at zero is watched from where it has left it.
  void begin(const State& state,
             const std::vector<Contact>& closed,
             const std::vector<char>& resting);
  /// The first zero within the step; the boxes that are near enough are looked for here.
  std::optional<Crossing> first(const WatchedStep& step);
  /// The step has been taken as far as `state`: functions that have left zero are watched from now
  /// on without a shift.
  void passed(const State& state);
  /// A watched function at a state.
  [[nodiscard]] Reading read(const State& state, const Watch& watch) const;
  /// Searches that ended without an answer.
  [[nodiscard]] long given_up() const { return given_up_; }

 private:
  void watch_closed(const std::vector<Contact>& closed);
  void watch_planes(const std::vector<Contact>& closed);
  void find_candidates(const WatchedStep& step);
  [[nodiscard]] double zero(const Watch& watch) const;
  [[nodiscard]] bool only_falls(const Watch& watch, const Look& a, const Look& b) const;
  [[nodiscard]] double next_share(
      const Look& a, const Look& b, double shift, bool falls, int count) const;
  void search(Watch& watch, std::optional<Crossing>& first);

  const System* system_;
  StepView view_;
  std::vector<Watch> watches_;               ///< of the phase
  std::vector<Watch> unarmed_;               ///< separations that start at zero
  std::vector<IndexPair> closed_pairs_;      ///< sorted
  std::vector<Watch> candidates_;            ///< separations of this step
  std::vector<std::pair<Look, Look>> open_;  ///< parts of the step that are still to be searched
  std::vector<BoundingBox> bounds_;
  BroadPhase broad_phase_;
  double rounding_ = 0.0;  ///< m, what rounding of the positions leaves of gaps
  long given_up_ = 0;
};

}  // namespace wuerfel
