/// Second-order time stepping for crowded scenes: unilateral RATTLE as quadratic programs.
///
///   1. position program: the place nearest to free flight, q + h v + h^2 g / 2, with contact
///   forces
///      along the directions of the step's start (that is what makes the order two),
///   2. clean-up: the nearest place without overlap, with directions of the end,
///   3. velocity program: the velocity nearest to (x - q) / h + h g / 2 that closes no gap.
///
/// After Andersen, "Rattle: a velocity version of the Shake algorithm", J. Comput. Phys. 52 (1983)
/// 24, and Moreau's sweeping process for the inequalities.
#pragma once

#include <vector>

#include "core/dynamics/closed_contacts.h"
#include "core/dynamics/gauss.h"
#include "core/time/bookkeeping.h"
#include "core/time/near_contacts.h"
#include "core/time/scales.h"

namespace wuerfel {

class RattleStepper {
 public:
  RattleStepper(const System& system, const MotionSettings& settings);

  /// One step of `h` s from a state without overlap at time t. Impacts are booked as events, losses
  /// of energy as theirs. Returns by how much the energy has risen, J (negative: fallen).
  double step(State& state, double t, double h, Bookkeeping& book);

  /// Overlap that the last step left, as a share of the smaller side of the pair: where cubes are
  /// wedged its programs may contradict themselves, and a shorter step does better.
  [[nodiscard]] double overlap_left() const { return overlap_left_; }

  /// The longest step, s, in which no cube moves by more than half of the thinnest body: nothing
  /// tunnels.
  [[nodiscard]] double longest_step(const State& state) const;

  /// Closes gaps of contacts that carried load in the last step, so that what leans on each other
  /// touches. Leaves the state as it is where that is not possible.
  void close_gaps(State& state);

 private:
  struct Pressed {
    Contact contact;
    double impulse = 0.0;  ///< N s, of the position program
  };
  void place(State& state, const State& predicted, double h, Bookkeeping& book);
  void place_island(
      const Island& island, const State& predicted, double h, State& state, Bookkeeping& book);
  void close_pressed(State& state, const std::vector<Contact>& found);
  void place_cubes(const Island& island, const IslandSolution& solution, State& state) const;
  void clean_up(State& state, double h, Bookkeeping& book);
  [[nodiscard]] bool overlaps(const std::vector<Box>& boxes, const Contact& c) const;
  void hit(State& state, double t, double h, Bookkeeping& book);
  void log_hits(const Island& island,
                const IslandSolution& solution,
                double t,
                double h,
                Bookkeeping& book) const;

  const System* system_;
  IslandDynamics dynamics_;
  ClosedContacts closed_;
  NearContacts near_;
  ContactFinder finder_;
  Scales scales_;
  double overlap_left_ = 0.0;
  State start_;  ///< of the step
  std::vector<Box> end_boxes_;
  std::vector<Contact> contacts_;
  std::vector<Pressed> pressed_;
  std::vector<Island> islands_;
  std::vector<SideUse> use_;
};

}  // namespace wuerfel
