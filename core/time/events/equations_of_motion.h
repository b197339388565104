/// The right-hand side of a smooth phase: accelerations of cubes whose closed contacts and rods are
/// equalities, (7) and (1), and what must stay positive while they are.
#pragma once

#include <vector>

#include "core/dynamics/projection.h"
#include "core/time/events/motion_piece.h"

namespace wuerfel {

/// y' = f(y) of cubes under closed contacts.
class EquationsOfMotion {
 public:
  explicit EquationsOfMotion(const System& system) : contacts_(system) {}

  void close(ContactSet closed, const std::vector<char>& resting);
  void operator()(const std::vector<double>& y, std::vector<double>& rate);
  /// Puts a state on the closed contacts.
  void project(State& state);
  /// What rods join and nothing fixed touches keeps its momenta in t s since `from`, to rounding.
  void keep_momenta(const State& from, double t, State& state) const;

  /// What must stay positive, at the state of the last call: what the closed contacts bear; how far
  /// touches that stick are from slipping; how fast touches slip, from `first_slip` on.
  void find_loads(std::vector<double>& loads) const;
  /// What fixed bodies do to the moving cubes at the state of the last call, N and N m.
  [[nodiscard]] Push pushed() const { return contacts_.pushed(state_); }
  /// Whether a fixed body holds a part, by a closed contact or a rod.
  [[nodiscard]] bool on_fixed() const { return contacts_.on_fixed(); }
  [[nodiscard]] int first_slip(const std::vector<double>& loads) const;
  /// Whether some touch slips, so that friction takes energy.
  [[nodiscard]] bool slips() const { return slips_ > 0; }
  [[nodiscard]] bool rubs() const { return contacts_.rubbing().any(); }
  [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_.contacts(); }
  [[nodiscard]] const std::vector<Touch>& touches() const { return touches_; }
  /// Whether the closed contacts depend on one another, so that their loads are not the only ones.
  [[nodiscard]] bool redundant() const { return contacts_.redundant(); }
  /// Whether no accelerations keep them all as they are.
  [[nodiscard]] bool contradict() const { return rubs() && contacts_.rubbing().contradict(); }
  /// Whether friction gives energy in place of taking some, at the state of the last call: something that slips pulls by more
  /// than `rounding`, N.
  [[nodiscard]] bool friction_drives(double rounding) const {
    return slips() && contacts_.rubbing().drives(contacts_.forces(), rounding);
  }
  /// Whether nothing holds any cube: neither a contact nor a rod.
  [[nodiscard]] bool free() const { return contacts_.none(); }

 private:
  ClosedContacts contacts_;
  std::vector<Touch> touches_;
  std::vector<std::vector<int>> flying_;
  int slips_ = 0;              ///< touches that slip
  State state_;                ///< scratch of a call
  std::vector<Twist> twists_;  ///< likewise
};

}  // namespace wuerfel
