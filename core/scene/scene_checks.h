/// What is wrong with a scene as a whole; each throws SceneError.
#pragma once

#include "core/scene/entries.h"
#include "core/scene/groups.h"

namespace wuerfel {

/// A text that asks for no bodies, or for more than are allowed.
void check_counts(const SceneEntries& entries, const SceneSource& source);

/// What generators, faces and densities have computed must be as fit for reading as what was
/// written.
void check_ranges(const Scene& scene, const Groups& groups, const SceneSource& source);

/// Bodies that overlap; throws OverlapError.
void check_overlap(const Scene& scene, const Groups& groups, const SceneSource& source);

}  // namespace wuerfel
