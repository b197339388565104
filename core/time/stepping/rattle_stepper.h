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
#include "core/model/scales.h"
#include "core/time/bookkeeping.h"
#include "core/time/stepping/overlap_removal.h"
#include "core/time/stepping/step_look.h"

namespace wuerfel {

class RattleStepper {
 public:
  RattleStepper(const System& system, const MotionSettings& settings);

  /// One step of `h` s from a state without overlap at time t. Impacts are booked as events, losses
  /// of energy as theirs. Returns by how much the energy has risen, J (negative: fallen).
  double step(State& state, double t, double h, Bookkeeping& book);
  /// Overlap that the last step left, as a share of the smaller side of the pair: the programs of
  /// wedged cubes may contradict themselves, and a shorter step does better.
  [[nodiscard]] double overlap_left() const { return removal_.left(); }
  /// Local error of the last step as a share of the smallest side: the root mean square, over cubes
  /// that struck nothing, of what their way differs from the trapezoidal rule over their
  /// velocities, which is of third order as the error is.
  [[nodiscard]] double error() const { return error_; }
  /// The last step again, with cubes that overlap at its end stopped short on their way: for those
  /// that no step is short enough for.
  double stop_short(State& state, double t, Bookkeeping& book);

  /// The longest step, s, in which no cube moves by more than half of the thinnest body: nothing
  /// tunnels.
  [[nodiscard]] double longest_step(const State& state) const;

  /// Contacts that carried load in the last step and are still near.
  [[nodiscard]] std::vector<Contact> loaded() const;
  /// Closes gaps of contacts that carried load in the last step, so that what leans on each other
  /// touches. Leaves the state as it is where that is not possible.
  void close_gaps(State& state);

 private:
  struct Pressed {
    Contact contact;
    double impulse = 0.0;  ///< N s, of the position program
  };
  void place(State& state, Bookkeeping& book);
  void place_island(const Island& island, State& state, Bookkeeping& book);
  void bend(const Island& island,
            const std::vector<Twist>& targets,
            const IslandSolution& straight,
            State& state,
            Bookkeeping& book);
  void place_cubes(const Island& island, const IslandSolution& solution, State& state) const;
  void note_pressed(const Island& island, const IslandSolution& solution);
  double arrive(State& state, double t, Bookkeeping& book);
  void hit(State& state, double t, Bookkeeping& book);
  [[nodiscard]] double closing_speed(const Contact& contact) const;
  void estimate_error(const State& state);
  [[nodiscard]] bool is_near(const Contact& contact, double share) const;

  const System* system_;
  IslandDynamics dynamics_;
  OverlapRemoval removal_;
  ClosedContacts closed_;
  ContactFinder finder_;
  Scales scales_;
  double error_ = 0.0;
  double h_ = 0.0;          ///< s, of the step
  State start_;             ///< of the step
  State predicted_;         ///< where free flight would lead
  std::vector<Box> boxes_;  ///< where it is being looked at
  std::vector<Contact> contacts_;
  std::vector<Pressed> pressed_;
  std::vector<Island> islands_;
};

}  // namespace wuerfel
