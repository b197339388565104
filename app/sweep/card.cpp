#include "app/sweep/card.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

const LabelTable::Column& column_of(const LabelTable& labels, const std::string& name) {
  return *std::ranges::find(labels.columns(), name, &LabelTable::Column::name);
}

std::string summary_of_numbers(const std::vector<Json>& cells) {
  std::vector<double> numbers;
  for (const Json& cell : cells)
    if (cell.is_number()) numbers.push_back(cell);
  const auto [low, high] = std::ranges::minmax(numbers);
  const std::size_t gaps = cells.size() - numbers.size();
  return fmt::format("{:.6g} to {:.6g}{}", low, high,
                     gaps > 0 ? fmt::format(", none of {}", gaps) : "");
}

// "falls 12, stands 30"; where there are many, how many.
std::string summary_of_words(const std::vector<Json>& cells) {
  constexpr std::size_t most = 12;
  std::map<std::string, long> counts;
  for (const Json& cell : cells)
    ++counts[cell.is_string() ? cell.get<std::string>() : cell.is_null() ? "none" : cell.dump()];
  if (counts.size() > most) return fmt::format("{} different", counts.size());
  std::string text;
  for (const auto& [word, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", word, count);
  return text;
}

std::string summary(const std::vector<Json>& cells) {
  const bool numbers =
      std::ranges::any_of(cells, [](const Json& c) { return c.is_number(); })
      && std::ranges::all_of(cells, [](const Json& c) { return c.is_number() || c.is_null(); });
  return numbers ? summary_of_numbers(cells) : summary_of_words(cells);
}

std::string column_rows(const LabelTable& labels, const std::string& table) {
  std::string text;
  for (const LabelTable::Column& column : labels.columns()) {
    if (column.table == table)
      text += fmt::format("| `{}` | {} |\n", column.name, summary(column.cells));
  }
  return text;
}

// Verdicts of each split.
std::string split_rows(const LabelTable& labels) {
  std::map<std::string, std::vector<Json>> verdicts;
  const auto& splits = column_of(labels, "split").cells;
  const auto verdict = std::ranges::find(labels.columns(), "verdict", &LabelTable::Column::name);
  for (std::size_t i = 0; i < splits.size(); ++i) {
    std::vector<Json>& list = verdicts[splits[i]];
    list.push_back(verdict == labels.columns().end() ? Json("-") : verdict->cells[i]);
  }
  std::string text;
  for (const auto& [split, list] : verdicts)
    text += fmt::format("| {} | {} | {} |\n", split, list.size(), summary_of_words(list));
  return text;
}

std::string files_text(const SampleFiles& files) {
  std::string text = "- `ID.json`: labels, values, names of the bodies in order, and the scene\n";
  if (files.first_frame) {
    text += fmt::format(
        "- `ID.first.png`: the start, {}x{}; its view is that of the masks and the film\n",
        files.size.width, files.size.height);
  }
  if (files.instance_mask)
    text += "- `ID.instance.png`: grey; number of the cube from 1, 0 is air and ground\n";
  if (files.violation_mask) {
    text +=
        "- `ID.violation.png`: grey; 1 the smallest part that falls by itself, 2 the cubes it "
        "presses "
        "on, 0 all else\n";
  }
  if (files.states) {
    text += fmt::format(
        "- `ID.states.npy`: float64 (times, bodies, 6): x, y, angle, their rates; SI "
        "units, {:g} rows a second from t = 0\n",
        *files.states);
  }
  if (files.video) text += fmt::format("- `ID.mp4`: {:g} frames a second\n", *files.video);
  return text;
}

}  // namespace

std::string card(const Plan& plan, const LabelTable& labels, const DatasetCounts& counts) {
  const Sweep& sweep = plan.sweep();
  std::string text = fmt::format("# {}\n\n", sweep.name);
  if (!sweep.description.empty()) text += sweep.description + "\n\n";
  text += fmt::format(
      "{} samples of falling cubes in the plane, computed by wuerfel {} (sampling {}, seed {}).\n",
      counts.samples, WUERFEL_VERSION, to_string(sweep.sampling), sweep.seed);
  text += fmt::format("License: {}.\n", sweep.license.empty() ? "not given" : sweep.license);
  text += "\n| split | samples | verdicts |\n|---|---|---|\n" + split_rows(labels);
  text += "\n| varies | values |\n|---|---|\n" + column_rows(labels, "values");
  text += "\n| label | values |\n|---|---|\n" + column_rows(labels, "labels");
  text += fmt::format("\n{} candidates were drawn: {}. {} cases failed{}.\n", plan.counts().drawn,
                      describe(plan.counts().rejected), counts.failed,
                      counts.failed > 0 ? " (failed.jsonl)" : "");
  text += "\nEach sample, in the archives `SPLIT-NNNNNN.tar` (WebDataset):\n\n"
          + files_text(sweep.files);
  text +=
      "\n`labels.csv` and `labels.npz` have one row per sample, in the order of "
      "`plan/manifest.jsonl`; "
      "lengths in m, times in s. `sha256sum -c SHA256SUMS` checks the files, `wuerfel sweep verify "
      ".` "
      "makes samples again and compares.\n\n"
      "Made by:\n\n    "
      + plan.making() + "\n    wuerfel sweep run PLAN\n    wuerfel sweep merge PLAN -o DATASET\n";
  return text;
}

}  // namespace wuerfel
