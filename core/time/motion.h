/// A motion that is computed as far as somebody asks for it.
#pragma once

#include <functional>

#include "core/time/bookkeeping.h"
#include "core/time/moment.h"

namespace wuerfel {

class Motion {
 public:
  virtual ~Motion() = default;
  /// `pulse` is called between the steps of `advance_to`. What it throws leaves `advance_to`; the
  /// motion can only be destroyed then.
  void set_pulse(std::function<void()> pulse) { pulse_ = std::move(pulse); }
  /// Moves on to time t exactly; the state is that just after an event that falls on t.
  virtual void advance_to(double t) = 0;
  [[nodiscard]] virtual double time() const = 0;
  /// Where the motion is: its state.
  virtual const Moment& now() = 0;
  /// The same with contacts, which the audit sees.
  virtual const Moment& now_with_contacts() = 0;
  /// The same with accelerations and forces.
  virtual const Moment& now_with_forces() = 0;
  /// What happened up to now.
  [[nodiscard]] virtual const Bookkeeping& book() = 0;

 protected:
  void beat() const {
    if (pulse_) pulse_();
  }

 private:
  std::function<void()> pulse_;
};

}  // namespace wuerfel
