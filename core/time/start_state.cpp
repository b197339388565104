#include "core/time/start_state.h"

#include <fmt/format.h>

#include "core/dynamics/rod_consistency.h"
#include "core/scene/overlap.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

void require_consistent_rods(const System& system, const State& state) {
  const std::vector<std::string> names = contradicting_rods(system, state);
  if (names.empty()) return;
  throw SceneError(
      fmt::format("rods contradict each other: no acceleration keeps the lengths of \"{}\" at once",
                  fmt::join(names, "\", \"")));
}

State start_state(const Scene& scene) {
  if (const auto overlap = find_overlap(scene)) {
    throw SceneError(overlap_message(scene, *overlap) + "; move one of them");
  }
  return initial_state(scene);
}

}  // namespace wuerfel
