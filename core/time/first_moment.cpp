#include "core/time/first_moment.h"

#include "core/scene/overlap.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

Moment first_moment(const Scene& scene) {
  if (const auto overlap = find_overlap(scene)) {
    throw SceneError(overlap_message(scene, *overlap) + "; move one of them");
  }
  Moment moment;
  moment.state = initial_state(scene);
  return moment;
}

}  // namespace wuerfel
