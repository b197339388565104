/// When do bodies meet, sides become flush, corners leave a side? The event functions of a smooth
/// phase that geometry gives, and the first of their zeros.
#pragma once

#include <optional>
#include <vector>

#include "core/time/events/step_view.h"

namespace wuerfel {

class GeometricEvents {
 public:
  explicit GeometricEvents(const System& system);

  /// A smooth phase begins at a state, with contacts that stay closed and cubes that rest.
  void begin(const State& state, const ContactSet& closed, const std::vector<char>& resting);
  /// The first function that vanishes within a step, and at which share; the boxes that are near
  /// enough are looked for here.
  struct First {
    double share = 1.0;
    EventFunction function;
  };
  /// Whether there is anybody to be met: a body that is alone in the world, as a pendulum, meets nobody.
  [[nodiscard]] bool watches() const;

  struct Search {
    std::optional<First> first;
    int given_up = 0;  ///< functions of which a zero could not be excluded
  };
  [[nodiscard]] Search first(const DenseStep& motion,
                             double length,
                             const std::vector<TwistRange>& range);
  /// The motion has come to `state` without an event.
  void passed(const State& state);

 private:
  void watch_closed(const ContactSet& closed);
  void watch_planes(const ContactSet& closed);
  void watch_touching(const State& state);
  void find_candidates();
  void search(const EventFunction& f, Search& result) const;
  [[nodiscard]] double zero(const EventFunction& f) const;

  const System* system_;
  StepView view_;
  std::vector<EventFunction> functions_;   ///< of the phase
  std::vector<EventFunction> touching_;    ///< separations that start at zero
  std::vector<IndexPair> closed_pairs_;    ///< sorted
  std::vector<EventFunction> candidates_;  ///< separations of this step
  Neighbours neighbours_;
  double rounding_ = 0.0;  ///< m, what rounding of the positions leaves of gaps
};

}  // namespace wuerfel
