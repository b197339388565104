#include "core/time/reference/length_correction.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// Gaps are corrected to this share of the smaller side: well inside touching_tolerance, well above
/// rounding.
constexpr double corrected_gap = 1e-11;
/// Rounds of corrections: sides stay closed in the first ones; where that does not settle, only
/// overlap is removed.
constexpr int closing_corrections = 12;
constexpr int most_corrections = 40;

bool contains(const std::vector<Contact>& contacts, const Contact& c) {
  return std::ranges::any_of(contacts, [&](const Contact& d) { return d.id() == c.id(); });
}

}  // namespace

LengthCorrection::LengthCorrection(const System& system, const MotionSettings& settings)
    : system_(&system), dynamics_(system, settings) {}

void LengthCorrection::correct_positions(State& state,
                                         std::vector<Contact> closed,
                                         Bookkeeping& book) {
  std::vector<Contact> contacts;
  std::vector<Island> islands;
  for (int round = 0; round < most_corrections; ++round) {
    finder_.find(*system_, state, contacts);
    if (round >= closing_corrections) closed.clear();
    // A side that was pressed stays closed, unless the corner has left its end.
    std::erase_if(closed, [&](Contact& c) {
      c = at_poses(*system_, finder_.boxes(), c);
      return c.alpha < 0.0 || c.alpha > 1.0;
    });
    for (const Contact& c : closed) {
      if (!contains(contacts, c)) contacts.push_back(c);
    }
    find_islands(*system_, contacts, islands);
    bool corrected = false;
    for (const Island& island : islands) {
      corrected = correct_island(island, state, closed, book) || corrected;
    }
    if (!corrected) return;
  }
}

bool LengthCorrection::correct_island(const Island& island,
                                      State& state,
                                      std::vector<Contact>& closed,
                                      Bookkeeping& book) {
  std::vector<SideUse> use;
  bool off = false;
  for (const Contact& c : island.contacts) {
    const bool keep = contains(closed, c);
    use.push_back(keep ? SideUse::equality : SideUse::inequality);
    off = off || (keep ? std::abs(c.gap) : -c.gap) > corrected_gap * contact_scale(*system_, c);
  }
  if (!off) return false;
  IslandSolution solution = dynamics_.correction(state, island, use);
  if (solution.status != QpStatus::optimal) {
    // Closed sides contradict one another by the step's error: then only overlap is removed.
    std::erase_if(closed, [&](const Contact& c) { return contains(island.contacts, c); });
    std::ranges::fill(use, SideUse::inequality);
    solution = dynamics_.correction(state, island, use);
  }
  keep_book(solution, book);
  displace(island, solution.twists, state);
  // What was pushed out of an overlap ends closed, not open by the second order of the
  // displacement: else the next moment would not see it touch.
  for (std::size_t k = 0; k < use.size(); ++k) {
    if (use[k] == SideUse::inequality && solution.forces[k] > 0.0 && island.contacts[k].gap < 0.0) {
      closed.push_back(island.contacts[k]);
    }
  }
  return true;
}

void LengthCorrection::correct_velocities(State& state,
                                          const std::vector<Contact>& pressed,
                                          Bookkeeping& book) {
  std::vector<Island> islands;
  find_islands(*system_, pressed, islands);
  for (const Island& island : islands) {
    const bool still = std::ranges::all_of(island.contacts, [&](const Contact& c) {
      return contact_motion(*system_, state, c) == ContactMotion::resting;
    });
    if (still) continue;
    const std::vector<SideUse> along(island.contacts.size(), SideUse::equality);
    const IslandSolution solution = dynamics_.velocities(state, island, along);
    keep_book(solution, book);
    set_velocities(island, solution.twists, state);
  }
}

}  // namespace wuerfel
