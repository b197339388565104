#include "core/time/events/corrections.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

constexpr int most_rounds = 4;
/// Overlap deeper than this share of the smaller side is removed, and gaps of closed contacts.
constexpr double rounding_share = 1e-13;

bool overlaps(const System& system, const Contact& c) {
  return c.gap < -rounding_share * contact_scale(system, c);
}

bool overlaps(const System& system, const Island& island) {
  return std::ranges::any_of(island.contacts,
                             [&](const Contact& c) { return overlaps(system, c); });
}

/// Contacts that overlap at a state and are in none of the islands.
std::vector<Contact> new_overlaps(const State& state,
                                  const std::vector<Contact>& known,
                                  double touching,
                                  Workspace& work) {
  std::vector<ContactId> ids;
  for (const Contact& c : known)
    ids.push_back(c.id());
  std::ranges::sort(ids);
  std::vector<Contact> found;
  work.finder.find(*work.system, state, found, touching);
  std::erase_if(found, [&](const Contact& c) {
    return !overlaps(*work.system, c) || std::ranges::binary_search(ids, c.id());
  });
  return found;
}

}  // namespace

bool all_rest(const Island& island, const std::vector<char>& resting) {
  return std::ranges::all_of(island.cubes, [&](int cube) { return resting[cube] != 0; });
}

void follow(const System& system, const State& state, Island& island) {
  std::vector<Box> boxes;
  pose_boxes(system, state, boxes);
  for (Contact& c : island.contacts)
    c = at_poses(system, boxes, c);
}

OutOfOverlap out_of_overlap(const State& state,
                            const std::vector<Island>& islands,
                            const std::vector<char>& resting,
                            double touching,
                            Workspace& work) {
  const System& system = *work.system;
  OutOfOverlap result;
  std::vector<Island> parts = islands;
  std::vector<Contact> contacts;
  for (const Island& island : islands)
    contacts.insert(contacts.end(), island.contacts.begin(), island.contacts.end());
  for (int round = 0; round < most_rounds; ++round) {
    result.displacements.assign(state.size(), {});
    State moved = state;
    bool any = false;
    for (const Island& part : parts) {
      if (all_rest(part, resting) || !overlaps(system, part)) continue;
      const std::vector<SideUse> use(part.contacts.size(), SideUse::inequality);
      const IslandSolution solution = work.dynamics.correction(state, part, use);
      ++work.solves.solved;
      displace(part, solution.twists, moved);
      for (std::size_t k = 0; k < part.cubes.size(); ++k)
        result.displacements[part.cubes[k]] = solution.twists[k];
      any = true;
    }
    if (!any) return {};
    const std::vector<Contact> more = new_overlaps(moved, contacts, touching, work);
    if (more.empty()) break;
    result.pushed = true;
    contacts.insert(contacts.end(), more.begin(), more.end());
    find_islands(system, contacts, parts);
    for (Island& part : parts)
      follow(system, state, part);
  }
  return result;
}

OntoClosed onto_closed(const Island& island,
                       const State& state,
                       const std::vector<char>& closed,
                       Workspace& work) {
  const System& system = *work.system;
  OntoClosed result;
  if (std::ranges::find(closed, 0) == closed.end()) return result;
  std::vector<SideUse> use;
  bool off = false;
  bool moving = false;
  for (std::size_t k = 0; k < closed.size(); ++k) {
    const Contact& c = island.contacts[k];
    use.push_back(closed[k] != 0 ? SideUse::equality : SideUse::inequality);
    if (closed[k] == 0) continue;
    off = off || std::abs(c.gap) > rounding_share * contact_scale(system, c);
    moving = moving || contact_motion(system, state, c) != ContactMotion::resting;
  }
  Island moved = island;
  State place = state;
  if (off) {
    IslandSolution placed = work.dynamics.correction(state, island, use);
    ++work.solves.solved;
    if (placed.status == QpStatus::optimal) {
      displace(island, placed.twists, place);
      follow(system, place, moved);
      result.displacements = std::move(placed.twists);
    }
  }
  if (moving) {
    IslandSolution slowed = work.dynamics.velocities(place, moved, use);
    ++work.solves.solved;
    if (slowed.status == QpStatus::optimal) result.velocities = std::move(slowed.twists);
  }
  return result;
}

}  // namespace wuerfel
