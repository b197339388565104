/// `check --margin --ranges --bodies`: what they ask for, and its answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "app/cli/streams.h"
#include "core/statics/margins.h"
#include "core/statics/ranges.h"

namespace wuerfel {

struct StaticsRequest {
  std::optional<MarginRequest> margin;
  bool ranges = false;
  std::vector<std::string> bodies{};  ///< names; empty: all
  int threads = 1;                    ///< that look for ranges
  Progress::Style style = Progress::Style::silent;

  [[nodiscard]] bool any() const { return margin || ranges; }
};

/// --margin, --ranges and --bodies.
void add_statics_options(Options& options, StaticsRequest& request);

/// Of one scene; of none where nothing was asked for, or where something moves, which is noted.
class StaticsAnswer {
 public:
  /// Throws UsageError where there is no body of a name.
  StaticsAnswer(const Scene& scene,
                const MotionSettings& settings,
                const StaticsRequest& request,
                Verdict verdict,
                Notes& notes);

  void add_to(nlohmann::ordered_json& json) const;
  [[nodiscard]] std::string text() const;

 private:
  MarginRequest request_;
  std::optional<StillScene> still_;
  std::optional<Margins> margins_;
  std::optional<ForceRanges> ranges_;
};

}  // namespace wuerfel
