#include "core/time/events/opening_test.h"

#include <algorithm>

#include "core/time/events/contact_law.h"

namespace wuerfel {

OpeningTest::OpeningTest(const System& system, const MotionSettings& settings)
    : system_(&system), dynamics_(system, settings) {}

bool OpeningTest::opens(State& state, ClosedContacts& closed, double limit, Bookkeeping& book) {
  closed.project_positions(state);
  closed.project_velocities(state);
  finder_.find(*system_, state, contacts_, ContactLimits{}.touching);
  std::erase_if(contacts_, [&](const Contact& c) {
    if (contact_motion(*system_, state, c) != ContactMotion::resting) return true;
    return std::ranges::none_of(closed.contacts(), [&](const Contact& d) {
      return std::minmax(c.on, c.from) == std::minmax(d.on, d.from);
    });
  });
  find_islands(*system_, contacts_, islands_);
  for (const Island& island : islands_) {
    use_.assign(island.contacts.size(), SideUse::inequality);
    const IslandSolution solution = dynamics_.accelerations(state, island, use_);
    keep_book(solution, book);
    if (std::ranges::max(solution.slacks) > limit) return true;
  }
  return false;
}

}  // namespace wuerfel
