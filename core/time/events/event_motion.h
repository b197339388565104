/// Motion from event to event: smooth phases integrated with error control, events located on true
/// states to the integrator's accuracy.
#pragma once

#include <deque>
#include <limits>

#include "core/dynamics/closed_contacts.h"
#include "core/time/events/contact_law.h"
#include "core/time/events/event_search.h"
#include "core/time/events/motion_piece.h"
#include "core/time/events/release_search.h"

namespace wuerfel {

class EventMotion final : private VectorField {
 public:
  EventMotion(const System& system, const MotionSettings& settings);

  /// The motion goes on from `state` at time t; impacts that are due happen at once. `resting`:
  /// cubes known to be at rest.
  void start(const State& state,
             double t,
             const ContactLimits& limits,
             std::vector<char> resting,
             Bookkeeping& book);

  /// Time up to which the motion is known; infinite where all is at rest.
  [[nodiscard]] double clock() const { return clock_; }
  /// One step: at most to `limit`, or to the first event, which happens then. Its piece is added.
  void advance(double limit, std::deque<MotionPiece>& pieces, Bookkeeping& book);
  /// Events since the start.
  [[nodiscard]] long events() const { return events_; }

  /// State at the clock.
  [[nodiscard]] const State& state() const { return state_; }
  /// State of a smooth piece at time t, on its constraints.
  [[nodiscard]] State look(const MotionPiece& piece, double t);
  /// Certified rest, per cube, at the clock.
  [[nodiscard]] const std::vector<char>& resting() const { return closure_.resting; }
  [[nodiscard]] bool at_rest() const;
  [[nodiscard]] bool wedged() const { return closure_.wedged; }

 private:
  void operator()(const std::vector<double>& y, std::vector<double>& rate) override;
  void begin_phase(const ContactLimits& limits, Bookkeeping& book);
  void fall(double limit, std::deque<MotionPiece>& pieces, Bookkeeping& book);
  double fall_to(const Crossing& crossing, double h);
  void integrate(double limit, std::deque<MotionPiece>& pieces, Bookkeeping& book);
  void note_given_up(Bookkeeping& book);
  double controlled_step(double h, Bookkeeping& book);
  void complete_step(double h);
  void restep(double length);
  double reach_crossing(const Crossing& crossing, double h);
  double reach_release(double length);
  [[nodiscard]] State moved(State state, double time) const;
  void add_piece(std::deque<MotionPiece>& pieces) const;
  void finish(double elapsed, bool event, Bookkeeping& book);

  const System* system_;
  MotionSettings settings_;
  ContactLaw law_;
  ClosedContacts closed_;
  ClosedContacts looker_;  ///< for looks between steps
  EventSearch search_;
  Dop853 method_;
  ReleaseSearch releases_;
  Scales scales_;
  Closure closure_;

  double clock_ = 0.0;
  State state_;               ///< at the clock
  std::vector<double> y_;     ///< the same, packed
  std::vector<double> rate_;  ///< its rate
  std::vector<double> scale_;
  Holds holds_;

  State next_;  ///< at the end of the step that is being taken
  std::vector<double> next_y_;
  std::vector<double> next_rate_;
  Holds next_holds_;
  std::vector<TwistRange> range_;
  DenseStep dense_;
  double length_ = 0.0;  ///< s, of that step

  State scratch_;
  std::vector<Twist> accelerations_;
  double step_ = 0.0;  ///< s, proposed length of the next step
  double fall_ = 0.0;  ///< s, of the next free fall
  double pull_ = 0.0;  ///< smallest hold since it was reset
  long events_ = 0;
  long given_up_ = 0;       ///< searches
  int instant_events_ = 0;  ///< in a row, without time passing
};

}  // namespace wuerfel
