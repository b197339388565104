// Draws the cases of a plan.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/exit_code.h"
#include "app/output/text_output.h"
#include "app/sweep/design.h"
#include "app/sweep/digest.h"
#include "app/sweep/new_folder.h"
#include "app/sweep/plan.h"
#include "app/sweep/plan_files.h"
#include "app/sweep/statics.h"
#include "core/scene/scene_parser.h"
#include "core/work_in_order.h"

namespace wuerfel {

namespace {

/// Most draws in a row of which none becomes a case: then there are no more.
constexpr long longest_drought = 100'000;
/// Likewise where no draw at all had one of the verdicts that are missing.
constexpr long longest_hope = 10'000;
/// Most draws of one stratum of a Latin hypercube.
constexpr long most_attempts = 1'000;

struct Candidate {
  std::vector<std::string> values;
  std::string id;  ///< empty: it was rejected
  std::optional<Verdict> verdict;
  Rejected rejected;
  long drawn = 0;
};

std::string text_of(const Sweep& sweep, const std::vector<std::string>& values) {
  return fmt::format("{}", fmt::join(overrides_of(sweep, values), ", "));
}

/// Whether the scene of the values becomes a case; judged without knowing of the others.
class Judge {
 public:
  explicit Judge(const Sweep& sweep) : sweep_(sweep), design_(sweep) {}

  [[nodiscard]] const Design& design() const { return design_; }

  [[nodiscard]] Candidate candidate(long number) const {
    Candidate found;
    const long attempts = design_.redraws() ? most_attempts : 1;
    for (long attempt = 0; attempt < attempts && found.id.empty(); ++attempt) {
      found.values = design_.values(number, attempt);
      ++found.drawn;
      judge(found);
    }
    if (found.id.empty() && design_.redraws()) {
      throw UsageError(fmt::format("all {} draws of stratum {} are rejected, the last being {}",
                                   most_attempts, number, text_of(sweep_, found.values)));
    }
    return found;
  }

 private:
  void judge(Candidate& found) const {
    const std::optional<Scene> scene = scene_or_overlap(found.values);
    if (!scene) {
      ++found.rejected.overlapping;
      return;
    }
    Statics statics(*scene);
    if (!sweep_.reject.verdicts.empty() || !sweep_.balance.empty())
      found.verdict = statics.check().verdict;
    if (found.verdict && std::ranges::count(sweep_.reject.verdicts, *found.verdict) > 0) {
      ++found.rejected.verdict;
      return;
    }
    if (is_near_the_edge(statics)) {
      ++found.rejected.margin;
      return;
    }
    found.id = case_id(sweep_, *scene);
  }

  [[nodiscard]] bool is_near_the_edge(Statics& statics) const {
    if (!sweep_.reject.margin_below || !statics.nearest()) return false;
    return std::abs(statics.nearest()->margin) < *sweep_.reject.margin_below;
  }

  [[nodiscard]] std::optional<Scene> scene_or_overlap(
      const std::vector<std::string>& values) const {
    try {
      return scene_of(sweep_, values);
    } catch (const OverlapError&) {
      if (sweep_.reject.overlapping) return std::nullopt;
      throw;
    }
  }

  const Sweep& sweep_;
  Design design_;
};

/// Takes candidates in their order until there are enough.
class Admission {
 public:
  explicit Admission(const Sweep& sweep) : sweep_(sweep), open_(sweep.balance) {}

  [[nodiscard]] bool complete() const { return counts_.cases == sweep_.cases; }
  [[nodiscard]] const PlanCounts& counts() const { return counts_; }

  /// The line of the manifest of a case that is taken; empty: it is not.
  std::string admit(Candidate candidate) {
    if (complete()) return "";
    counts_.drawn += candidate.drawn;
    counts_.rejected.overlapping += candidate.rejected.overlapping;
    counts_.rejected.verdict += candidate.rejected.verdict;
    counts_.rejected.margin += candidate.rejected.margin;
    const bool taken = !candidate.id.empty() && is_wanted(candidate);
    if (candidate.verdict) seen_.insert(*candidate.verdict);
    drought_ = taken ? 0 : drought_ + 1;
    if (drought_ == longest_hope) require_hope();
    if (drought_ == longest_drought) give_up();
    if (!taken) return "";
    Case one{counts_.cases++, std::move(candidate.id), "", std::move(candidate.values)};
    one.split = split_of(sweep_, one);
    ++counts_.splits[one.split];
    return line_of(sweep_, one) + "\n";
  }

