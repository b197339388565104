/// What happens at an event: what touches, who hits whom, and which contacts are closed afterwards.
#pragma once

#include <vector>

#include "core/dynamics/gauss.h"
#include "core/model/scales.h"
#include "core/time/bookkeeping.h"

namespace wuerfel {

/// Contacts of the smooth phase that follows an event.
struct Closure {
  std::vector<Contact> closed;  ///< of cubes that move; a flush pair by both corners of one side
  std::vector<char> resting;    ///< per cube: certified, v = 0 and a = 0
  /// No accelerations keep the contacts closed: cubes turn in a place that fits them exactly. Only
  /// positions know what happens next.
  bool wedged = false;
};

/// What counts as touching and as still when the law is applied.
struct ContactLimits {
  double touching = 1e-10;   ///< share of the smaller side up to which bodies touch
  double rest_speed = 1e-9;  ///< share of V below which cubes rest where their forces balance
};

/// Moreau's impact over all touching contacts of an island at once, then Gauss' principle for the
/// contacts that do not open. Where a force and the gap's acceleration both vanish (the instant of
/// a release), the program is asked again a moment later, where one of them has a sign.
class ContactLaw {
 public:
  ContactLaw(const System& system, const MotionSettings& settings);

  /// Changes velocities (impacts) and, by rounding, positions (overlap). `closure` is that of the
  /// phase that ends, and becomes that of the phase that begins.
  void apply(
      State& state, double t, const ContactLimits& limits, Closure& closure, Bookkeeping& book);

 private:
  void apply_island(Island& island, State& state, double t, Closure& closure, Bookkeeping& book);
  void separate(State& state, const std::vector<char>& resting, Bookkeeping& book);
  bool add_overlapping(const State& state);
  [[nodiscard]] bool overlaps(const Contact& c) const;
  void strike(const Island& island, State& state, double t, Bookkeeping& book);
  IslandSolution settle_contacts(const Island& island,
                                 const State& state,
                                 bool after_impact,
                                 Bookkeeping& book);
  bool comes_to_rest(const Island& island, State& state, Bookkeeping& book);
  IslandSolution peek(const Island& island,
                      const State& state,
                      const IslandSolution& now,
                      std::span<const SideUse> use,
                      Bookkeeping& book);
  void find_closed(const Island& island, const IslandSolution& solution);
  void settle_on_closed(Island& island, State& state, Bookkeeping& book);
  void follow(Island& island, const State& state) const;
  void close(const Island& island, Closure& closure) const;

  const System* system_;
  Skips skips_;
  IslandDynamics dynamics_;
  ContactFinder finder_;
  Scales scales_;
  ContactLimits limits_;
  std::vector<Contact> contacts_;
  std::vector<Contact> found_;
  std::vector<Island> islands_;
  std::vector<SideUse> use_;
  std::vector<SideUse> closed_;  ///< per contact of an island: equality where it stays closed
};

}  // namespace wuerfel
