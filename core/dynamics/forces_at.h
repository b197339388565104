/// Forces at an instant, a function of a state: what touches, how the cubes accelerate, which forces
/// are shown for it, and whether all of it rests. How the state was reached does not enter, nor what
/// was looked at before: programs are solved from nothing.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/dynamics/forces.h"
#include "core/dynamics/instant_friction.h"
#include "core/dynamics/look_cost.h"

namespace wuerfel {

/// How much of an instant is asked for; each includes those before it.
enum class Detail { contacts, accelerations, forces, uniqueness };

/// Cubes that touch one another, as far as they were asked for.
struct IslandForces {
  Island island;
  std::vector<char> loaded;                ///< per contact: known to carry load
  Detail detail = Detail::contacts;        ///< what of the following is known
  IslandSolution solution;                 ///< of Eq. (9)
  std::optional<IslandFriction> friction;  ///< where something rubs, with the solution
  bool rests = false;                ///< certificate: v = 0, and a = 0 is optimal but for rounding
  std::vector<Twist> accelerations;  ///< m/s^2, rad/s^2, per cube of the island; exactly 0 at rest
  ContactForces forces;              ///< those that are shown
};

struct InstantForces {
  std::vector<IslandForces> islands;
  std::vector<Twist> accelerations;  ///< m/s^2, rad/s^2, per cube; empty until asked for
  bool at_rest = false;              ///< every cube rests with a certificate
  bool solved = true;                ///< no program missed its tolerance
  /// Worst QpResidual::worst() of what is reported: that of the shown forces with the accelerations,
  /// or of the programs where no forces were asked for.
  double residual = 0.0;
  LookCost cost;  ///< of this look
};

/// Looks at one instant after the other. An island whose cubes are where they were and move as they
/// did at the last look keeps its answer, to the bit (Skips::looks).
class ForceFinder {
 public:
  ForceFinder(const System& system, const MotionSettings& settings)
      : system_(&system), settings_(settings) {}

  /// `loaded` are contacts that carried load in a step in which the instant lies. Between the ends of
  /// a step cubes fit each other to the order of the step only, and the terms of their velocities in
  /// (7) may contradict one another: the forces of islands with such contacts are those that carry
  /// the weights of cubes that stand still. Valid until the next call.
  const InstantForces& at(const State& state, Detail detail, std::span<const Contact> loaded = {});

 private:
  [[nodiscard]] bool is_last(const State& state, std::span<const Contact> loaded) const;
  void observe(const State& state, std::span<const Contact> loaded);
  [[nodiscard]] std::vector<IslandForces> find_touching(const State& state,
                                                        std::span<const Contact> loaded);
  [[nodiscard]] bool is_unchanged(const IslandForces& former,
                                  const IslandForces& now,
                                  const State& state) const;
  void find_out(IslandForces& of, Detail detail, IslandDynamics& dynamics);
  void accelerate(IslandForces& of, IslandDynamics& dynamics) const;
  void rub(IslandForces& of, std::span<const SideUse> use) const;
  void choose_forces(IslandForces& of, Uniqueness uniqueness) const;
  void sum_up(Detail detail);

  const System* system_;
  MotionSettings settings_;
  ContactFinder finder_;
  State state_;                    ///< of the last look
  State felt_;                     ///< the same but for velocities that do not count
  double gravity_ = 0.0;           ///< m/s^2, Scales::gravity of the last look
  std::vector<ContactId> loaded_;  ///< of the last look
  InstantForces now_;
};

/// One look alone.
InstantForces forces_at(const System& system,
                        const MotionSettings& settings,
                        const State& state,
                        Detail detail);

/// Cubes that contacts and rods join; free ones, too, or all as one, where `skips` do not leave that out.
std::vector<Island> group_cubes(const System& system,
                                const std::vector<Contact>& contacts,
                                const Skips& skips);

/// Whether the cubes of an island stand perfectly still.
bool stands_still(const Island& island, const State& state);

}  // namespace wuerfel
