#include "core/dynamics/forces_at.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <set>

#include "core/dynamics/friction.h"
#include "core/model/scales.h"

namespace wuerfel {
namespace {

/// A corner slips that is faster along a side than these shares of max(sqrt(g side), |v|): what
/// rounding leaves, and what the order of a step leaves between its ends.
constexpr double slip_dead_zone = 1e-13;
constexpr double slip_dead_zone_between_steps = 1e-4;

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const Vec2& a, const Vec2& b) {
  return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y());
}

bool same_bits(const BodyState& a, const BodyState& b) {
  return same_bits(a.position, b.position) && same_bits(a.angle, b.angle)
         && same_bits(a.velocity, b.velocity) && same_bits(a.spin, b.spin);
}

std::vector<ContactId> ids(std::span<const Contact> contacts) {
  std::vector<ContactId> result;
  for (const Contact& c : contacts)
    result.push_back(c.id());
  return result;
}

}  // namespace

std::vector<Island> group_cubes(const System& system,
                                const std::vector<Contact>& contacts,
                                const Skips& skips) {
  if (!skips.islands) return {one_island(system, contacts)};
  std::vector<Island> islands = find_islands(system, contacts);
  if (!skips.free_bodies) add_free_cubes(system, islands);
  return islands;
}

bool stands_still(const Island& island, const State& state) {
  return std::ranges::all_of(island.cubes, [&](int cube) { return is_still(state[cube]); });
}

InstantForces forces_at(const System& system,
                        const MotionSettings& settings,
                        const State& state,
                        Detail detail) {
  return ForceFinder(system, settings).at(state, detail);
}

const InstantForces& ForceFinder::at(const State& state,
                                     Detail detail,
                                     std::span<const Contact> loaded) {
  now_.cost = {};
  if (!settings_.skips.looks || !is_last(state, loaded)) observe(state, loaded);
  // What a solver remembers is of this look alone.
  IslandDynamics dynamics(*system_, settings_);
  for (IslandForces& island : now_.islands)
    find_out(island, detail, dynamics);
  sum_up(detail);
  return now_;
}

bool ForceFinder::is_last(const State& state, std::span<const Contact> loaded) const {
  const auto same = [](const BodyState& a, const BodyState& b) { return same_bits(a, b); };
  return !state_.empty() && std::ranges::equal(state, state_, same) && ids(loaded) == loaded_;
}

/// Contacts and islands of a state; contacts that carry load are there whether they touch or not.
std::vector<IslandForces> ForceFinder::find_touching(const State& state,
                                                     std::span<const Contact> loaded) {
  std::vector<Contact> contacts = finder_.find(*system_, state);
  const std::set<ContactId> loads(loaded_.begin(), loaded_.end());
  if (!loaded.empty()) {
    std::set<ContactId> known;
    for (const Contact& c : contacts)
      known.insert(c.id());
    for (const Contact& c : loaded) {
      if (known.insert(c.id()).second) contacts.push_back(at_poses(*system_, finder_.boxes(), c));
    }
  }
  std::vector<Island> islands = group_cubes(*system_, contacts, settings_.skips);
  std::vector<IslandForces> result(islands.size());
  for (std::size_t m = 0; m < islands.size(); ++m) {
    for (const Contact& c : islands[m].contacts)
      result[m].loaded.push_back(loads.contains(c.id()) ? 1 : 0);
    result[m].island = std::move(islands[m]);
  }
  return result;
}

/// Islands that have not changed keep what is known of them.
void ForceFinder::observe(const State& state, std::span<const Contact> loaded) {
  loaded_ = ids(loaded);
  std::vector<IslandForces> found = find_touching(state, loaded);
  std::vector<int> former_of(state.size(), -1);  // by the first cube
  for (std::size_t m = 0; m < now_.islands.size(); ++m)
    former_of[now_.islands[m].island.cubes.front()] = static_cast<int>(m);
  felt_ = state;
  for (IslandForces& of : found) {
    const int former = former_of[of.island.cubes.front()];
    if (settings_.skips.looks && former >= 0 && is_unchanged(now_.islands[former], of, state))
      of = std::move(now_.islands[former]);
    if (std::ranges::find(of.loaded, 1) == of.loaded.end()) continue;
    for (const int cube : of.island.cubes)
      stop(felt_[cube]);
  }
  now_.islands = std::move(found);
  gravity_ = scales_of(*system_, state).gravity;
  state_ = state;
}

