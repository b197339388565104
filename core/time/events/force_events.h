/// When does a contact let go? Loads of closed contacts as event functions.
#pragma once

#include <optional>
#include <vector>

#include "core/time/events/contact_modes.h"
#include "core/time/events/smooth_phase.h"

namespace wuerfel {

/// Loads of a smooth phase. Where contacts depend on one another their loads are not unique, and a
/// negative one is no reason to open; then Gauss' program with inequalities is asked instead.
class ForceEvents {
 public:
  /// A phase begins with the loads that `phase` has found. Below `share` of the weight a load counts
  /// as zero, and below that share of V the speed of a slip.
  void begin(const SmoothPhase& phase, double share);

  struct First {
    double share = 1.0;       ///< of the step
    std::optional<int> load;  ///< that vanishes there; none where redundant contacts open
    Arming arming;
  };
  /// What lets go first within a step that `phase` has taken, up to the share `until`. `gravity`:
  /// g, m/s^2.
  [[nodiscard]] std::optional<First> first(SmoothPhase& phase,
                                           double until,
                                           double gravity,
                                           Workspace& work) const;
  /// The motion has come to these loads without an event.
  void passed(const std::vector<double>& loads);

 private:
  [[nodiscard]] std::optional<First> first_release(SmoothPhase& phase,
                                                   int from,
                                                   double until) const;
  [[nodiscard]] std::optional<First> first_opening(SmoothPhase& phase,
                                                   double until,
                                                   double gravity,
                                                   Workspace& work) const;

  std::vector<Arming> loads_;
  int first_slip_ = 0;  ///< the loads before are forces, the others speeds
};

}  // namespace wuerfel
