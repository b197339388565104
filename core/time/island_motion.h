/// Motion of all cubes: groups that cannot meet for a while move by themselves, each with its own
/// clock, its own steps and its own choice between events and stepping
/// (timewarp: [Mirtich 2000]).
#pragma once

#include <limits>
#include <memory>

#include "core/dynamics/momentum_balance.h"
#include "core/time/meetings.h"
#include "core/time/motion.h"
#include "core/time/promised_drift.h"
#include "core/time/shown_book.h"
#include "core/time/track.h"

namespace wuerfel {

/// Works in windows of time. At the start of a window cubes whose predicted sweeps overlap form a
/// group; afterwards the sweeps that really happened are compared, and groups that could have met
/// are joined and moved again. How long windows are and where they lie does not depend on when
/// somebody looks, so that looking does not change the motion.
class IslandMotion final : public Motion {
 public:
  /// The motion from `start` at t = 0 on.
  IslandMotion(const System& system, const MotionSettings& settings, const State& start);
  /// The same motion taken up again.
  IslandMotion(const System& system,
               const MotionSettings& settings,
               const State& start,
               const RestartPoint& point);

  void advance_to(double t) override;
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] double reached() const override { return begin_; }
  const State& state() override;
  std::vector<Contact> loaded() override;
  [[nodiscard]] const Bookkeeping& book() override;
  [[nodiscard]] StateHash hash() const override { return hash_; }

 private:
  struct Group {
    std::vector<int> cubes;          ///< ascending
    std::unique_ptr<System> system;  ///< of these cubes; none where it is the whole one
    std::unique_ptr<Track> track;
  };
  void next_window();
  void set_units(const State& start);
  State end_window();
  void begin_window(const State& state);
  void restart(const State& state);
  void move(Group& group, double limit);
  void move_groups();
  void put_back(const State& state);
  [[nodiscard]] State state_at(double t);
  void regroup(const State& state, const Parts& parts);
  void make_group(const State& state, const std::vector<int>& cubes, Group& group);
  bool join_those_that_met(const State& state);
  void commit();

  const System* system_;
  MotionSettings settings_;
  MotionPolicy policy_ = policy_of(settings_);
  Scales scales_;
  PromisedDrift drift_;
  double energy_start_ = 0.0;  ///< J
  Meetings meetings_;
  std::vector<Group> groups_;
  std::vector<int> group_of_;       ///< per cube
  std::vector<char> resting_;       ///< per cube, at the start of the window
  std::vector<Stepping> stepping_;  ///< per cube, at the start of the window
  double begin_ = 0.0;              ///< s, of the window
  double end_ = 0.0;                ///< s, up to which all groups have come
  double length_ = 0.0;             ///< s, of the next window
  MomentumScale momentum_;          ///< the largest up to now
  StateHash hash_;                  ///< of the states at the ends of windows
  long work_ = 0;                   ///< steps times cubes since the last restart
  double time_ = 0.0;               ///< s, where the motion is looked at
  double still_since_ =
      std::numeric_limits<double>::infinity();  ///< s, from when on nothing moves; infinite while
                                                ///< something does
  State shown_state_;                           ///< at `time_`; empty until it is asked for
  Bookkeeping computed_;                        ///< up to the clocks; events in the order of time
  ShownBook shown_;                             ///< up to now
};

}  // namespace wuerfel
