/// Placement: `on` and `offset`, resolved along chains.
#pragma once

#include "core/scene/groups.h"

namespace wuerfel {

/// Moves the bodies of all groups that stand somewhere to their places: until now their position is
/// relative to the group's frame (origin in the middle of its lowest edge, or in the centre for a
/// body placed by its centre). Throws SceneError where `on` names no body, one of a pile, or leads
/// back to the group itself.
void place_groups(Scene& scene,
                  const Groups& groups,
                  const BodyNames& names,
                  const SceneSource& source);

}  // namespace wuerfel
