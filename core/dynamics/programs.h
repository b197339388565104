/// The three programs of a step, each a QuadraticProgram over one island:
///
/// - acceleration, Eq. (9): minimise 1/2 sum m_i |a_i - F_i|^2 under (1) and, where (2) = (3) = 0,
///   under (7);
/// - velocity, Moreau's impact law: minimise 1/2 sum m_i |v_i^+ - v_i^-|^2 under (1) and (3);
/// - position, Längenkorrektur: minimise 1/2 sum m_i |d_i|^2 so that rods have their length and no
///   corner is inside.
///
/// With the 1/2 (the print of (9) has none) multipliers are forces. Rows are divided by the length
/// of their rod or side, so that a multiplier is the force itself, in N (N s for impulses), not per
/// metre.
///
/// Unknowns are what the formulation says: all points with all rods as equalities (the paper to the
/// letter), or x, y, theta per cube, where the rods of a cube hold by themselves. Rods between bodies are
/// equalities in both (rod_rows.h). Rows of contacts are those of contact_rows.h.
///
/// [Gauss 1829] [Moreau 1988]
#pragma once

#include <span>
#include <vector>

#include "core/constraints/islands.h"
#include "core/dynamics/contact_rows.h"
#include "core/qp/coulomb/friction_program.h"
#include "core/qp/quadratic_program.h"
#include "core/settings.h"

namespace wuerfel {

/// Motions of cubes as unknowns of the rigid form, x, y, theta each.
std::vector<double> unknowns_of(const std::vector<Twist>& motions);

/// How a contact enters a program.
enum class SideUse { inequality, equality, none };

/// Builds programs over one island. Rows: first the rods of cubes (points formulation), then those between
/// bodies, then the contacts that are used, in the island's order.
class ProgramBuilder {
 public:
  ProgramBuilder(const System& system, Formulation formulation)
      : system_(&system), formulation_(formulation) {}

  // `use` has one entry per contact of the island; empty: all are inequalities.

  /// Eq. (9).
  void acceleration(const State& state, const Island& island, std::span<const SideUse> use = {});
  /// Moreau's impact law.
  void velocity(const State& state, const Island& island, std::span<const SideUse> use = {});
  /// Längenkorrektur: displacements from `state`, nearest to `targets` (one per cube of the island,
  /// m and rad; none: nearest to zero).
  void position(const State& state,
                const Island& island,
                std::span<const SideUse> use = {},
                std::span<const Twist> targets = {});

  /// The program built last, at another state and of any order, in the rigid form: the same island with
  /// its contacts used as before. Nothing but numbers changes.
  void renew(const State& state, const Island& island, Order order);

  /// Adds to the program built last, at the same state and after all other rows, the tangential row of
  /// every contact that is used and rubs (System::surface). `slides` has the known direction of
  /// slip per contact of the island (+1, -1, or 0: free to stick or to slip); empty: all free.
  void add_friction(const State& state, const Island& island, std::span<const int> slides = {});
  /// The contacts of the program with their rows and coefficients, after `add_friction`.
  [[nodiscard]] FrictionProgram friction_program() const { return {program_, friction_}; }
  /// Per contact of the island its number in friction_program(), -1 where it is not used.
  [[nodiscard]] const std::vector<int>& friction_contact() const { return friction_contact_; }

  [[nodiscard]] const QuadraticProgram& program() const { return program_; }
  /// How the contacts of the island enter it.
  [[nodiscard]] const std::vector<SideUse>& use() const { return use_; }
  /// Per block of the program whether it is that of a cube which stands still at `state`, to the bit. Of points none: they are held
  /// together by rods.
  [[nodiscard]] std::vector<char> still_blocks(const State& state, const Island& island) const;
  /// Number of the row of the first rod between bodies; they come in the island's order.
  [[nodiscard]] int first_rod_row() const { return first_rod_row_; }
  /// Number of the row of the first contact: that many rods come before it.
  [[nodiscard]] int first_contact_row() const { return first_contact_row_; }
  /// The solution as one rigid motion per cube of the island.
  [[nodiscard]] std::vector<Twist> twists(const State& state,
                                          const Island& island,
                                          const std::vector<double>& x) const;

 private:
  void build(const State& state,
             const Island& island,
             std::span<const SideUse> use,
             Order order,
             std::span<const Twist> targets = {});
  [[nodiscard]] bool is_point(int cube) const;
  void number_cubes(const Island& island);
  // The rigid form: what stays the same, and the numbers.
  void lay_out(const Island& island);
  void fill(const State& state, const Island& island, Order order, std::span<const Twist> targets);
  // All points.
  void add_points(const State& state, int cube, Order order, const Twist& goal);
  void add_rods(const State& state, int cube, Order order);
  void add_rod(const State& state, const Rod& rod, Order order);
  void add_held_place(const RodEnd& end, const Vec2& g);
  void add_side(const State& state, const Contact& contact, SideUse use, Order order);
  void add_point_entries(const Contact& contact, const SideRow& row);

  const System* system_;
  Formulation formulation_;
  QuadraticProgram program_;
  Order order_ = Order::acceleration;  ///< of the program built last
  std::vector<SideUse> use_;           ///< likewise
  std::vector<FrictionContact> friction_;
  std::vector<int> friction_contact_;
  std::vector<int> local_;        ///< number of a cube within the island
  std::vector<int> first_block_;  ///< of a cube's points; points formulation
  int first_rod_row_ = 0;
  int first_contact_row_ = 0;
};

}  // namespace wuerfel
