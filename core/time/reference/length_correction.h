/// "Eventuell Längenkorrektur": what a step of Algorithm 1 leaves open. Corners are moved out of
/// sides, and sides that carried load stay closed.
#pragma once

#include <vector>

#include "core/dynamics/gauss.h"
#include "core/time/bookkeeping.h"

namespace wuerfel {

class LengthCorrection {
 public:
  LengthCorrection(const System& system, const MotionSettings& settings);

  /// Moves the cubes by the least that removes overlap and keeps the contacts in `closed` closed.
  void correct_positions(State& state, std::vector<Contact> closed, Bookkeeping& book);
  /// Changes velocities by the least that makes the gap rates of the contacts in `pressed` zero.
  void correct_velocities(State& state, const std::vector<Contact>& pressed, Bookkeeping& book);

 private:
  bool correct_island(const Island& island,
                      State& state,
                      std::vector<Contact>& closed,
                      Bookkeeping& book);

  const System* system_;
  IslandDynamics dynamics_;
  ContactFinder finder_;
};

}  // namespace wuerfel
