/// A motion that is computed as far as somebody asks for it.
#pragma once

#include <functional>

#include "core/constraints/contact.h"
#include "core/time/bookkeeping.h"
#include "core/time/restart_point.h"

namespace wuerfel {

class Motion {
 public:
  virtual ~Motion() = default;
  /// `pulse` is called between the steps of `advance_to`. What it throws leaves `advance_to`; the
  /// motion can only be destroyed then.
  void set_pulse(std::function<void()> pulse) { pulse_ = std::move(pulse); }
  /// `listener` is told of every restart. The states of the looks before it are not needed any more.
  void set_restart_listener(RestartListener listener) { listener_ = std::move(listener); }
  /// Moves on to time t exactly; the state is that just after an event that falls on t.
  virtual void advance_to(double t) = 0;
  [[nodiscard]] virtual double time() const = 0;
  /// How far it has been computed; also while `advance_to` works.
  [[nodiscard]] virtual double reached() const = 0;
  /// Where the cubes are; found when it is first asked for. Asking changes nothing else: neither the
  /// motion nor its books.
  virtual const State& state() = 0;
  /// Contacts that carried load in the step of a stepping in which the time lies.
  virtual std::vector<Contact> loaded() { return {}; }
  /// Of the states that were computed, whoever looked at what.
  [[nodiscard]] virtual StateHash hash() const = 0;
  /// What happened up to now.
  [[nodiscard]] virtual const Bookkeeping& book() = 0;

 protected:
  void beat() const {
    if (pulse_) pulse_();
  }
  [[nodiscard]] const RestartListener& listener() const { return listener_; }

 private:
  std::function<void()> pulse_;
  RestartListener listener_;
};

}  // namespace wuerfel
