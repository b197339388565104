#include "app/accuracy.h"

#include <cmath>

#include <fmt/core.h>

namespace wuerfel {
namespace {

/// Share of the smaller side of a pair up to which bodies may touch with overlap (and a little for
/// rounding).
constexpr double promised_overlap = 1.01e-9;

}  // namespace

ExitCode verdict_on_accuracy(const Audit& audit, double force_residual) {
  if (audit.missed_solves > 0) {
    fmt::print(stderr,
               "wuerfel: {} programs were solved less exactly than asked for, the worst with a "
               "residual of {:.2g}; the result is there but over the error budget\n",
               audit.missed_solves, audit.max_kkt_residual);
    return ExitCode::undecided;
  }
  if (audit.unresolved > 0) {
    fmt::print(
        stderr,
        "wuerfel: {} times events could not be told apart, or wedged bodies had to stop short; "
        "the result is there but over the error budget\n",
        audit.unresolved);
    return ExitCode::undecided;
  }
  if (audit.max_overlap > promised_overlap) {
    fmt::print(stderr,
               "wuerfel: bodies overlap by up to {:.2g} of a side, more than the {:.0g} that is "
               "promised; the result is there but over the error budget\n",
               audit.max_overlap, promised_overlap);
    return ExitCode::undecided;
  }
  if (audit.drift_budget > 0.0 && !(std::abs(audit.drift()) <= audit.drift_budget)) {
    fmt::print(stderr,
               "wuerfel: energy drifted by {:.2g} J, more than the {:.2g} J that the tolerance "
               "promises; try a smaller --tolerance\n",
               audit.drift(), audit.drift_budget);
    return ExitCode::undecided;
  }
  if (force_residual > QpSettings{}.tolerance) {
    fmt::print(stderr,
               "wuerfel: forces were found with a residual of up to {:.2g}, over the error budget; "
               "the motion does not depend on them\n",
               force_residual);
    return ExitCode::undecided;
  }
  return ExitCode::fine;
}

}  // namespace wuerfel
