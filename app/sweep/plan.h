/// The plan of a sweep: a folder with the sweep file, its scene, and a manifest of all cases, drawn
/// once so that nobody who runs a part of it needs to know of the others.
#pragma once

#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "app/cli/stop_signal.h"
#include "app/sweep/case.h"
#include "app/sweep/sweep_file.h"

namespace wuerfel {

/// Candidates that did not become cases, by the reason.
struct Rejected {
  long overlapping = 0;
  long verdict = 0;     ///< one of those that are rejected
  long margin = 0;      ///< nearer to the edge than wanted
  long over_quota = 0;  ///< there were enough of that verdict
  long duplicate = 0;   ///< the scene of an earlier case
};

/// "3 overlapped, 0 had a verdict that is rejected, ..."
std::string describe(const Rejected& rejected);

struct PlanCounts {
  long cases = 0;
  long drawn = 0;
  Rejected rejected;
  std::map<std::string, long> splits;
};

/// The files of a sweep.
struct SweepText {
  explicit SweepText(SceneText sweep_file,
                     const std::optional<SceneText>& scene = {},
                     std::optional<long> cases_asked = {});

  SceneText file;
  std::optional<long> cases;  ///< asked for beside the file
  Sweep sweep;
};

/// Draws the cases and writes the folder, unless its name is empty; `progress` is told how many
/// there are. Throws SceneError where a scene of the template is none, UsageError where the cases
/// run out, OutputError and Interrupted.
PlanCounts make_plan(const SweepText& text,
                     const std::string& folder,
                     int threads,
                     const StopSignal& stop,
                     const std::function<void(long cases)>& progress);

/// A plan that was made.
class Plan {
 public:
  /// Throws UsageError where the folder holds no whole plan of this version of the program.
  explicit Plan(std::string folder);

  [[nodiscard]] const std::string& folder() const { return folder_; }
  [[nodiscard]] const Sweep& sweep() const { return text_->sweep; }
  /// The command that makes the plan again of its own files.
  [[nodiscard]] std::string making() const;
  [[nodiscard]] const PlanCounts& counts() const { return counts_; }
  [[nodiscard]] long cases() const { return counts_.cases; }
  /// Hash of all of it: names the plan.
  [[nodiscard]] const std::string& hash() const { return hash_; }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }
  /// Names of its files but for what was made of it.
  [[nodiscard]] std::vector<std::string> files() const;

 private:
  std::string folder_;
  std::optional<SweepText> text_;
  PlanCounts counts_;
  std::string hash_;
  std::string sweep_file_;
  std::string scene_file_;
};

/// The cases of a plan one by one, in order.
class Manifest {
 public:
  explicit Manifest(const Plan& plan);
  std::optional<Case> next();

 private:
  const Plan& plan_;
  std::ifstream file_;
};

/// So many cases of a plan, evenly spread; all where it has no more.
std::vector<Case> spread_cases(const Plan& plan, long wanted);

}  // namespace wuerfel
