#include "core/time/reference/length_correction.h"

#include <algorithm>

#include "core/dynamics/momentum_balance.h"
#include "core/dynamics/projection.h"

namespace wuerfel {
namespace {

/// Rounds of corrections: sides stay closed in the first ones; where that does not settle, only
/// overlap is removed.
constexpr int closing_corrections = 12;
constexpr int most_corrections = 40;

bool contains(const std::vector<Contact>& contacts, const Contact& c) {
  return std::ranges::any_of(contacts, [&](const Contact& d) { return d.id() == c.id(); });
}

/// Contacts at a state, closed ones among them.
std::vector<Restricted> restricted(const State& state,
                                   std::vector<Contact>& closed,
                                   double depth,
                                   Workspace& work) {
  const System& system = *work.system;
  std::vector<Contact> contacts = work.finder.find(system, state);
  // A side that was pressed stays closed, unless the corner has left its end: by more than what is pushed out moves along it,
  // else a corner on the seam of two decks ends open over both.
  std::erase_if(closed, [&](Contact& c) {
    c = at_poses(system, work.finder.boxes(), c);
    return std::max(-c.alpha, c.alpha - 1.0) * c.length > depth;
  });
  for (const Contact& c : closed) {
    if (!contains(contacts, c)) contacts.push_back(c);
  }
  std::vector<Restricted> parts;
  for (Island& island : find_islands(system, contacts)) {
    std::vector<SideUse> use;
    for (const Contact& c : island.contacts)
      use.push_back(contains(closed, c) ? SideUse::equality : SideUse::inequality);
    parts.push_back({std::move(island), std::move(use)});
  }
  return parts;
}

Projection onto_lengths(State state, std::vector<Contact> closed, Workspace& work) {
  std::size_t opened = 0;
  std::size_t pushing = 0;
  double depth = 0.0;
  const auto find = [&](const Projection& so_far) {
    for (; opened < so_far.opened.size(); ++opened) {
      std::erase_if(closed, [&](const Contact& c) { return c.id() == so_far.opened[opened].id(); });
    }
    // What was pushed out of an overlap ends closed, not open by the second order of the
    // displacement: else the next moment would not see it touch.
    for (; pushing < so_far.pushing.size(); ++pushing) {
      if (so_far.pushing[pushing].gap >= 0.0) continue;
      closed.push_back(so_far.pushing[pushing]);
      depth = std::max(depth, -so_far.pushing[pushing].gap);
    }
    if (so_far.rounds >= closing_corrections) closed.clear();
    return restricted(so_far.state, closed, depth, work);
  };
  const ProjectionPolicy policy{.overlap = closed_gap,
                                .gap = closed_gap,
                                .rounds = most_corrections,
                                .contradiction = Contradiction::open};
  return project_places(*work.system, std::move(state), policy, find, work.dynamics);
}

}  // namespace

Push correct_lengths(State& state,
                     const std::vector<Contact>& pressed,
                     Workspace& work,
                     Bookkeeping& book) {
  const System& system = *work.system;
  const State before = state;
  Projection placed = onto_lengths(std::move(state), pressed, work);
  keep_book(placed.solves, book);
  std::vector<Restricted> parts;
  for (Island& island : find_islands(system, pressed)) {
    std::vector<SideUse> use(island.contacts.size(), SideUse::equality);
    parts.push_back({std::move(island), std::move(use)});
  }
  Projection slowed = project_velocities(system, std::move(placed.state), parts,
                                         Contradiction::take, work.dynamics);
  keep_book(slowed.solves, book);
  state = std::move(slowed.state);
  const bool fixed = touches_fixed(system, pressed) || std::ranges::any_of(system.rods, is_held);
  Push settled = fixed ? unexplained(system, before, state) : Push{};
  book.settled += settled;
  return settled;
}

}  // namespace wuerfel
