/// The design of a sweep: which values its candidates have. A function of seed, variable and number
/// alone, so that shards, order and threads don't matter.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/sweep/sweep_file.h"

namespace wuerfel {

class Design {
 public:
  explicit Design(const Sweep& sweep);

  /// How many candidates there are; nothing where there is no end.
  [[nodiscard]] std::optional<long> size() const;
  /// Whether a candidate that is rejected may be drawn anew: strata stay, grids are what they are.
  [[nodiscard]] bool redraws() const { return sweep_.sampling == Sampling::latin; }
  /// One value per variable, as text, of the candidate at the given attempt (from 0).
  [[nodiscard]] std::vector<std::string> values(long candidate, long attempt) const;

 private:
  [[nodiscard]] double position(std::size_t variable, long candidate, long attempt) const;
  [[nodiscard]] std::vector<std::string> grid_values(long candidate) const;

  const Sweep& sweep_;
  std::vector<std::vector<std::string>> lists_;  ///< of a grid
  std::vector<std::vector<long>> strata_;        ///< of a Latin hypercube, by candidate
};

}  // namespace wuerfel
