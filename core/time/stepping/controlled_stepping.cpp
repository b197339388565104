#include "core/time/stepping/controlled_stepping.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// Steps of second order have the root of the tolerance as their local error; in crowds, which
/// forget where they come from within a few impacts, so many times that.
constexpr double crowd_error = 20.0;
/// They are halved where the error is more, where energy rises by more than this share of what the
/// group has in motion, or where overlap is left, but not below a sixteenth; what still overlaps
/// then stops short.
constexpr double rise_share = 1e-4;
constexpr double shortest_share = 1.0 / 16.0;
/// They are doubled where error and rise are below these shares of what is allowed.
constexpr double doubled_error = 0.1;
constexpr double doubled_rise = 0.2;
/// Steps shorter than this share of L / V are not taken: velocities are read off differences of
/// positions, which have no digits then.
constexpr double same_time = 1e-7;

}  // namespace

ControlledStepping::ControlledStepping(const System& system, const MotionSettings& settings)
    : system_(&system), stepper_(system, settings) {
  const bool crowd = settings.integrator != Integrator::rattle;
  const double error = std::sqrt(settings.tolerance);
  allowed_error_ = crowd ? crowd_error * error : error;
  sway_ = crowd ? 0.0 : error;
}

void ControlledStepping::begin(const State& state, double first, double longest) {
  scales_ = scales_of(*system_, state);
  state_ = state;
  step_ = first;
  longest_ = longest;
  ceiling_ = energy(*system_, state);
}

double ControlledStepping::advance(double t, double end, Bookkeeping& book) {
  if (end - t < same_time * scales_.time) return end;
  const double whole = std::min({step_, stepper_.longest_step(state_), end - t});
  const double wanted = end - t - whole < same_time * scales_.time ? end - t : whole;
  const std::size_t logged = book.events.size();
  State next;
  const double h = take_step(next, t, wanted, book);
  if (whole == step_) {
    const bool easy =
        h == wanted && stepper_.error() <= doubled_error * allowed_error_ && rise_ <= doubled_rise;
    step_ = std::clamp(easy ? 2.0 * h : h, shortest_share * longest_, longest_);
  }
  for (std::size_t k = logged; k < book.events.size(); ++k)
    ceiling_ -= book.events[k].loss;
  bring_down(*system_, ceiling_ + sway_ * in_motion(next), next);
  state_ = std::move(next);
  return h == end - t ? end : t + h;
}

/// The energy that steps are judged by, J.
double ControlledStepping::in_motion(const State& state) const {
  return kinetic_energy(*system_, state) + scales_.weight * scales_.length;
}

/// The longest of h, h / 2, h / 4 .. that is good enough; returns it.
double ControlledStepping::take_step(State& next, double t, double h, Bookkeeping& book) {
  const double shortest = h * shortest_share;
  const double bearable = rise_share * in_motion(state_);
  const Bookkeeping before = book;
  while (true) {
    next = state_;
    rise_ = stepper_.step(next, t, h, book) / bearable;
    const bool clean = stepper_.overlap_left() <= overlap_share;
    const bool exact = stepper_.error() <= allowed_error_ && rise_ <= 1.0;
    if (clean && (exact || h <= shortest)) return h;
    const Cost cost = book.cost;
    book = before;
    book.cost = cost;
    if (h <= shortest) {
      rise_ = stepper_.stop_short(next, t, book) / bearable;
      ++book.audit.unresolved;
      return h;
    }
    h *= 0.5;
  }
}

bool ControlledStepping::is_slower_than(double speed) const {
  for (std::size_t i = 0; i < state_.size(); ++i) {
    if (fastest_corner(system_->bodies[i], state_[i]) > speed) return false;
  }
  return true;
}

State ControlledStepping::with_closed_gaps() {
  State state = state_;
  stepper_.close_gaps(state);
  return state;
}

}  // namespace wuerfel