bool ForceFinder::is_unchanged(const IslandForces& former,
                               const IslandForces& now,
                               const State& state) const {
  return former.island.cubes == now.island.cubes && former.loaded == now.loaded
         && ids(former.island.contacts) == ids(now.island.contacts)
         && std::ranges::all_of(now.island.cubes,
                                [&](int cube) { return same_bits(state[cube], state_[cube]); });
}

void ForceFinder::find_out(IslandForces& of, Detail detail, IslandDynamics& dynamics) {
  if (detail == Detail::contacts) return;
  if (of.detail >= detail) {
    ++now_.cost.unchanged;
    return;
  }
  if (of.detail == Detail::contacts) {
    accelerate(of, dynamics);
    ++now_.cost.qp_solves;
  }
  of.detail = detail;
  if (detail == Detail::accelerations) return;
  choose_forces(of, detail == Detail::uniqueness ? Uniqueness::asked : Uniqueness::ignored);
  ++now_.cost.force_choices;
}

void ForceFinder::choose_forces(IslandForces& of, Uniqueness uniqueness) const {
  of.forces =
      of.friction
          ? canonical_forces_with_friction(*system_, felt_, of.island, of.friction->slides,
                                           of.accelerations, of.solution, uniqueness)
          : canonical_forces(*system_, felt_, of.island, of.accelerations, of.solution, uniqueness);
}

/// Eq. (9) under the contacts that do not open, or that carry load between steps.
void ForceFinder::accelerate(IslandForces& of, IslandDynamics& dynamics) const {
  std::vector<SideUse> use;
  for (std::size_t k = 0; k < of.island.contacts.size(); ++k) {
    const bool opens =
        contact_motion(*system_, state_, of.island.contacts[k]) == ContactMotion::opening;
    use.push_back(opens && of.loaded[k] == 0 ? SideUse::none : SideUse::inequality);
  }
  if (rubs(*system_, of.island)) return rub(of, use);
  of.solution = dynamics.accelerations(felt_, of.island, use);
  of.rests = stands_still(of.island, state_)
             && accelerations_vanish(*system_, of.island, of.solution, gravity_);
  of.accelerations = of.rests ? std::vector<Twist>(of.island.cubes.size()) : of.solution.twists;
}

/// The same with Coulomb's law. Slips are those of the true velocities; between steps they may have
/// no solution with velocities that are not felt, and are then found from the forces, too.
void ForceFinder::rub(IslandForces& of, std::span<const SideUse> use) const {
  const bool between_steps = std::ranges::find(of.loaded, 1) != of.loaded.end();
  std::vector<int> slides = known_slips(
      *system_, state_, of.island, between_steps ? slip_dead_zone_between_steps : slip_dead_zone);
  const auto solve = [&] {
    const bool still =
        stands_still(of.island, felt_) && std::ranges::count(slides, 0) == std::ssize(slides);
    return accelerations_with_friction(*system_, settings_.formulation, felt_, of.island, use,
                                       slides, still);
  };
  RubbingAccelerations found = solve();
  if (between_steps && found.friction.jams) {
    slides.assign(slides.size(), 0);
    found = solve();
  }
  of.solution = std::move(found.solution);
  of.rests = found.friction.equilibrium && stands_still(of.island, state_);
  of.accelerations = of.solution.twists;
  of.friction = std::move(found.friction);
}

void ForceFinder::sum_up(Detail detail) {
  now_.accelerations.clear();
  now_.at_rest = false;
  now_.solved = true;
  now_.residual = 0.0;
  if (detail == Detail::contacts) return;
  const bool falls = !system_->gravity.isZero(0.0);
  now_.accelerations.assign(state_.size(), {system_->gravity, 0.0});
  now_.at_rest = true;
  std::vector<char> free(state_.size(), 1);
  for (const IslandForces& of : now_.islands) {
    for (std::size_t k = 0; k < of.island.cubes.size(); ++k) {
      free[of.island.cubes[k]] = 0;
      now_.accelerations[of.island.cubes[k]] = of.accelerations[k];
    }
    now_.at_rest = now_.at_rest && of.rests;
    now_.solved = now_.solved && of.solution.status == QpStatus::optimal;
    now_.residual = std::max(
        now_.residual, detail == Detail::accelerations ? of.solution.residual : of.forces.residual);
  }
  for (std::size_t i = 0; i < state_.size(); ++i) {
    if (free[i] == 0) continue;
    ++now_.cost.skipped_free;
    now_.at_rest = now_.at_rest && !falls && is_still(state_[i]);
  }
}

}  // namespace wuerfel
