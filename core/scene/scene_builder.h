/// Entries of a scene text -> Scene: names, generators, placement, and the checks that need the
/// whole scene.
#pragma once

#include "core/scene/entries.h"
#include "core/scene/scene.h"

namespace wuerfel {

/// Throws SceneError where the scene has no bodies or too many, names are doubled or unknown, piles
/// do not fit, or bodies overlap.
Scene build_scene(const SceneEntries& entries, const SceneSource& source);

}  // namespace wuerfel
