#include "app/output/accuracy.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/time/promises.h"

namespace wuerfel {
namespace {

std::string text_of(Promise promise, const Audit& audit) {
  switch (promise) {
    case Promise::programs:
      return fmt::format(
          "{} contact problems were solved less exactly than asked for, the worst with a residual "
          "of {:.2g}",
          audit.missed_solves, audit.max_kkt_residual);
    case Promise::events:
      return fmt::format("{} times wedged bodies had to stop short", audit.unresolved);
    case Promise::friction:
      return fmt::format(
          "Coulomb's law was missed in {} contact problems, the worst with a residual of {:.2g}",
          audit.friction_inexact, audit.friction_residual);
    case Promise::overlap:
      return fmt::format(
          "bodies overlap by up to {:.2g} of a side, more than the {:.0g} that is promised",
          audit.max_overlap, promised_overlap);
    case Promise::energy:
      return fmt::format(
          "energy drifted by {:.2g} J, more than the {:.2g} J that are promised; try a smaller "
          "--tolerance or --step",
          audit.drift(), audit.drift_budget);
    case Promise::rods:
      if (audit.rods_contradicting > 0)
        return "rods contradict each other: no motion keeps all of their lengths";
      return fmt::format("rods have lost their lengths, by up to {:.2g} of them",
                         audit.max_rod_error);
    case Promise::momentum:
      if (audit.momentum_settled > audit.settled_budget) {
        return fmt::format(
            "what steps put right made fixed bodies give {:.2g} of the momenta, more than the "
            "{:.2g} that are promised; try a smaller --tolerance or --step",
            audit.momentum_settled, audit.settled_budget);
      }
      return fmt::format(
          "momenta changed by {:.2g} (linear) and {:.2g} (angular) of their size without a reason",
          audit.momentum_linear, audit.momentum_angular);
  }
  return "?";
}

// "a, b, c and 5 more".
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

Violation violation_of(Promise promise, const Simulation& simulation) {
  Violation violation{
      std::string(to_string(promise)), simulation.time(), {}, text_of(promise, simulation.audit())};
  if (const Breach* breach = first_breach(simulation.breaches(), promise); breach != nullptr) {
    violation.t = breach->t;
    violation.bodies = breach->bodies;
  }
  return violation;
}

}  // namespace

void AccuracyWatch::look(const Simulation& simulation, double force_residual) {
  const std::vector<Promise> broken = broken_promises(simulation.audit());
  if (!broken.empty()) {
    const Violation now = violation_of(broken.front(), simulation);
    // What is told later tells more of what was broken first.
    if (!first_ || first_->promise == now.promise) {
      const double t = first_ ? std::min(first_->t, now.t) : now.t;
      first_ = now;
      first_->t = t;
    }
  } else if (!first_ && force_residual > QpSettings{}.tolerance) {
    first_ = {"forces",
              simulation.time(),
              {},
              fmt::format("forces were found with a residual of up to {:.2g}; the motion does not "
                          "depend on them",
                          force_residual)};
  }
}

ExitCode AccuracyWatch::verdict(Notes& notes) const {
  if (!first_) return ExitCode::fine;
  std::string text =
      fmt::format("over the error budget: {}; first at {:.6g} s", first_->text, first_->t);
  if (!first_->bodies.empty()) text += fmt::format(" among {}", some_of(first_->bodies));
  notes.warn(text);
  return ExitCode::undecided;
}

}  // namespace wuerfel
