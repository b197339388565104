#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/argument.h"
#include "app/cli/option_groups.h"
#include "app/cli/places.h"
#include "app/commands/commands.h"
#include "app/film/origin.h"
#include "app/film/still.h"
#include "app/output/text_output.h"
#include "core/scene/scene_parser.h"
#include "render/files/file_bytes.h"
#include "render/raster/compare.h"

namespace wuerfel {

namespace {

struct ReproduceOptions {
  std::string picture;
  std::string output;  ///< the picture made again; empty: nowhere
  CompareLimits limits;
  bool json = false;
};

/// A picture that was made before: pixels, or the text of an SVG file.
struct Made {
  std::optional<Image> image;
  std::string svg;
  std::vector<PngText> texts;
};

Made read_made(const std::string& path) {
  if (!has_suffix(path, ".svg")) {
    PngFile file = read_png(path);
    return {std::move(file.image), {}, std::move(file.texts)};
  }
  std::ifstream file = open_to_read(path);
  std::string svg = file_bytes(file, "<");
  std::vector<PngText> texts = read_origin(svg);
  return {std::nullopt, std::move(svg), std::move(texts)};
}

const std::string& text_of(const Made& picture, const char* key, const std::string& path) {
  const auto found = std::ranges::find(picture.texts, key, &PngText::key);
  if (found != picture.texts.end()) return found->value;
  throw UsageError(fmt::format(
      "{}: the text '{}' is missing: only pictures of `run` and `figure` can be made again", path,
      key));
}

// The options that a picture says it was made with.
StillOptions parse_options(const std::string& text, const std::string& path) try {
  StillOptions made_with;
  Options options("", "");
  add_picture_options(options, made_with.picture);
  add_motion_options(options, made_with.motion);
  add_rate_options(options, made_with.rate);
  add_strip_option(options, made_with.strip);
  add_ghosts_option(options, made_with.ghosts);
  options.single("--why", "LANGUAGE", "of `explain`", [&made_with](const std::string& language) {
    made_with.why = parse_choice<Language>("--why", language);
  });
  options.parse_line(text);
  return made_with;
} catch (const UsageError& error) {
  throw UsageError(fmt::format("{}: its options are not understood: {}", path, error.what()));
}

// What a picture says of itself is not drawn where it cannot be right: that would take memory and
// time for nothing.
void require_honest(const Made& picture, const StillOptions& made_with, const std::string& path) {
  const auto [width, height] = made_with.picture.size;
  const auto& image = picture.image;
  if (image && (image->width() != width || image->height() != height)) {
    throw UsageError(fmt::format("{}: it has {}x{} pixels and says that they are {}x{}", path,
                                 image->width(), image->height(), width, height));
  }
  const std::size_t places = made_with.strip ? made_with.strip->columns * made_with.strip->rows : 1;
  if (made_with.times.size() > places || !std::ranges::is_sorted(made_with.times)
      || made_with.times.front() < 0.0)
    throw UsageError(fmt::format("{}: its simulated times make no sense", path));
}

std::string report(const Comparison& comparison,
                   const std::string& sentence,
                   const std::string& made_by,
                   const ReproduceOptions& options) {
  if (!options.json) return sentence + "\n";
  const nlohmann::ordered_json json{{"same", comparison.verdict != CompareVerdict::different},
                                    {"verdict", to_string(comparison.verdict)},
                                    {"made_by", made_by},
                                    {"changed", comparison.changed},
                                    {"share", comparison.share},
                                    {"largest_difference", comparison.largest_difference},
                                    {"worst", {comparison.worst_x, comparison.worst_y}}};
  return json.dump(2) + "\n";
}

/// The first line in which two texts differ, from 1 on; 0: they are equal to the byte, as SVG files are.
long first_difference(std::string_view expected, std::string_view actual) {
  if (expected == actual) return 0;
  const auto at = std::ranges::mismatch(expected, actual).in1;
  return 1 + std::count(expected.begin(), at, '\n');
}

/// The width on paper that an SVG file says it has; 0: none.
double width_on_paper(const std::string& svg) {
  constexpr std::string_view key = " width=\"";
  const std::size_t at = svg.find(key);
  const std::size_t end = svg.find("mm\"", at);
  const std::size_t quote = svg.find('"', at + key.size());
  if (at == std::string::npos || end == std::string::npos || end + 2 != quote) return 0.0;
  return parse_positive("width", svg.substr(at + key.size(), end - at - key.size()));
}

ExitCode reproduce(const ReproduceOptions& options) {
  const Made picture = read_made(options.picture);
  const std::string& made_by = text_of(picture, software_key, options.picture);
  const Scene scene = parse_scene(text_of(picture, scene_key, options.picture), options.picture);
  StillOptions still_options =
      parse_options(text_of(picture, options_key, options.picture), options.picture);
  still_options.times = parse_numbers(time_key, text_of(picture, time_key, options.picture));
  require_honest(picture, still_options, options.picture);
  if (made_by != "wuerfel " WUERFEL_VERSION) {
    Notes().add(
        fmt::format("the picture was made by {}, this is wuerfel {}", made_by, WUERFEL_VERSION));
  }

  const StopSignal stop;
  Font font;
  const Still still = compose_still(scene, still_options, stop, font);
  Comparison comparison;
  std::string sentence;
  if (picture.image) {
    const Image again = draw_still(still);
    if (!options.output.empty()) write_png(options.output, again, still.origin);
    comparison = compare_images(*picture.image, again, options.limits);
    sentence = describe(comparison);
  } else {
    const auto again = encode_still(still, options.picture, still_options.picture.encoder, font,
                                    width_on_paper(picture.svg));
    const std::string text(again.begin(), again.end());
    if (!options.output.empty()) write_text(options.output, text);
    const long line = first_difference(picture.svg, text);
    if (line > 0) comparison.verdict = CompareVerdict::different;
    sentence = line > 0 ? fmt::format("different: first in line {}", line) : describe(comparison);
  }
  write_text("-", report(comparison, sentence, made_by, options));
  return comparison.verdict == CompareVerdict::different ? ExitCode::negative : ExitCode::fine;
}

}  // namespace

Action declare_reproduce(Options& options) {
  auto asked = std::make_shared<ReproduceOptions>();
  options.argument("FRAME", ".png file that `run` or `figure` made, or .svg file of `figure`",
                   asked->picture);
  options.text("-o,--output", "FILE", "the picture made again", asked->output);
  add_compare_limits(options, asked->limits);
  options.flag("--json", "print the answer as JSON", asked->json);
  return [asked](const Stopwatch&) {
    require_no_stdout("-o", asked->output);
    require_kept(asked->picture, asked->output);
    if (!asked->output.empty()) {
      const bool text = has_suffix(asked->picture, ".svg");
      require_suffix("-o", asked->output, text ? ".svg" : ".png");
    }
    return reproduce(*asked);
  };
}

}  // namespace wuerfel
