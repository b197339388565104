/// A smooth phase: motion while the same contacts stay closed. Their sides and the rods are equalities,
/// (7) and (1), so that accelerations follow from one linear system; DOP853 integrates them with error control
/// [Hairer, Norsett, Wanner 1993], and after every step positions and velocities are put on the
/// contacts and rods again. Without them it is a parabola of any length.
#pragma once

#include <vector>

#include "core/model/scales.h"
#include "core/time/events/contact_modes.h"
#include "core/time/events/equations_of_motion.h"
#include "core/time/events/event_function.h"
#include "core/time/events/motion_piece.h"

namespace wuerfel {

/// What the contacts of a phase bear (find_loads) over all evaluations of a step, and the other
/// functions that must stay positive.
struct BorneRange {
  double low = 0.0;  ///< N
  double high = 0.0;
};

/// A step, which may have been cut short after `elapsed`.
struct SmoothStep {
  double elapsed = 0.0;                ///< s
  double length = 0.0;                 ///< s, of the polynomial
  DenseStep motion;                    ///< where the phase is watched
  std::vector<TwistRange> range;       ///< of accelerations, one per cube; likewise
  std::vector<BorneRange> load_range;  ///< one per load
  State end;                           ///< after `elapsed`, on the contacts
  std::vector<double> y;               ///< the same, packed
  std::vector<double> rate;            ///< and its rate
  std::vector<double> loads;           ///< N, there
  Push push;                           ///< by fixed bodies, in the step
  State flown;  ///< its end before it was put on contacts with fixed bodies; empty: it was not
  /// Whether the error is small enough; else the contacts' rows nearly depend on one another, and
  /// accelerations are no smooth function any more.
  bool followed = true;
};

class SmoothPhase {
 public:
  /// `parabolas`: cubes that touch nothing fall on their parabola, without an integrator.
  SmoothPhase(const System& system, bool parabolas)
      : system_(&system), equations_(system), parabolas_(parabolas) {}

  /// A motion begins: nothing is known of how long steps may be.
  void forget_step() { proposed_ = 0.0; }
  /// The phase begins at a state, which is put on the contacts. `tolerance`: of a step, in units of
  /// L and V.
  void begin(const State& state,
             const ContactSet& closed,
             const std::vector<char>& resting,
             double tolerance);

  [[nodiscard]] const Scales& scales() const { return scales_; }
  /// State at the beginning of the next step, and what the contacts bear there.
  [[nodiscard]] const State& state() const { return start_; }
  [[nodiscard]] const std::vector<double>& loads() const { return loads_; }
  [[nodiscard]] Twist acceleration(int cube) const;
  [[nodiscard]] const EquationsOfMotion& equations() const { return equations_; }
  /// The closed contacts, as they are at the last state that was asked for.
  [[nodiscard]] ContactSet closed() const { return {equations_.contacts(), equations_.touches()}; }

  /// Whether somebody looks into steps while they are taken; else they have no polynomial (motion_of makes it).
  void set_watched(bool watched) { watched_ = watched; }
  /// Takes a step of at most `most` s.
  const SmoothStep& step(double most);
  [[nodiscard]] const SmoothStep& last() const { return step_; }
  /// Takes the same step again, but only as far as `length`.
  void cut(double length);
  /// Moves the end of the step by a moment in which accelerations change by no more than rounding.
  void shift_end(double time);
  /// The end of the step as `shift_end` would move it.
  [[nodiscard]] State shifted_end(double time) const { return shifted(step_.end, time); }
  /// The step is over: the next one begins where it ended.
  void go_on();

  /// Loads at a state near the phase.
  void loads_at(const State& state, std::vector<double>& loads);
  /// Puts a state on the closed contacts.
  void project(State& state) { equations_.project(state); }
  [[nodiscard]] bool redundant() const { return equations_.redundant(); }
  /// Whether friction gives energy, at the state of the last evaluation, where it should take some.
  [[nodiscard]] bool friction_drives() const {
    return equations_.friction_drives(force_rounding * scales_.weight);
  }
  /// Whether no accelerations keep the lengths of all rods at the end of the step.
  [[nodiscard]] bool rods_contradict() const;
  [[nodiscard]] bool free() const { return parabolas_ && equations_.free(); }

 private:
  void evaluate(const std::vector<double>& y, std::vector<double>& rate);
  void take_step(double length);
  void fall(double most);
  void integrate(double most);
  void complete(double length);
  void note_range();
  [[nodiscard]] State shifted(State state, double time) const;

  const System* system_;
  EquationsOfMotion equations_;
  Dop853 method_;
  Scales scales_;
  std::vector<double> error_scale_;
  State start_;
  std::vector<double> y_;     ///< the same, packed
  std::vector<double> rate_;  ///< and its rate
  std::vector<double> loads_;
  std::vector<double> seen_;  ///< scratch of `evaluate`
  Push push_;                 ///< by fixed bodies at the beginning of the next step, N and N m
  Push end_push_;             ///< and at its end
  SmoothStep step_;
  double proposed_ = 0.0;  ///< s, length of the next step
  bool parabolas_ = true;
  bool watched_ = true;
  double fall_ = 0.0;  ///< s, of the next free fall
};

/// The polynomial of a smooth piece; of one that has none by its step again.
DenseStep motion_of(const System& system, const MotionPiece& piece);

}  // namespace wuerfel
