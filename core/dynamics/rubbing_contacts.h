/// Closed contacts of which some stick or slip: Coulomb's law between events.
///
///     M (a - g) = C' lambda,   R a + c = 0
///
/// R has the normal rows of all contacts, one tangential row for each touch that sticks and the rods; C has
/// the columns of the forces: of slipping contacts J_n - s mu J_t, s the direction of slip, else
/// those of R. Not symmetric where something slips. [Pfeiffer, Glocker 1996]
#pragma once

#include <span>
#include <vector>

#include "core/constraints/islands.h"
#include "core/dynamics/contact_rows.h"

namespace wuerfel {

class RubbingContacts {
 public:
  /// From now on these touches are closed.
  void close(std::span<const Touch> touches);
  /// Whether any of them sticks or slips.
  [[nodiscard]] bool any() const { return any_; }
  /// Whether rows depended on one another in the last solution: forces are then those of least
  /// squares.
  [[nodiscard]] bool redundant() const { return redundant_; }
  /// Whether the last accelerations do not keep all contacts closed, or sticking: they have come to contradict one another.
  [[nodiscard]] bool contradict() const { return contradict_; }

  /// `x`: accelerations, velocities or displacements, three for each cube of the island, whose
  /// contacts are those of the touches; the two latter nearest to those of `state`, or to zero, with
  /// what sticks put back to its anchor. `forces` are the normal ones, one per contact.
  void solve(const System& system,
             const State& state,
             const Island& island,
             Order order,
             std::vector<double>& x,
             std::vector<double>& forces);

  /// Whether a touch that slips pulls by more than `rounding` (N), so that its friction drives it: no force that the law knows
  /// (there may be others where rows depend on one another).
  [[nodiscard]] bool drives(std::span<const double> forces, double rounding) const;
  /// How far touches that stick are from slipping, mu N - T and mu N + T (N), at the solution with
  /// the normal forces `forces`: added to `loads`. Two for each.
  void add_margins(std::span<const double> forces, std::vector<double>& loads) const;
  /// Forces along the sides, N along perp(normal) on the body of the corner, one per contact, at the
  /// solution with the normal forces `forces`. Of a touch that sticks all at its first contact.
  [[nodiscard]] std::vector<double> along_sides(std::span<const double> forces) const;
  /// How fast touches slip, in their direction, m/s: added to `loads`. One for each.
  void add_slips(const System& system,
                 const State& state,
                 std::span<const Contact> contacts,
                 std::vector<double>& loads) const;

 private:
  std::vector<Touch> touches_;
  std::vector<double> tangential_;  ///< N, of those that stick, in order
  bool any_ = false;
  bool redundant_ = false;
  bool contradict_ = false;
};

}  // namespace wuerfel
