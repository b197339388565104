/// A part of a group that moves while the rest of it stands.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/time/bookkeeping.h"
#include "core/time/policy.h"
#include "core/time/workspace.h"

namespace wuerfel {

class Track;

/// Cubes that stand still and are not accelerated are ground to the others, as long as there are forces that hold them there: a
/// cube that tips from a wall moves as from a fixed box, as exactly and at that cost. Whether what stands is held is asked after
/// each step, by the program of the whole group.
class PartialMotion {
 public:
  /// What of a group moves from `state` at time t on, where enough of the others stand; else none. `touching`: the share of the
  /// smaller side up to which bodies touch. `work` is that of the group, and kept.
  static std::unique_ptr<PartialMotion> find(const State& state,
                                             double t,
                                             double touching,
                                             const MotionSettings& settings,
                                             const MotionPolicy& policy,
                                             Workspace& work);
  ~PartialMotion();
  PartialMotion(const PartialMotion&) = delete;
  PartialMotion(PartialMotion&&) = delete;
  PartialMotion& operator=(const PartialMotion&) = delete;
  PartialMotion& operator=(PartialMotion&&) = delete;
  /// Whether so few cubes are not still that it is worth while to look for one.
  static bool few_move(const System& system, const State& state);

  /// No step from now on is longer, s.
  void set_longest_step(double longest) { longest_step_ = longest; }
  /// One step, at most to `limit`. Where the others would not have stood it is not taken, and nothing is booked.
  void advance(double limit, Bookkeeping& book);
  /// Whether it can be advanced further; else the group has to go on from the clock otherwise.
  [[nodiscard]] bool goes_on() const { return goes_on_; }
  /// Whether its events crowd, or it is wedged.
  [[nodiscard]] bool is_stepped() const;
  /// Length of the step that was not taken, s; 0 where that was not why it ended.
  [[nodiscard]] double refused() const { return refused_; }

  // As of a Track, for all cubes of the group.
  [[nodiscard]] double clock() const { return clock_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] State at(double t);
  [[nodiscard]] std::vector<Contact> loaded_at(double t) const;
  [[nodiscard]] const std::vector<char>& resting() const { return resting_; }
  [[nodiscard]] bool at_rest() const;
  void forget_before(double t);
  void sweep(double t, std::vector<BoundingBox>& bounds) const;

 private:
  PartialMotion(const State& state, std::vector<char> stands, double touching, Workspace& work);
  bool begin(double t, const MotionSettings& settings, const MotionPolicy& policy);
  bool accept(Bookkeeping& book);
  void take_over();
  std::optional<std::vector<Event>> withstand(const std::map<int, Push>& blows);
  [[nodiscard]] int of_group(int body) const;
  [[nodiscard]] bool are_held();
  [[nodiscard]] bool is_held(const Island& island,
                             const State& state,
                             const std::vector<char>& loose,
                             const std::vector<Twist>& accelerations);
  [[nodiscard]] State with_others(const State& part) const;

  Workspace* work_;          ///< of the group
  double touching_;          ///< share of the smaller side up to which bodies touch
  std::vector<int> moving_;  ///< cubes of the group, ascending
  std::vector<int> standing_;
  System system_;  ///< of those that move, on the others
  std::unique_ptr<Track> track_;
  bool goes_on_ = true;
  double longest_step_ = std::numeric_limits<double>::infinity();  ///< s
  double refused_ = 0.0;                                           ///< s
  double clock_ = 0.0;         ///< s, up to which the others are known to stand
  State state_;                ///< of the group, there
  std::vector<char> resting_;  ///< per cube of the group
  std::map<int, std::vector<int>>
      at_rest_;  ///< islands of which all are known to stand, by their first cubes
};

}  // namespace wuerfel
