#include "app/accuracy.h"

#include <fmt/core.h>

namespace wuerfel {

ExitCode verdict_on_accuracy(const Audit& audit) {
  if (audit.missed_solves == 0) return ExitCode::fine;
  fmt::print(stderr,
             "wuerfel: {} programs were solved less exactly than asked for, the worst with a "
             "residual of {:.2g}; the result is there but over the error budget\n",
             audit.missed_solves, audit.max_kkt_residual);
  return ExitCode::undecided;
}

}  // namespace wuerfel
