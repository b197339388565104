#include "core/time/rod_events.h"

#include "core/dynamics/rod_consistency.h"
#include "core/dynamics/rod_rows.h"
#include "core/time/promises.h"

namespace wuerfel {

void add_jam_events(const System& system,
                    const State& before,
                    const State& after,
                    std::span<const int> rods,
                    double t,
                    std::vector<Event>& events) {
  for (const int number : rods) {
    const Rod& rod = system.rods[number];
    if (rod.kind == Rod::Kind::pin_y) continue;  // the other half of its pin_x
    double lost = 0.0;
    for (const int body : {rod.i.body, rod.j.body}) {
      if (body < 0) continue;
      const Vec2 change = after[body].velocity - before[body].velocity;
      lost = std::max(lost, system.body(body).mass * change.norm());
    }
    events.push_back({t, EventKind::jam, end_name(system, rod, rod.i), end_name(system, rod, rod.j),
                      held_place(rod.i, before).p, lost});
  }
}

void note_contradiction(const System& system,
                        std::span<const int> rods,
                        double t,
                        Bookkeeping& book) {
  ++book.audit.rods_contradicting;
  book.breaches.push_back({Promise::rods, t, rod_names(system, rods)});
}

std::vector<std::string> lost_rods(const System& system, const State& state) {
  std::vector<int> lost;
  for (int k = 0; k < std::ssize(system.rods); ++k)
    if (rod_error(system, state, system.rods[k]) > promised_rod_error) lost.push_back(k);
  return rod_names(system, lost);
}

}  // namespace wuerfel
