/// What a run has to do, worked out from the command line and the scene before anything is done.
#pragma once

#include <vector>

#include "app/commands/commands.h"
#include "app/film/timetable.h"
#include "core/scene/scene.h"
#include "core/time/simulation.h"

namespace wuerfel {

struct RunPlan {
  double end = 0.0;               ///< s
  std::vector<Instant> instants;  ///< when to look
  SnapshotRequest request;        ///< and at what
};

/// Throws UsageError where the options do not fit the scene.
RunPlan make_plan(const RunOptions& options, const Scene& scene);

}  // namespace wuerfel
