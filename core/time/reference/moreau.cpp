#include "core/time/reference/moreau.h"

#include <algorithm>

#include "core/dynamics/forces_at.h"
#include "core/dynamics/momentum_balance.h"
#include "core/time/reference/active_restrictions.h"
#include "core/time/reference/length_correction.h"

namespace wuerfel {
namespace {

/// What fixed bodies do to an island whose rest was certified earlier: they carry its weight, N and N m.
Push weight_carried(const System& system, const State& state, const Island& island) {
  const Vec2 center = common_center(system, state);
  Push sum;
  for (const int cube : island.cubes) {
    const Vec2 carried = -system.body(cube).mass * system.gravity;
    sum += {carried, det(state[cube].position - center, carried)};
  }
  return sum;
}

/// Accelerations say whether what stands still rests.
void certify_rest(GridPoint& point, Workspace& work, Bookkeeping& book) {
  if (std::ranges::all_of(point.islands,
                          [&](const Island& i) { return stands_still(i, point.state); }))
    accelerate(point, work, book);
}

}  // namespace

void step_by_moreau(GridPoint& point, double dt, Workspace& work, Bookkeeping& book) {
  const System& system = *work.system;
  certify_rest(point, work, book);
  for (std::size_t i = 0; i < point.state.size(); ++i) {
    if (point.resting[i] == 0) point.state[i].velocity += dt * system.gravity;
  }
  std::vector<Contact> pressed;
  for (std::size_t m = 0; m < point.islands.size(); ++m) {
    const Island& island = point.islands[m];
    if (all_rest(island, point.resting)) {
      const bool solved =
          m < point.solutions.size() && point.solutions[m].forces.size() == island.contacts.size();
      point.push += dt
                    * (solved ? push_of(system, point.state, island, point.solutions[m])
                              : weight_carried(system, point.state, island));
      continue;
    }
    const IslandSolution solution = work.dynamics.impact(point.state, island);
    keep_book(solution, book);
    point.push += push_of(system, point.state, island, solution);
    set_velocities(island, solution.twists, point.state);
    add_pressed(island, solution, pressed);
  }
  for (std::size_t i = 0; i < point.state.size(); ++i) {
    if (point.resting[i] != 0) continue;
    point.state[i].position += dt * point.state[i].velocity;
    point.state[i].angle += dt * point.state[i].spin;
  }
  point.push += correct_lengths(point.state, pressed, work, book);
  point.t += dt;
  find_restrictions(point, work, book);
}

}  // namespace wuerfel
