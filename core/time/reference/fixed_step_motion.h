/// Motion in steps of equal length, all cubes at once: Algorithm 1 of the paper and its relatives.
#pragma once

#include <variant>

#include "core/dynamics/momentum_balance.h"
#include "core/model/scales.h"
#include "core/time/motion.h"
#include "core/time/reference/algorithm_1.h"
#include "core/time/reference/moreau.h"

namespace wuerfel {

class FixedStepMotion final : public Motion {
 public:
  FixedStepMotion(const System& system, const MotionSettings& settings, const State& start);

  void advance_to(double t) override;
  [[nodiscard]] double time() const override { return time_; }
  const State& state() override;
  [[nodiscard]] const Bookkeeping& book() override { return book_; }

 private:
  using Method = std::variant<Algorithm1, Moreau>;
  [[nodiscard]] Method make_method() const;
  void step();
  void note_rods();

  const System* system_;
  MotionSettings settings_;
  Method method_;
  GridPoint grid_;
  Scales scales_;
  MomentumScale momentum_;  ///< the largest up to now
  State between_;  ///< at `time_`, where that is no grid time; empty until it is asked for
  Bookkeeping book_;
  long whole_steps_ = 0;
  double time_ = 0.0;  ///< s, where the motion is looked at
};

}  // namespace wuerfel
