/// Algorithm 1 of the paper, step by step, with the impact law that it leaves open; and the time
/// stepping of Moreau and Jean, which needs no accelerations.
#pragma once

#include <set>
#include <vector>

#include "core/time/bookkeeping.h"
#include "core/time/moment.h"
#include "core/time/reference/length_correction.h"

namespace wuerfel {

class Stepper {
 public:
  Stepper(const System& system, const MotionSettings& settings);

  /// Contacts of a state that was just reached, and the impacts that they call for.
  void arrive(Moment& moment, Bookkeeping& book);
  /// Contacts of a state that is only looked at: no impacts.
  void observe(Moment& moment, Bookkeeping& book);
  /// Accelerations and forces of a moment; found once.
  void accelerate(Moment& moment, Bookkeeping& book);
  /// Whether every cube rests with a certificate, so that steps change nothing but the time.
  [[nodiscard]] static bool at_rest(const Moment& moment);
  /// One step of `dt` s from a moment that has arrived to the next.
  void step(Moment& moment, double dt, Bookkeeping& book);

 private:
  void integrate(Moment& moment, double dt) const;
  std::vector<Contact> sweep(Moment& moment, double dt, Bookkeeping& book);
  IslandSolution accelerate_island(const std::set<ContactId>& loads,
                                   const Island& island,
                                   Moment& moment);
  void keep_rest(Moment& moment, const Moment& before) const;
  void strike(Moment& moment, const Island& island, Bookkeeping& book);
  [[nodiscard]] std::vector<Contact> pressed_contacts(const Moment& moment) const;
  [[nodiscard]] bool resting(const Moment& moment, const Island& island) const;

  const System* system_;
  MotionSettings settings_;
  IslandDynamics dynamics_;
  LengthCorrection correction_;
  ContactFinder finder_;
};

}  // namespace wuerfel
