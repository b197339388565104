/// Whether what was computed is as exact as was asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/exit_code.h"
#include "app/cli/streams.h"
#include "core/time/simulation.h"

namespace wuerfel {

/// A promise that was not kept: what, when first, and by whom.
struct Violation {
  std::string promise;  ///< its name
  double t = 0.0;       ///< s
  std::vector<std::string> bodies;
  std::string text;  ///< for people
};

/// Looks at a run from time to time. Fine is where every program was solved within the tolerance,
/// every event was found, nothing overlaps, and energy and momentum changed by no more than what the
/// method promises.
class AccuracyWatch {
 public:
  /// `first`: what was seen before a run was taken up again.
  explicit AccuracyWatch(std::optional<Violation> first = std::nullopt)
      : first_(std::move(first)) {}

  /// `force_residual` is that of the forces that are asked for.
  void look(const Simulation& simulation, double force_residual);
  [[nodiscard]] const std::optional<Violation>& first() const { return first_; }
  /// Undecided, with a warning, where a promise was broken.
  [[nodiscard]] ExitCode verdict(Notes& notes) const;

 private:
  std::optional<Violation> first_;
};

}  // namespace wuerfel
