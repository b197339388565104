#include "app/output/accuracy.h"

#include <cmath>

#include <fmt/core.h>

namespace wuerfel {
namespace {

/// Share of the smaller side of a pair up to which bodies may touch with overlap (and a little for
/// rounding).
constexpr double promised_overlap = 1.01e-9;

/// Residual of Coulomb's law that is counted but borne.
constexpr double promised_friction = 1e-6;

/// What is less exact than was asked for; empty where nothing is.
std::string missed_promise(const Audit& audit, double force_residual) {
  if (audit.missed_solves > 0) {
    return fmt::format(
        "{} contact problems were solved less exactly than asked for, the worst with a residual of "
        "{:.2g}; the result is there but over the error budget",
        audit.missed_solves, audit.max_kkt_residual);
  }
  if (audit.unresolved > 0) {
    return fmt::format(
        "{} times events could not be told apart, or wedged bodies had to stop short; the result "
        "is there but over the error budget",
        audit.unresolved);
  }
  if (audit.friction_residual > promised_friction) {
    return fmt::format(
        "Coulomb's law was missed in {} contact problems, the worst with a residual of {:.2g}; the "
        "result is there but over the error budget",
        audit.friction_inexact, audit.friction_residual);
  }
  if (audit.max_overlap > promised_overlap) {
    return fmt::format(
        "bodies overlap by up to {:.2g} of a side, more than the {:.0g} that is promised; the "
        "result is there but over the error budget",
        audit.max_overlap, promised_overlap);
  }
  if (audit.drift_budget > 0.0 && !(std::abs(audit.drift()) <= audit.drift_budget)) {
    return fmt::format(
        "energy drifted by {:.2g} J, more than the {:.2g} J that the tolerance promises; try a "
        "smaller --tolerance",
        audit.drift(), audit.drift_budget);
  }
  if (force_residual > QpSettings{}.tolerance) {
    return fmt::format(
        "forces were found with a residual of up to {:.2g}, over the error budget; the motion does "
        "not depend on them",
        force_residual);
  }
  return {};
}

}  // namespace

ExitCode verdict_on_accuracy(const Audit& audit, double force_residual, Notes& notes) {
  const std::string missed = missed_promise(audit, force_residual);
  if (missed.empty()) return ExitCode::fine;
  notes.warn(missed);
  return ExitCode::undecided;
}

}  // namespace wuerfel
