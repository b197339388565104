/// The motion of a group of cubes by itself, with a clock of its own: from event to event, and in
/// steps where events crowd.
#pragma once

#include <limits>
#include <memory>

#include "core/time/crowding.h"
#include "core/time/events/event_motion.h"
#include "core/time/motion_history.h"
#include "core/time/partial_motion.h"
#include "core/time/policy.h"
#include "core/time/restart_point.h"
#include "core/time/stepping/controlled_stepping.h"

namespace wuerfel {

/// Which of the two moves the group. Changes are decided by counts of events, never by clocks of
/// the machine: the same scene changes at the same instants.
///
///   - events that crowd (Crowding) hand over to stepping, at once and from where the motion is; so
///     do cubes that are wedged, and an event that was missed and would leave overlap,
///   - stepping lasts for some frames, and until impacts no longer crowd; then gaps of contacts that
///     carry load are closed and the events get their next chance. Large groups go back only to be
///     found at rest,
///   - where most cubes of a large group stand, the others move as a group of their own on them (PartialMotion).
class Track {
 public:
  Track(const System& system, const MotionSettings& settings, const MotionPolicy& policy);

  /// The motion begins at time t. `touching` is the share of the smaller side up to which bodies
  /// touch (0: to rounding); `resting` are the cubes known to be at rest; `stepping` goes on where
  /// it is not over.
  void start(const State& state,
             double t,
             double touching,
             std::vector<char> resting,
             const Stepping& stepping);
  [[nodiscard]] Stepping stepping() const;

  /// Time up to which the motion is known; infinite where all is at rest.
  [[nodiscard]] double clock() const;
  /// One step, at most to `limit`.
  void advance(double limit);
  /// State at the clock.
  [[nodiscard]] const State& state() const;
  /// State at a time that is known and not forgotten; just after events.
  [[nodiscard]] State at(double t);
  /// Contacts that carried load in the step of a stepping in which such a time lies.
  [[nodiscard]] std::vector<Contact> loaded_at(double t) const;
  void forget_before(double t);

  /// Blows to what only stands, at the clock: see EventMotion.
  [[nodiscard]] const std::map<int, Push>& blows() const { return events_.blows(); }
  /// At the clock of a motion by events.
  [[nodiscard]] Twist acceleration(int cube) const { return events_.acceleration(cube); }
  /// Takes them; false where that leaves overlap: the motion has to go on otherwise from before.
  [[nodiscard]] bool take_blows();
  [[nodiscard]] bool at_rest() const { return !stepping_ && !part_ && events_.at_rest(); }
  /// Certified rest, per cube.
  [[nodiscard]] const std::vector<char>& resting() const;
  /// What has been booked since it was cleared.
  [[nodiscard]] Bookkeeping& book() { return book_; }
  /// Bounds of what each cube swept since `t`, blown up by its half diagonal.
  void sweep(double t, std::vector<BoundingBox>& bounds) const;

 private:
  void follow_events(double limit);
  [[nodiscard]] std::vector<std::string> moving_names() const;
  bool rest_from(const State& state, double t, double touching, std::vector<char> resting);
  bool part_from(const State& state, double t, double touching, double longest);
  bool move_part(double touching);
  void advance_part(double limit);
  void go_on_after(const PartialMotion& part);
  void follow_from(const State& state,
                   double t,
                   const ContactLimits& limits,
                   std::vector<char> resting);
  void go_on_from(const State& state, double t, double touching, std::vector<char> resting);
  void rest_there(const State& state, double t);
  void begin_steps(const State& state, double t, double until);
  [[nodiscard]] bool leaves_overlap(const Audit& before);
  void consider_events();
  void hand_over(const State& state, double t);
  void step(double limit);
  void go_on_or_hand_back();
  void book_closing(const State& closed);
  bool rest_with_closed_gaps();
  bool hand_to_part();
  void hand_back();

  const System* system_;
  MotionSettings settings_;
  MotionPolicy policy_;
  bool only_steps_ = false;  ///< large groups that rub or bounce
  EventMotion events_;
  MotionHistory history_;
  std::unique_ptr<ControlledStepping> steps_;  ///< none before the first step
  std::unique_ptr<Workspace> work_;      ///< of parts; none before the first one was looked for
  std::shared_ptr<PartialMotion> part_;  ///< that moves
  Scales scales_;
  bool stepping_ = false;
  std::vector<char> moving_;  ///< nobody rests while stepping
  double clock_ = 0.0;        ///< s, of the stepping
  double until_ = 0.0;        ///< s, end of the stepping
  Crowding crowding_;
  long last_events_ = 0;  ///< of `events_`, when they were counted last
  Bookkeeping book_;
};

/// The one that ends later, with the longer patience.
Stepping later(const Stepping& a, const Stepping& b);

}  // namespace wuerfel
