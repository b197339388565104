#include "tests/benchmark/peers/ratios.h"

#include <algorithm>

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

std::string line(const std::string& scene, const Rows& ours, const Rows& theirs) {
  const auto more_accurate = [](const BenchRow* a, const BenchRow* b) {
    return error_of(*a) < error_of(*b);
  };
  const auto cheaper = [](const BenchRow* a, const BenchRow* b) { return a->cpu < b->cpu; };
  const BenchRow& best = **std::min_element(theirs.begin(), theirs.end(), more_accurate);
  Rows as_good;
  for (const BenchRow* row : ours)
    if (error_of(*row) <= error_of(best)) as_good.push_back(row);
  std::string text = fmt::format("| {} | {} | {} in {} ({}, {}) |", scene, best.engine,
                                 error_text(*best.state_error), time_text(best.cpu), best.method,
                                 setting_text(best));
  if (as_good.empty()) {
    text += " not as exact | - |";
  } else {
    const BenchRow& match = **std::min_element(as_good.begin(), as_good.end(), cheaper);
    text += fmt::format(
        " {:.1e} in {} | {} |", *match.state_error, time_text(match.cpu),
        *best.state_error > lost ? std::string("-") : fmt::format("{:.3g}", best.cpu / match.cpu));
  }
  const auto standard = std::find_if(ours.begin(), ours.end(), [](const BenchRow* row) {
    return row->tolerance == default_tolerance;
  });
  Rows as_cheap;
  for (const BenchRow* row : theirs)
    if (row->cpu <= (*standard)->cpu) as_cheap.push_back(row);
  const BenchRow& rival = as_cheap.empty()
                              ? **std::min_element(theirs.begin(), theirs.end(), cheaper)
                              : **std::min_element(as_cheap.begin(), as_cheap.end(), more_accurate);
  text += fmt::format(" {} in {} | {:.1e} in {} | {} |\n", error_text(*rival.state_error),
                      time_text(rival.cpu), *(*standard)->state_error, time_text((*standard)->cpu),
                      *rival.state_error > lost
                          ? std::string("-")
                          : fmt::format("{:.0e}", error_of(rival) / error_of(**standard)));
  return text;
}

}  // namespace

std::string ratio_table(const std::vector<BenchRow>& rows) {
  std::vector<std::string> scenes;
  std::vector<std::string> engines;
  const auto note = [](std::vector<std::string>& list, const std::string& name) {
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  };
  for (const BenchRow& row : rows) {
    if (!row.state_error || row.repeats == 0) continue;
    note(scenes, row.scene);
    if (row.engine != "wuerfel") note(engines, row.engine);
  }
  std::string text =
      "| scene | peer | its best error | ours, as exact | time ratio at equal error | its error in "
      "our time | ours | error ratio at equal time |\n|---|---|---|---|---|---|---|---|\n";
  for (const std::string& scene : scenes) {
    Rows ours;
    for (const BenchRow& row : rows)
      if (row.scene == scene && row.engine == "wuerfel" && row.state_error && row.repeats > 0)
        ours.push_back(&row);
    if (ours.empty()) continue;
    for (const std::string& engine : engines) {
      Rows theirs;
      for (const BenchRow& row : rows)
        if (row.scene == scene && row.engine == engine && row.state_error && row.repeats > 0)
          theirs.push_back(&row);
      if (!theirs.empty()) text += line(scene, ours, theirs);
    }
  }
  return text;
}

}  // namespace wuerfel::bench
