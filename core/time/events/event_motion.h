/// Motion from event to event: smooth phases integrated with error control, events located on true
/// states to the integrator's accuracy.
#pragma once

#include <deque>
#include <variant>

#include "core/time/events/bounce_series.h"
#include "core/time/events/force_events.h"
#include "core/time/events/geometric_events.h"
#include "core/time/events/instant.h"

namespace wuerfel {

class EventMotion {
 public:
  EventMotion(const System& system, const MotionSettings& settings);

  /// The motion goes on from `state` at time t; impacts that are due happen at once. `resting`: cubes known to be at rest.
  /// False, and nothing is booked, where that would leave overlap: the motion has to go on otherwise.
  bool start(const State& state,
             double t,
             const ContactLimits& limits,
             std::vector<char> resting,
             Bookkeeping& book);

  /// Whether a start there would find everything at rest: much cheaper than to begin a phase of many cubes.
  [[nodiscard]] bool would_rest(const State& state, const ContactLimits& limits);

  /// Time up to which the motion is known; infinite where all is at rest.
  [[nodiscard]] double clock() const { return clock_; }
  /// One step: at most to `limit`, or to the first event, which happens then. Its piece is added.
  void advance(double limit, std::deque<MotionPiece>& pieces, Bookkeeping& book);
  /// Events since the start, but for those of bounces that are known to end.
  [[nodiscard]] long events() const { return events_; }

  /// State at the clock.
  [[nodiscard]] const State& state() const { return phase_.state(); }
  /// State of a smooth piece at time t, on its constraints.
  [[nodiscard]] State look(const MotionPiece& piece, double t);
  /// Deepest overlap at the clock, as a share of the smaller side of the pair.
  [[nodiscard]] double overlap();
  /// Certified rest, per cube, at the clock.
  [[nodiscard]] const std::vector<char>& resting() const { return modes_.resting; }
  [[nodiscard]] bool at_rest() const;
  [[nodiscard]] bool wedged() const { return modes_.wedged; }
  /// Whether forces of closed contacts are not the only ones: what becomes of them takes programs to know.
  [[nodiscard]] bool redundant() const { return phase_.redundant(); }
  /// At the clock, while the phase lasts.
  [[nodiscard]] Twist acceleration(int cube) const { return phase_.acceleration(cube); }
  /// Blows, at the clock, to bodies that only stand (Instant::blows). They have not been taken: whether what is struck stands all
  /// the same others know.
  [[nodiscard]] const std::map<int, Push>& blows() const { return struck_.blows; }
  /// Takes them as if to fixed bodies.
  void take_blows(Bookkeeping& book);

 private:
  using FirstEvent = std::variant<GeometricEvents::First, ForceEvents::First>;

  void begin_phase(const State& state, Instant now, Bookkeeping& book);
  void close(const State& state);
  [[nodiscard]] bool breaks_law();
  void take(const State& state, Instant now, Bookkeeping& book);
  void rest_for_ever(std::deque<MotionPiece>& pieces);
  void note_step(const SmoothStep& step, Bookkeeping& book);
  void note_momenta(const SmoothStep& step, Bookkeeping& book) const;
  std::optional<FirstEvent> first_event(const SmoothStep& step, Bookkeeping& book);
  void reach(const FirstEvent& event);
  [[nodiscard]] Jet value_at_end(const FirstEvent& event);
  [[nodiscard]] MotionPiece last_piece() const;
  [[nodiscard]] FormerPhase ended_phase() const;

  const System* system_;
  double tolerance_;  ///< of a step
  Workspace work_;
  SmoothPhase phase_;
  GeometricEvents geometry_;
  ForceEvents forces_;
  ContactModes modes_;
  ClosedContacts looker_;  ///< for looks between steps
  double clock_ = 0.0;
  Instant struck_;  ///< where there are blows
  BounceSeries series_;
  long events_ = 0;
  int instant_events_ = 0;  ///< in a row, without time passing
};

}  // namespace wuerfel
