#include "core/time/stepping/close_gaps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/dynamics/momentum.h"
#include "core/time/stepping/stride.h"

namespace wuerfel {
namespace {

/// Gaps of up to this share of the smaller side may be closed.
constexpr double closable_share = 1e-4;
constexpr int closings = 3;

/// The contacts as they are at a state, near ones of them.
std::vector<Contact> near_contacts(const System& system,
                                   const State& state,
                                   std::vector<Contact> contacts) {
  follow(system, state, contacts);
  std::erase_if(contacts, [&](const Contact& c) { return !is_near(system, c, closable_share); });
  return contacts;
}

/// Whether nothing overlaps and the contacts are closed.
bool fits(const System& system,
          const State& state,
          const std::vector<Contact>& contacts,
          ContactFinder& finder) {
  finder.find(system, state, 0.0);
  if (finder.deepest().depth > closed_gap * finder.deepest().scale) return false;
  return std::ranges::all_of(contacts, [&](const Contact& c) {
    return std::abs(gap_at_poses(system, finder.boxes(), c))
           <= closed_gap * contact_scale(system, c);
  });
}

}  // namespace

void close_gaps(const std::vector<Contact>& loaded,
                ClosedContacts& closed,
                ContactFinder& finder,
                State& state) {
  const System& system = closed.system();
  const std::vector<Contact> near = near_contacts(system, state, loaded);
  closed.close(near, {});
  State next = state;
  for (int k = 0; k < closings; ++k)
    project_places(closed, next);
  keep_turning(system, near, state, next);
  if (!fits(system, next, closed.contacts(), finder)) return;
  // What the cubes were lifted by costs motion.
  std::vector<int> cubes(state.size());
  std::iota(cubes.begin(), cubes.end(), 0);
  std::vector<Vec2> fixed_normals;
  for (const Contact& c : closed.contacts()) {
    if (!(system.is_cube(c.on) && system.is_cube(c.from))) fixed_normals.push_back(c.normal);
  }
  const RigidMotion kept = kept_motion(momentum_of(system, next, cubes), fixed_normals);
  const double goal = std::min(energy(system, state), energy(system, next));
  scale_to_energy(system, cubes, kept, goal, 1.0, next);
  state = std::move(next);
}

}  // namespace wuerfel
