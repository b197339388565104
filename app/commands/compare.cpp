#include "render/raster/compare.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <tuple>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/argument.h"
#include "app/cli/is_folder.h"
#include "app/cli/option_groups.h"
#include "app/cli/places.h"
#include "app/commands/commands.h"
#include "app/commands/picture_pairs.h"
#include "app/output/text_output.h"
#include "render/files/output_file.h"
#include "render/files/png.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

struct CompareOptions {
  std::string expected;
  std::string actual;
  std::string output;  ///< where expected, actual and difference go side by side; empty: nowhere
  CompareLimits limits;
  bool json = false;
  bool update = false;  ///< accept what is different
};

/// What came out of one pair.
struct Finding {
  const PicturePair* pair = nullptr;
  std::optional<Comparison> comparison;  ///< none: one of the pictures is missing
  bool updated = false;

  [[nodiscard]] bool same() const {
    return updated || (comparison && comparison->verdict != CompareVerdict::different);
  }
  [[nodiscard]] std::string verdict() const {
    if (!pair->expected_there) return "new";
    if (!pair->actual_there) return "missing";
    return comparison->verdict == CompareVerdict::near_enough
               ? "near_enough"
               : std::string(to_string(comparison->verdict));
  }
  [[nodiscard]] std::string text() const {
    std::string text =
        !pair->expected_there ? "new: there is nothing to compare it with"
        : !pair->actual_there
            ? "missing: only the expected picture is there; if that is right, delete it"
            : describe(*comparison);
    if (updated) text += "; accepted";
    return text;
  }
};

/// EXPECTED becomes a copy of ACTUAL, whole or not at all.
void accept(const PicturePair& pair) {
  std::ifstream source(pair.actual, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(source),
                                std::istreambuf_iterator<char>()};
  OutputFile file(pair.expected);
  file.write({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  file.commit();
}

/// Where the side-by-side picture of a pair goes: the file named, or its place in the folder named.
std::string difference_path(const CompareOptions& options, const PicturePair& pair) {
  if (!std::filesystem::is_directory(options.actual)) return options.output;
  return (std::filesystem::path(options.output) / pair.name).string();
}

Finding judge(const PicturePair& pair, const CompareOptions& options) {
  Finding finding{&pair, std::nullopt, false};
  if (pair.expected_there && pair.actual_there) {
    const Image expected = read_png(pair.expected).image;
    const Image actual = read_png(pair.actual).image;
    finding.comparison = compare_images(expected, actual, options.limits);
    if (!options.output.empty() && finding.comparison->verdict != CompareVerdict::identical) {
      Font font;
      write_png(difference_path(options, pair),
                side_by_side(expected, actual, options.limits, font));
    }
  } else if (pair.actual_there) {
    read_png(pair.actual);  // what is accepted is a picture
  }
  const bool changed =
      !finding.comparison || finding.comparison->verdict != CompareVerdict::identical;
  if (options.update && changed && pair.actual_there) {
    accept(pair);
    finding.updated = true;
  }
  return finding;
}

/// True where `a` is the smaller difference. What is accepted is none, and a picture without a
/// partner is worse than any other.
bool less_bad(const Finding& a, const Finding& b) {
  const auto key = [](const Finding& finding) {
    const bool alone = !finding.comparison;
    const Comparison comparison = finding.comparison.value_or(Comparison{});
    return std::tuple(!finding.same(), alone, !comparison.same_size, comparison.largest_difference,
                      comparison.share);
  };
  return key(a) < key(b);
}

Json finding_json(const Finding& finding) {
  Json json{{"name", finding.pair->name}, {"verdict", finding.verdict()}};
  if (finding.comparison) {
    const Comparison& c = *finding.comparison;
    json.update({{"same_size", c.same_size},
                 {"changed", c.changed},
                 {"share", c.share},
                 {"largest_difference", c.largest_difference},
                 {"worst", {c.worst_x, c.worst_y}},
                 {"box", {c.left, c.top, c.right, c.bottom}}});
  }
  json["accepted"] = finding.updated;
  return json;
}

Json report_json(const std::vector<Finding>& findings,
                 const Finding& worst,
                 const CompareLimits& limits) {
  Json pictures = Json::array();
  for (const Finding& finding : findings)
    pictures.push_back(finding_json(finding));
  const auto different =
      std::ranges::count_if(findings, [](const Finding& finding) { return !finding.same(); });
  return {{"same", different == 0},
          {"compared", findings.size()},
          {"different", different},
          {"worst", worst.verdict() == "identical" ? Json() : Json(worst.pair->name)},
          {"limits",
           {{"max_difference", limits.largest_difference}, {"max_share", limits.largest_share}}},
          {"pictures", std::move(pictures)}};
}

std::string report_text(const std::vector<Finding>& findings, const Finding& worst) {
  if (findings.size() == 1) return worst.text() + "\n";
  std::string text;
  for (const Finding& finding : findings) {
    if (finding.verdict() != "identical")
      text += fmt::format("{}: {}\n", finding.pair->name, finding.text());
  }
  const auto different =
      std::ranges::count_if(findings, [](const Finding& finding) { return !finding.same(); });
  text += fmt::format("{} of {} pictures differ", different, findings.size());
  if (different > 0) text += fmt::format(", most of all {}", worst.pair->name);
  return text + "\n";
}

ExitCode compare(const CompareOptions& options) {
  const std::vector<PicturePair> pairs =
      picture_pairs(options.expected, options.actual, options.update);
  std::vector<Finding> findings;
  findings.reserve(pairs.size());
  for (const PicturePair& pair : pairs)
    findings.push_back(judge(pair, options));
  const Finding& worst = *std::ranges::max_element(findings, less_bad);
  write_text("-", options.json ? report_json(findings, worst, options.limits).dump(2) + "\n"
                               : report_text(findings, worst));
  return std::ranges::all_of(findings, &Finding::same) ? ExitCode::fine : ExitCode::negative;
}

}  // namespace

Action declare_compare(Options& options) {
  auto asked = std::make_shared<CompareOptions>();
  options.argument("EXPECTED", ".png file or folder", asked->expected);
  options.argument("ACTUAL", "the same of what is there now", asked->actual);
  options.text("-o,--output", "DIFF.png",
               "expected, actual and difference side by side, where pixels differ; a folder where "
               "folders are compared",
               asked->output);
  add_compare_limits(options, asked->limits);
  options.flag("--update", "accept: copy ACTUAL over EXPECTED where they differ", asked->update);
  options.flag("--json", "print the answer as JSON", asked->json);
  return [asked](const Stopwatch&) {
    require_no_stdout("-o", asked->output);
    require_kept(asked->expected, asked->output);
    require_kept(asked->actual, asked->output);
    if (!asked->output.empty() && !is_folder(asked->actual))
      require_suffix("-o", asked->output, ".png");
    return compare(*asked);
  };
}

}  // namespace wuerfel
