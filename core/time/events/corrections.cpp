#include "core/time/events/corrections.h"

#include <algorithm>

#include "core/time/stepping/overlap_removal.h"

namespace wuerfel {
namespace {

constexpr int most_rounds = 4;
/// Overlap deeper than this share of the smaller side is removed, and gaps of closed contacts.
constexpr double rounding_share = 1e-13;

/// Gaps count as zero in the search for events up to this many times what rounding leaves of them.
constexpr double rounding_times = 4.0;

/// Contacts that overlap at a state and are none of those that are known.
std::vector<Contact> new_overlaps(const State& state,
                                  const std::vector<Contact>& known,
                                  double touching,
                                  Workspace& work) {
  const std::vector<ContactId> ids = sorted_ids(known);
  std::vector<Contact> found = work.finder.find(*work.system, state, touching);
  std::erase_if(found, [&](const Contact& c) {
    return !overlaps(*work.system, c, rounding_share) || std::ranges::binary_search(ids, c.id());
  });
  return found;
}

}  // namespace

double bearable_overlap(const State& state, const Scales& scales) {
  return std::max(overlap_share, rounding_times * gap_rounding(state) / scales.length);
}

double farthest_way(const System& system, const State& from, const State& to) {
  double way = 0.0;
  for (int i = 0; i < system.cubes; ++i) {
    const Twist moved{to[i].position - from[i].position, to[i].angle - from[i].angle};
    way = std::max(way, fastest_corner(system.body(i), moved));
  }
  return way;
}

OutOfOverlap out_of_overlap(const State& state,
                            const std::vector<Island>& islands,
                            const std::vector<char>& resting,
                            double touching,
                            Workspace& work) {
  const bool fits = std::ranges::none_of(islands, [&](const Island& island) {
    return !all_rest(island, resting) && overlaps(*work.system, island, rounding_share);
  });
  if (fits) return {};
  bool pushed = false;
  std::vector<Contact> contacts;
  std::vector<Island> parts = islands;
  for (const Island& island : islands)
    contacts.insert(contacts.end(), island.contacts.begin(), island.contacts.end());
  const auto find = [&](const Projection& so_far) {
    std::vector<Restricted> restricted;
    if (so_far.rounds > 0) {
      const std::vector<Contact> more = new_overlaps(so_far.state, contacts, touching, work);
      if (more.empty()) return restricted;
      pushed = true;
      contacts.insert(contacts.end(), more.begin(), more.end());
      parts = find_islands(*work.system, contacts);
      for (Island& part : parts)
        follow(*work.system, so_far.state, part.contacts);
    }
    for (const Island& part : parts) {
      if (!all_rest(part, resting))
        restricted.push_back({part, std::vector(part.contacts.size(), SideUse::inequality)});
    }
    return restricted;
  };
  const ProjectionPolicy policy{.overlap = rounding_share, .rounds = most_rounds};
  Projection apart = project_places(*work.system, state, policy, find, work.dynamics);
  work.solves.count(apart.solves);
  return {std::move(apart.state), apart.moved, pushed};
}

void onto_closed(const Island& island,
                 const std::vector<char>& closed,
                 State& state,
                 Workspace& work) {
  if (std::ranges::find(closed, 0) == closed.end()) return;
  Restricted part{island, {}};
  for (const char c : closed)
    part.use.push_back(c != 0 ? SideUse::equality : SideUse::inequality);
  const ProjectionPolicy policy{.gap = rounding_share, .contradiction = Contradiction::leave};
  if (!misses(*work.system, state, part, policy) && rests(*work.system, state, part)) return;
  const auto find = [&](const Projection&) { return std::vector<Restricted>{part}; };
  Projection placed = project_places(*work.system, std::move(state), policy, find, work.dynamics);
  if (placed.moved) follow(*work.system, placed.state, part.island.contacts);
  Projection slowed = project_velocities(*work.system, std::move(placed.state), {part},
                                         Contradiction::leave, work.dynamics);
  work.solves.count(placed.solves);
  work.solves.count(slowed.solves);
  state = std::move(slowed.state);
}

}  // namespace wuerfel
