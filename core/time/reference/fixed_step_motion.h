/// Motion in steps of equal length, all cubes at once: Algorithm 1 of the paper and its relatives.
#pragma once

#include "core/dynamics/momentum_balance.h"
#include "core/model/scales.h"
#include "core/time/motion.h"
#include "core/time/policy.h"
#include "core/time/reference/grid_point.h"
#include "core/time/workspace.h"

namespace wuerfel {

class FixedStepMotion final : public Motion {
 public:
  /// The motion from `start` at t = 0 on.
  FixedStepMotion(const System& system, const MotionSettings& settings, const State& start);
  /// The same motion taken up again.
  FixedStepMotion(const System& system,
                  const MotionSettings& settings,
                  const State& start,
                  const RestartPoint& point);

  void advance_to(double t) override;
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] double reached() const override { return grid_.t; }
  const State& state() override;
  [[nodiscard]] const Bookkeeping& book() override { return book_; }
  [[nodiscard]] StateHash hash() const override { return hash_; }

 private:
  void take(GridPoint& point, double dt, Workspace& work, Bookkeeping& book) const;
  void step();
  void restart();
  void begin(const State& state);
  void note_rods();
  void note_energy();
  [[noreturn]] void fail() const;

  const System* system_;
  MotionSettings settings_;
  MotionPolicy policy_ = policy_of(settings_);
  Workspace work_;
  GridPoint grid_;
  Scales scales_;
  double energy_start_ = 0.0;  ///< J
  double in_motion_ = 0.0;     ///< J, at the start
  MomentumScale momentum_;     ///< the largest up to now
  StateHash hash_;             ///< of the grid points
  State between_;  ///< at `time_`, where that is no grid time; empty until it is asked for
  Bookkeeping book_;
  long whole_steps_ = 0;
  long stepped_ = 0;   ///< steps times cubes since the last restart
  double time_ = 0.0;  ///< s, where the motion is looked at
};

}  // namespace wuerfel
