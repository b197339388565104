/// Motion in steps of equal length, all cubes at once: Algorithm 1 of the paper and its relatives.
#pragma once

#include <optional>

#include "core/time/motion.h"
#include "core/time/reference/stepper.h"

namespace wuerfel {

class SteppedMotion final : public Motion {
 public:
  SteppedMotion(const System& system, const MotionSettings& settings, Moment start);

  void advance_to(double t) override;
  [[nodiscard]] double time() const override { return shown_ ? shown_->t : grid_.t; }
  const Moment& now() override { return shown_ ? *shown_ : grid_; }
  const Moment& now_with_contacts() override { return now(); }
  const Moment& now_with_forces() override;
  [[nodiscard]] const Bookkeeping& book() override { return book_; }

 private:
  void note_rods();

  const System* system_;
  MotionSettings settings_;
  Stepper stepper_;
  Stepper looker_;               ///< for looks between steps: what it remembers is not the motion's
  Moment grid_;                  ///< at a whole number of steps
  std::optional<Moment> shown_;  ///< between grid times, where somebody asked for it
  Bookkeeping book_;
  long whole_steps_ = 0;
};

}  // namespace wuerfel
