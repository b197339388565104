#include "core/time/policy.h"

#include <cmath>

namespace wuerfel {
namespace {

/// Steps of second order have the root of the tolerance as their local error; in crowds, which
/// forget where they come from within a few impacts, so many times that.
constexpr double crowd_error = 20.0;
/// Energy sways by this share of it, so that it stays within its budget.
constexpr double sway_share = 0.25;

}  // namespace

MotionPolicy policy_of(const MotionSettings& settings) {
  const double root = std::sqrt(settings.tolerance);
  MotionPolicy policy;
  policy.allowed_error = crowd_error * root;
  policy.parts = settings.skips.standing;
  switch (settings.integrator) {
    case Integrator::automatic:
      break;
    case Integrator::event:
      policy.only_events = true;
      break;
    case Integrator::rattle:
      policy.only_steps = true;
      policy.parts = false;
      policy.step = settings.step;
      policy.allowed_error = root;
      policy.sway = sway_share * root;
      break;
    case Integrator::moreau:
      policy.method = MotionPolicy::Method::moreau;
      policy.step = settings.step;
      break;
    case Integrator::euler:
      policy.as_printed = true;
      [[fallthrough]];
    case Integrator::symplectic:
      policy.method = MotionPolicy::Method::algorithm_1;
      policy.step = settings.step;
      break;
  }
  return policy;
}

}  // namespace wuerfel
