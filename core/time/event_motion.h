/// Motion from event to event: smooth phases integrated with error control, events located on true
/// states to the integrator's accuracy.
#pragma once

#include <deque>
#include <limits>

#include "core/dynamics/closed_contacts.h"
#include "core/time/contact_law.h"
#include "core/time/event_search.h"

namespace wuerfel {

/// One smooth step, to be looked at anywhere within.
struct MotionPiece {
  double begin = 0.0;   ///< s
  double length = 0.0;  ///< s; infinite where nothing moves
  State start;
  DenseStep motion;             ///< no coefficients where nothing moves
  std::vector<Contact> closed;  ///< contacts that stay closed
};

class EventMotion final : private VectorField {
 public:
  EventMotion(const System& system, const MotionSettings& settings);

  /// The motion goes on from `state` at time t. What overlaps or gapes by `touching` of the smaller
  /// side touches; impacts that are due happen at once. `resting`: cubes known to be at rest.
  void start(
      const State& state, double t, double touching, std::vector<char> resting, Bookkeeping& book);

  /// Time up to which the motion is known; infinite where all is at rest.
  [[nodiscard]] double clock() const { return clock_; }
  /// One step: at most to `limit`, or to the first event, which happens then.
  void advance(double limit, Bookkeeping& book);
  /// Events since the start.
  [[nodiscard]] long events() const { return events_; }

  /// State at a time between the first piece that is kept and the clock; just after events.
  [[nodiscard]] State at(double t);
  /// Certified rest, per cube, at the clock.
  [[nodiscard]] const std::vector<char>& resting() const { return closure_.resting; }
  [[nodiscard]] bool at_rest() const;
  /// Pieces that end before t are not needed any more.
  void forget_before(double t);
  [[nodiscard]] const std::deque<MotionPiece>& pieces() const { return pieces_; }

 private:
  /// Rows of a flush pair, or one row (second = -1), with what is added to the force until it has
  /// left zero.
  struct Hold {
    int first = 0;
    int second = -1;
    std::array<double, 2> offset{};
  };

  void operator()(const std::vector<double>& y, std::vector<double>& rate) override;
  void begin_phase(double touching, Bookkeeping& book);
  void find_holds();
  [[nodiscard]] std::array<double, 2> hold_forces(const Hold& hold) const;
  [[nodiscard]] double smallest(const std::vector<Hold>& holds) const;
  [[nodiscard]] double hold_at(const State& state, const std::vector<Hold>& holds);
  void arm(std::vector<Hold>& holds) const;
  void fall(double limit, Bookkeeping& book);
  void integrate(double limit, Bookkeeping& book);
  double controlled_step(double h, Bookkeeping& book);
  void complete_step(double h);
  void restep(double length);
  double reach_crossing(const Crossing& crossing, double h);
  double reach_release(double length);
  [[nodiscard]] std::optional<double> first_release(double until);
  [[nodiscard]] std::optional<double> first_opening(double until, Bookkeeping& book);
  bool opens_at(double share, Bookkeeping& book);
  void finish(double span, double elapsed, bool event, Bookkeeping& book);

  const System* system_;
  MotionSettings settings_;
  ContactLaw law_;
  ClosedContacts closed_;
  ClosedContacts looker_;  ///< for looks between steps
  EventSearch search_;
  Dop853 method_;
  IslandDynamics openings_;
  ContactFinder finder_;
  Scales scales_;
  Closure closure_;

  double clock_ = 0.0;
  State state_;               ///< at the clock
  std::vector<double> y_;     ///< the same, packed
  std::vector<double> rate_;  ///< its rate
  std::vector<double> scale_;
  std::vector<Hold> holds_;

  State next_;  ///< at the end of the step that is being taken
  std::vector<double> next_y_;
  std::vector<double> next_rate_;
  std::vector<Hold> next_holds_;
  std::vector<TwistRange> range_;
  DenseStep dense_;
  double length_ = 0.0;  ///< s, of that step

  std::deque<MotionPiece> pieces_;
  State scratch_;
  std::vector<Twist> accelerations_;
  std::vector<Contact> contacts_;
  std::vector<Island> islands_;
  double step_ = 0.0;  ///< s, proposed length of the next step
  double fall_ = 0.0;  ///< s, of the next free fall
  double pull_ = 0.0;  ///< smallest hold since it was reset
  long events_ = 0;
  int instant_events_ = 0;  ///< in a row, without time passing
};

}  // namespace wuerfel
