/// Whether redundant contacts open. Their forces are not the only ones: a negative force is no
/// release where other forces would do the same.
#pragma once

#include <vector>

#include "core/dynamics/closed_contacts.h"
#include "core/dynamics/gauss.h"
#include "core/time/bookkeeping.h"

namespace wuerfel {

class OpeningTest {
 public:
  OpeningTest(const System& system, const MotionSettings& settings);

  /// Asks Gauss' program, with the closed contacts as inequalities, whether one of their gaps would
  /// accelerate by more than `limit` (m/s^2). `state` is put on the constraints first.
  bool opens(State& state, ClosedContacts& closed, double limit, Bookkeeping& book);

 private:
  const System* system_;
  IslandDynamics dynamics_;
  ContactFinder finder_;
  std::vector<Contact> contacts_;
  std::vector<Island> islands_;
  std::vector<SideUse> use_;
};

}  // namespace wuerfel
