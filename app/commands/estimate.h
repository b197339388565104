/// What a long run is going to write, before it begins.
#pragma once

#include <string>
#include <vector>

#include "app/commands/run_plan.h"
#include "core/scene/scene.h"

namespace wuerfel {

/// One line on frames and disk space where there are many of them, else nothing: within a factor of
/// two for frames, of six for films.
/// Throws UsageError where not even the least that such outputs take fits into the folders they go
/// to.
std::string estimate(const RunOptions& asked,
                     const Scene& scene,
                     const std::vector<TimetableEntry>& instants);

}  // namespace wuerfel
