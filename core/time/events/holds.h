/// Contact forces as functions whose zeros are releases.
#pragma once

#include <array>
#include <vector>

#include "core/dynamics/closed_contacts.h"

namespace wuerfel {

/// The forces that hold a set of closed contacts: of a contact its own, of a flush pair those at
/// the two ends of the overlap. A force that starts at zero is watched, with a small addition,
/// until it has left zero.
class Holds {
 public:
  explicit Holds(const System& system) : system_(&system) {}

  /// A smooth phase begins with the forces that `closed` has found. Below `zero` (N) a force counts
  /// as zero.
  void begin(const ClosedContacts& closed, double zero);
  /// The smallest of the forces that `closed` has found last; infinite where there is none.
  [[nodiscard]] double smallest(const ClosedContacts& closed) const;
  /// Forces that have left zero are watched from now on as they are.
  void arm(const ClosedContacts& closed);
  [[nodiscard]] bool empty() const { return holds_.empty(); }

 private:
  /// Rows of a flush pair, or one row (second = -1).
  struct Hold {
    int first = 0;
    int second = -1;
    std::array<double, 2> offset{};
  };
  [[nodiscard]] static std::array<double, 2> forces(const ClosedContacts& closed, const Hold& hold);

  const System* system_;
  std::vector<Hold> holds_;
  double zero_ = 0.0;
};

}  // namespace wuerfel
