/// What a run is told, and what it has to do: worked out from the command line and the scene before
/// anything is done.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/film/picture_options.h"
#include "app/film/timetable.h"
#include "core/scene/scene.h"
#include "core/settings.h"
#include "core/time/simulation.h"

namespace wuerfel {

struct RunOptions {
  std::vector<std::string> scenes;     ///< where they come from
  std::vector<std::string> overrides;  ///< key=value
  MotionSettings motion;
  PictureOptions picture;
  FrameRate rate;
  std::optional<double> until;       ///< s; none: the scene's duration
  std::vector<double> samples;       ///< s
  std::vector<std::string> outputs;  ///< folders and films
  std::optional<double> hold;        ///< s, for which films show their last frame
  std::string states;                ///< file names, empty: not wanted, `-`: standard output
  std::string forces;
  std::string events;
  std::string summary;
  std::string failed_programs;
  std::string checkpoint;       ///< file; empty: none
  std::optional<double> every;  ///< s, from one checkpoint to the next
  std::string resume;           ///< file; empty: from the start
  bool strict = false;          ///< stop at the first violation
  bool json = false;
  bool quiet = false;
  int threads = 0;  ///< for several scenes; 0: one per core

  [[nodiscard]] bool tables() const { return !states.empty() || !forces.empty(); }
  /// Names of all files and folders that are asked for.
  [[nodiscard]] std::vector<std::string> files() const;
};

/// Throws UsageError where two things have to go to one place, or one to that of a scene.
void require_distinct_outputs(const RunOptions& asked);

struct RunPlan {
  double end = 0.0;         ///< s
  SnapshotRequest request;  ///< what to look at
  LookBack back;            ///< how far back pictures look
};

/// Throws UsageError where the options do not fit the scene.
RunPlan make_plan(const RunOptions& asked, const Scene& scene);

/// When to look. Takes seconds for millions of frames.
std::vector<TimetableEntry> instants_of(const RunOptions& asked, const RunPlan& plan);

}  // namespace wuerfel
