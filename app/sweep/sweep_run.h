/// Running a plan, or a shard of it.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/cli/stop_signal.h"
#include "app/sweep/plan.h"
#include "app/sweep/shard.h"

namespace wuerfel {

struct RunChoice {
  Shard shard;
  int threads = 0;                 ///< 0: one per core
  std::optional<double> budget_s;  ///< of the clock on the wall; begin no case afterwards
  bool retry_failed = false;
};

struct RunReport {
  long made = 0;
  long failed = 0;
  long left = 0;  ///< cases of the shard that nobody has made
};

/// Makes the samples of the shard that are not there yet; `progress` is told how many of how many.
/// Throws UsageError, OutputError and Interrupted; whatever ends it, what was made is kept.
RunReport run_plan(const Plan& plan,
                   const RunChoice& choice,
                   const StopSignal& stop,
                   const std::function<void(long done, long all)>& progress);

/// "I/N" with I from 0, or "*/N" with I counted by GNU parallel. Throws UsageError.
Shard parse_shard(const std::string& text);

/// The shard that Slurm, Open MPI or another engine that started us means, and how it says so.
struct EngineShard {
  Shard shard;
  std::string variable;
};
std::optional<EngineShard> shard_of_engine();

/// "90", "90s", "5m", "3h50m" in seconds. Throws UsageError.
double parse_time_span(const std::string& option, const std::string& text);

}  // namespace wuerfel