 private:
  bool is_wanted(const Candidate& candidate) {
    const auto quota = std::ranges::find_if(
        open_, [&](const Quota& open) { return open.verdict == candidate.verdict; });
    if (!open_.empty() && (quota == open_.end() || quota->cases == 0)) {
      ++counts_.rejected.over_quota;
      return false;
    }
    if (!ids_.insert(candidate.id).second) {
      ++counts_.rejected.duplicate;
      return false;
    }
    if (quota != open_.end()) --quota->cases;
    return true;
  }

  /// Throws where a verdict is missing that no draw has had.
  void require_hope() const {
    for (const Quota& open : open_) {
      if (open.cases == 0 || seen_.contains(open.verdict)) continue;
      throw UsageError(fmt::format(
          "{}: none of {} draws {}; let other values vary, or wider, or ask for no such cases",
          open.origin, counts_.drawn, to_string(open.verdict)));
    }
  }

  [[noreturn]] void give_up() const {
    std::string missing;
    for (const Quota& open : open_)
      if (open.cases > 0) missing += fmt::format("; {} lacks {}", open.origin, open.cases);
    throw UsageError(fmt::format(
        "only {} of {} cases can be found: none of the last {} draws was one (so far {}){}; let "
        "more vary, reject less or ask for fewer",
        counts_.cases, sweep_.cases, longest_drought, describe(counts_.rejected), missing));
  }

  const Sweep& sweep_;
  std::vector<Quota> open_;  // what is still missing
  PlanCounts counts_;
  std::unordered_set<std::string> ids_;
  std::set<Verdict> seen_;
  long drought_ = 0;
};

/// Draws the cases and hands on the lines of the manifest.
PlanCounts draw_cases(const Sweep& sweep,
                      const Workforce& workforce,
                      const std::function<void(const std::string&)>& write,
                      const std::function<void(long cases)>& progress) {
  const Judge judge(sweep);
  Admission admission(sweep);
  const long end = judge.design().size().value_or(std::numeric_limits<long>::max());
  long next = 0;
  std::atomic<bool> enough = false;
  work_in_order(
      workforce, [&] { return next < end && !enough ? std::optional(next++) : std::nullopt; },
      [&](long number) { return judge.candidate(number); },
      [&](Candidate candidate) {
        write(admission.admit(std::move(candidate)));
        progress(admission.counts().cases);
        enough = admission.complete();
      });
  if (admission.counts().cases == 0) throw UsageError("every case is rejected");
  return admission.counts();
}

std::string plan_json(const SweepText& text,
                      const PlanCounts& counts,
                      const std::string& manifest) {
  const Rejected& no = counts.rejected;
  nlohmann::ordered_json json{
      {"format", plan_format},
      {"version", WUERFEL_VERSION},
      {"name", text.sweep.name},
      {"cases", counts.cases},
      {"cases_asked", text.cases ? nlohmann::ordered_json(*text.cases) : nullptr},
      {"drawn", counts.drawn},
      {"rejected",
       {{"overlapping", no.overlapping},
        {"verdict", no.verdict},
        {"margin", no.margin},
        {"over_quota", no.over_quota},
        {"duplicate", no.duplicate}}},
      {"splits", counts.splits},
      {"files",
       {{"sweep", plan_file_name("sweep", text.file.text)},
        {"scene", text.sweep.scene_inline ? "" : plan_file_name("scene", text.sweep.scene.text)}}},
      {"sha256",
       {{"sweep", sha256(text.file.text)},
        {"scene", sha256(text.sweep.scene.text)},
        {"manifest", manifest}}}};
  return json.dump(2) + "\n";
}

}  // namespace

PlanCounts make_plan(const SweepText& text,
                     const std::string& folder,
                     int threads,
                     const StopSignal& stop,
                     const std::function<void(long cases)>& progress) {
  const Workforce workforce{thread_count(threads), [&stop] { stop.check(); }};
  if (folder.empty()) {
    const auto nowhere = [](const std::string&) {};
    return draw_cases(text.sweep, workforce, nowhere, progress);
  }
  NewFolder plan(folder);
  Sha256 digest;
  TextOutput manifest(plan.file(manifest_name));
  const auto write = [&](const std::string& line) {
    digest.add(line);
    manifest.write(line);
  };
  PlanCounts counts = draw_cases(text.sweep, workforce, write, progress);
  manifest.finish();
  write_text(plan.file(plan_file_name("sweep", text.file.text)), text.file.text);
  if (!text.sweep.scene_inline)
    write_text(plan.file(plan_file_name("scene", text.sweep.scene.text)), text.sweep.scene.text);
  write_text(plan.file(plan_name), plan_json(text, counts, digest.hex()));
  plan.commit();
  return counts;
}

}  // namespace wuerfel
