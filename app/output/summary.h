/// The summary of a run as JSON: the keys are part of the contract with users.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/cli/streams.h"
#include "app/output/accuracy.h"
#include "app/output/text_output.h"
#include "core/scene/scene.h"
#include "core/settings.h"
#include "core/time/simulation.h"

namespace wuerfel {

/// The state at a time that --sample asked for.
struct StateSample {
  double t = 0.0;  ///< s, exactly as asked
  State states;
};

/// What a run cost besides what the simulation counts itself.
struct RunCost {
  double wall_s = 0.0;   ///< from the first step to the last file, drawing and encoding included
  double cpu_s = 0.0;    ///< the same in processor time, ffmpeg included
  double start_s = 0.0;  ///< from the start of the program to the first step
  long frames = 0;
  long frames_reused = 0;  ///< written again without being drawn again
};

nlohmann::ordered_json run_summary(const Scene& scene,
                                   const MotionSettings& settings,
                                   const Simulation& simulation,
                                   const std::vector<StateSample>& samples,
                                   const Notes& notes,
                                   const RunCost& cost);

nlohmann::ordered_json violation_json(const Violation& violation);

/// The file for the summary, if one is wanted.
class SummaryFile {
 public:
  /// Throws OutputError at once where the file cannot be written; no file where the name is empty.
  explicit SummaryFile(const std::string& name);
  /// Throws OutputError.
  void write(const std::string& text);

 private:
  std::optional<TextOutput> file_;
};

/// One event as it stands in the summary and in the lines of --events.
nlohmann::ordered_json event_json(const Event& event);

}  // namespace wuerfel
