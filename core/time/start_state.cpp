#include "core/time/start_state.h"

#include "core/model/system.h"
#include "core/scene/overlap.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

State start_state(const Scene& scene) {
  if (const auto overlap = find_overlap(scene)) {
    throw SceneError(overlap_message(scene, *overlap) + "; move one of them");
  }
  return initial_state(scene);
}

}  // namespace wuerfel
