/// Smooth motion: a set of contacts that stay closed, and rods. Their sides are equalities, so accelerations
/// follow from one linear system, not from a search, and are smooth functions of the state.
#pragma once

#include <vector>

#include "core/dynamics/programs.h"
#include "core/dynamics/push.h"
#include "core/dynamics/rubbing_contacts.h"
#include "core/qp/methods/equality_solver.h"

namespace wuerfel {

/// Equations of motion  M a = M g + J' lambda,  J a + c = 0  of cubes with closed contacts; rows
/// are those of Eq. (7), pulled back. Cubes at rest (certified) neither move nor enter. Always in
/// the rigid form.
class ClosedContacts {
 public:
  explicit ClosedContacts(const System& system);

  /// From now on these contacts are closed. `resting`, one per cube, names the cubes that stay
  /// where they are; no contact and no rod may join them to cubes that move. `touches`: those of the contacts,
  /// with what they do along their sides; not needed where nothing rubs.
  void close(const std::vector<Contact>& contacts,
             const std::vector<char>& resting,
             std::span<const Touch> touches = {});

  [[nodiscard]] const System& system() const { return *system_; }
  [[nodiscard]] const std::vector<Contact>& contacts() const { return island_.contacts; }
  /// The cubes that they restrict, ascending.
  [[nodiscard]] const std::vector<int>& cubes() const { return island_.cubes; }
  /// Whether nothing holds any cube: neither a contact nor a rod.
  [[nodiscard]] bool none() const { return island_.contacts.empty() && island_.rods.empty(); }
  /// Whether a fixed body holds a part, by one of the contacts or a rod (but for a pendulum, which is exact).
  [[nodiscard]] bool on_fixed() const { return on_fixed_; }
  /// Whether some of the contacts depend on others, so that their forces are not the only ones.
  [[nodiscard]] bool redundant() const {
    if (rubbing_.any()) return rubbing_.redundant();
    return !none() && !hangs_alone_ && solver_.dependent_rows() > 0;
  }

  /// Accelerations of all cubes (m/s^2, rad/s^2). Afterwards `contacts` are those at `state`, and
  /// `forces` theirs.
  void accelerate(const State& state, std::vector<Twist>& accelerations);
  /// Forces (N) found by the last `accelerate`; they may be negative: then the contact pulls.
  [[nodiscard]] const std::vector<double>& forces() const { return forces_; }
  /// Contacts that rub, with the forces of the last `accelerate` along their sides.
  [[nodiscard]] const RubbingContacts& rubbing() const { return rubbing_; }

  /// What fixed bodies do to the moving cubes, by the forces of the last `accelerate` at `state`.
  [[nodiscard]] Push pushed(const State& state) const;

  /// (x, y, theta) per cube of `cubes`: the least displacements (in the mass metric) that close the
  /// gaps to first order, the velocities nearest to those of `state` that keep them, or the
  /// accelerations.
  const std::vector<double>& nearest(const State& state, Order order);

 private:
  [[nodiscard]] Push felt(const State& state, const Vec2& center) const;
  [[nodiscard]] bool moves(const RodEnd& end) const;
  bool pose(const State& state);
  void move_on_rod(const State& state, Order order);
  void find_rows(const State& state, bool moved, Order order);

  const System* system_;
  ProgramBuilder builder_;
  EqualitySolver solver_;
  RubbingContacts rubbing_;
  Island island_;
  std::vector<char> resting_;
  bool on_fixed_ = false;     ///< a contact or a rod is with a fixed body
  bool held_ = false;         ///< a rod or pin holds a cube to one
  bool hangs_alone_ = false;  ///< one rod, held at its other end, is all that holds one cube
  bool laid_out_ = false;     ///< the builder has a program over `island_`
  std::vector<Box> boxes_;
  std::vector<double> angles_;  ///< rad, per cube of the island, of its box; empty: not posed yet
  std::vector<double> x_;
  std::vector<double> multipliers_;  ///< rods first
  std::vector<double> forces_;
};

}  // namespace wuerfel
