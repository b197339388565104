#include "tests/benchmark/peers/ratios.h"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

namespace wuerfel::bench {

namespace {

constexpr double least_error = 1e-16;
constexpr double default_tolerance = 1e-8;

using Rows = std::vector<const BenchRow*>;

double error_of(const BenchRow& row) { return std::max(*row.state_error, least_error); }

// Beyond half a cube or half a radian there is nothing to compare: fallen, or passed through.
constexpr double lost = 0.5;

std::string error_text(double error) {
  return error > lost ? std::string("lost") : fmt::format("{:.1e}", error);
}

std::string time_text(double s) {
  return s < 1e-3 ? fmt::format("{:.3g} us", s * 1e6) : fmt::format("{:.3g} ms", s * 1e3);
}

// What the goal is: so much less time at equal error, or so much less error in equal time.
constexpr double time_goal = 10.0;
constexpr double error_goal = 1e4;

/// One scene, one peer.
struct Comparison {
  const BenchRow* best = nullptr;      ///< the peer's most accurate
  const BenchRow* match = nullptr;     ///< the cheapest of ours that is as accurate; may be none
  const BenchRow* rival = nullptr;     ///< the peer's most accurate in the time of `standard`
  const BenchRow* standard = nullptr;  ///< ours at the default tolerance
  std::optional<double> time_ratio;    ///< at equal error
  std::optional<double> error_ratio;   ///< in equal time
};

Comparison compare(const Rows& ours, const Rows& theirs) {
  const auto more_accurate = [](const BenchRow* a, const BenchRow* b) {
    return error_of(*a) < error_of(*b);
  };
  const auto cheaper = [](const BenchRow* a, const BenchRow* b) { return a->cpu < b->cpu; };
  Comparison result;
  result.best = *std::min_element(theirs.begin(), theirs.end(), more_accurate);
  Rows as_good;
  for (const BenchRow* row : ours)
    if (error_of(*row) <= error_of(*result.best)) as_good.push_back(row);
  if (!as_good.empty()) result.match = *std::min_element(as_good.begin(), as_good.end(), cheaper);
  if (result.match != nullptr && *result.best->state_error <= lost)
    result.time_ratio = result.best->cpu / result.match->cpu;
  result.standard = *std::find_if(ours.begin(), ours.end(), [](const BenchRow* row) {
    return row->tolerance == default_tolerance;
  });
  Rows as_cheap;
  for (const BenchRow* row : theirs)
    if (row->cpu <= result.standard->cpu) as_cheap.push_back(row);
  result.rival = as_cheap.empty()
                     ? *std::min_element(theirs.begin(), theirs.end(), cheaper)
                     : *std::min_element(as_cheap.begin(), as_cheap.end(), more_accurate);
  if (*result.rival->state_error <= lost)
    result.error_ratio = error_of(*result.rival) / error_of(*result.standard);
  return result;
}

std::string line(const Comparison& c) {
  std::string text = fmt::format("| {} | {} | {} in {} ({}, {}) |", c.best->scene, c.best->engine,
                                 error_text(*c.best->state_error), time_text(c.best->cpu),
                                 c.best->method, setting_text(*c.best));
  text += c.match == nullptr
              ? std::string(" not as exact |")
              : fmt::format(" {:.1e} in {} |", *c.match->state_error, time_text(c.match->cpu));
  text += c.time_ratio ? fmt::format(" {:.3g} |", *c.time_ratio) : " - |";
  text +=
      fmt::format(" {} in {} | {:.1e} in {} |", error_text(*c.rival->state_error),
                  time_text(c.rival->cpu), *c.standard->state_error, time_text(c.standard->cpu));
  return text + (c.error_ratio ? fmt::format(" {:.0e} |\n", *c.error_ratio) : " - |\n");
}

// A line for a row that reaches neither goal, nothing for others.
std::string why_not(const Comparison& c) {
  if (c.time_ratio.value_or(0.0) >= time_goal || c.error_ratio.value_or(0.0) >= error_goal)
    return {};
  const std::string row = fmt::format("- {}, {}: ", c.best->scene, c.best->engine);
  if (*c.best->state_error > lost)
    return row + "lost at every setting that was run, so there is no error to divide by ours.\n";
  const std::string time =
      c.time_ratio ? fmt::format("{:.3g} times our time", *c.time_ratio) : "we are not as exact";
  if (c.error_ratio)
    return row + fmt::format("{} at equal error, {:.0e} times our error.\n", time, *c.error_ratio);
  return row
         + fmt::format(
             "lost in our time, so there is no ratio of errors; its best, {:.1e}, costs "
             "{}: few steps, far from exact.\n",
             *c.best->state_error, time);
}

// Those that were measured and have an exact answer.
bool counts(const BenchRow& row) { return row.state_error && row.repeats > 0; }

Rows rows_of(const std::vector<BenchRow>& rows,
             const std::string& scene,
             const std::string& engine) {
  Rows found;
  for (const BenchRow& row : rows)
    if (row.scene == scene && row.engine == engine && counts(row)) found.push_back(&row);
  return found;
}

}  // namespace

std::string ratio_table(const std::vector<BenchRow>& rows) {
  std::vector<std::string> scenes;
  std::vector<std::string> engines;
  const auto note = [](std::vector<std::string>& list, const std::string& name) {
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  };
  for (const BenchRow& row : rows) {
    if (!counts(row)) continue;
    note(scenes, row.scene);
    if (row.engine != "wuerfel") note(engines, row.engine);
  }
  std::string text =
      "| scene | peer | its best error | ours, as exact | time ratio at equal error | its error in "
      "our time | ours | error ratio at equal time |\n|---|---|---|---|---|---|---|---|\n";
  std::string reasons;
  for (const std::string& scene : scenes) {
    const Rows ours = rows_of(rows, scene, "wuerfel");
    if (ours.empty()) continue;
    for (const std::string& engine : engines) {
      const Rows theirs = rows_of(rows, scene, engine);
      if (theirs.empty()) continue;
      const Comparison comparison = compare(ours, theirs);
      text += line(comparison);
      reasons += why_not(comparison);
    }
  }
  if (reasons.empty()) return text;
  return text
         + fmt::format(
             "\nRows with neither a time ratio of {:.0f} nor an error ratio of {:.0e}:\n\n",
             time_goal, error_goal)
         + reasons;
}

}  // namespace wuerfel::bench
