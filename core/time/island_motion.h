#pragma once

#include "core/time/event_motion.h"
#include "core/time/motion.h"
#include "core/time/stepper.h"

namespace wuerfel {

class IslandMotion final : public Motion {
 public:
  IslandMotion(const System& system, const MotionSettings& settings, Moment start);

  void advance_to(double t) override;
  [[nodiscard]] const Moment& now() const override { return moment_; }
  [[nodiscard]] const Moment& now_with_forces() override;
  [[nodiscard]] const Bookkeeping& book() const override { return shown_; }

 private:
  const System* system_;
  MotionSettings settings_;
  EventMotion motion_;
  Stepper looker_;
  Moment moment_;
  Bookkeeping computed_;  ///< up to the clocks
  Bookkeeping shown_;     ///< up to now
  std::size_t next_event_ = 0;
};

}  // namespace wuerfel
