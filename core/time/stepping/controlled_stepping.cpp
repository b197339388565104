#include "core/time/stepping/controlled_stepping.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/time/promises.h"

namespace wuerfel {
namespace {

/// Steps are halved where the error is more, where rods miss their lengths, where energy rises by more than this share of
/// what the group has in motion, or where overlap is left, but not below a sixteenth; what still overlaps then stops
/// short.
constexpr double rise_share = 1e-4;
/// What of that nothing can pay for is to be no more than this share of it.
constexpr double unpaid_share = 1e-4;
constexpr double shortest_share = 1.0 / 16.0;
/// Rods that are farther off their lengths at the end of the shortest step are torn.
constexpr double torn_share = 1e-6;
/// Where energy sways a step with rods may add no more than this share of what it may sway by.
constexpr double sway_of_step = 0.1;
/// They are doubled where error and rise are below these shares of what is allowed.
constexpr double doubled_error = 0.1;
constexpr double doubled_rise = 0.2;
/// Steps shorter than this share of L / V are not taken: velocities are read off differences of
/// positions, which have no digits then.
constexpr double same_time = 1e-7;

}  // namespace

ControlledStepping::ControlledStepping(const System& system,
                                       const MotionSettings& settings,
                                       const MotionPolicy& policy)
    : system_(&system),
      stepper_(system, settings, policy.sway),
      allowed_error_(policy.allowed_error),
      sway_(policy.sway) {}

void ControlledStepping::begin(const State& state, double first, double longest) {
  scales_ = scales_of(*system_, state);
  state_ = state;
  step_ = first;
  longest_ = longest;
  stepper_.begin(state);
}

double ControlledStepping::advance(double t, double end, Bookkeeping& book) {
  if (end - t < same_time * scales_.time) {
    // Nothing happens in it. The record of the step before tells of blows that are over.
    record_ = std::make_shared<const StepRecord>();
    return end;
  }
  const double room = std::min(stepper_.longest_step(state_), end - t);
  const double whole = std::min(step_, room);
  const double wanted = end - t - whole < same_time * scales_.time ? end - t : whole;
  const double shortest =
      shortest_share * std::min(room, std::max(step_, shortest_share * longest_));
  double h = wanted;
  Step step = take_step(t, shortest, h);
  // What had to be halved is tried with its half at first the next time, whatever had bounded it.
  if (h < wanted || whole == step_) {
    const bool easy = h == wanted && step.error <= doubled_error * allowed_error_
                      && step.rise.whole <= doubled_rise * bearable_rise()
                      && step.rise.sway <= doubled_error * bearable_sway();
    step_ = std::clamp(easy ? 2.0 * h : h, shortest_share * shortest_share * longest_, longest_);
  }
  add(step.book, book);
  stepper_.accept(step);
  state_ = std::move(step.state);
  record_ = std::move(step.record);
  return h == end - t ? end : t + h;
}

/// By how much energy may rise in a step before it is put right, J.
double ControlledStepping::bearable_rise() const {
  return rise_share * energy_in_motion(*system_, state_, scales_);
}

/// By how much a step may change the energy before it is put right, J, either way. Without rods it is put right before it has
/// strayed far, and shorter steps would cost a third more.
double ControlledStepping::bearable_sway() const {
  if (system_->rods.empty()) return std::numeric_limits<double>::infinity();
  return sway_ > 0.0 ? sway_of_step * sway_ * energy_in_motion(*system_, state_, scales_)
                     : bearable_rise();
}

/// Whether the error of a step and what it changed the energy by are small enough.
bool ControlledStepping::is_exact(const Step& step) const {
  return step.rise.sway <= bearable_sway() && step.error <= allowed_error_
         && step.rise.whole <= bearable_rise()
         && step.rise.unpaid <= unpaid_share * bearable_rise();
}

/// Whether a step leads nowhere: energy that nothing pays for, or rods far from their lengths, to which no motion leads back.
bool ControlledStepping::is_hopeless(const Step& step) const {
  return step.rise.unpaid > bearable_rise() || step.book.audit.max_rod_error > torn_share;
}

/// The longest step of h, h / 2, h / 4 .. that is good enough, or the shortest; `h` becomes its length.
Step ControlledStepping::take_step(double t, double shortest, double& h) {
  Cost tried;
  while (true) {
    Step step = stepper_.step(state_, t, h);
    step.book.cost = sum_of(step.book.cost, tried);
    const bool clean = step.overlap <= overlap_share;
    const bool kept = step.book.audit.max_rod_error <= promised_rod_error;
    if (clean && kept && is_exact(step)) return step;
    if (h <= shortest) {
      if (!clean) {
        step = stepper_.stop_short(std::move(step), t);
        ++step.book.audit.unresolved;
      }
      if (is_hopeless(step)) {
        step = stepper_.halt(std::move(step), t);
        ++step.book.audit.unresolved;
      }
      return step;
    }
    tried = step.book.cost;
    h *= 0.5;
  }
}

State ControlledStepping::with_closed_gaps() {
  State state = state_;
  stepper_.close_gaps(state);
  return state;
}

}  // namespace wuerfel
