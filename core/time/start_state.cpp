#include "core/time/start_state.h"

#include <fmt/format.h>

#include "core/dynamics/rod_consistency.h"
#include "core/scene/overlap.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

void require(const System& system, const RodConsistency& found, std::string_view when) {
  if (found.contradicting.empty()) return;
  throw SceneError(fmt::format(
      "rods contradict each other{}: no acceleration keeps the lengths of \"{}\" at once", when,
      fmt::join(rod_names(system, found.contradicting), "\", \"")));
}

}  // namespace

void require_consistent_rods(const System& system,
                             const State& state,
                             const std::function<std::vector<Twist>()>& accelerations) {
  const RodConsistency now = rod_consistency(system, state);
  require(system, now, "");
  if (!now.redundant) return;
  require(system, rod_consistency_of_start(system, state, accelerations()),
          " as soon as they move");
}

State start_state(const Scene& scene) {
  if (const auto overlap = find_overlap(scene)) {
    throw SceneError(overlap_message(scene, *overlap) + "; move one of them");
  }
  return initial_state(scene);
}

}  // namespace wuerfel
