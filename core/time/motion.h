/// A motion that is computed as far as somebody asks for it.
#pragma once

#include <functional>

#include "core/constraints/contact.h"
#include "core/time/bookkeeping.h"

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
  /// Where the cubes are; found when it is first asked for. Asking changes nothing else: neither the
  /// motion nor its books.
  virtual const State& state() = 0;
  /// Contacts that carried load in the step of a stepping in which the time lies.
  virtual std::vector<Contact> loaded() { return {}; }
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
