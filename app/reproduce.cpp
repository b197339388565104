#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/option_groups.h"
#include "app/origin.h"
#include "app/still.h"
#include "app/text_output.h"
#include "core/scene/scene_parser.h"
#include "render/error.h"
#include "render/raster/compare.h"

namespace wuerfel {

namespace {

PngFile read_picture(const std::string& path) try {
  return read_png(path);
} catch (const RenderError& error) {
  throw UsageError(error.what());
}

const std::string& text_of(const PngFile& picture, const char* key, const std::string& path) {
  const auto found = std::ranges::find(picture.texts, key, &PngText::key);
  if (found != picture.texts.end()) return found->value;
  throw UsageError(fmt::format(
      "{}: the text '{}' is missing: only pictures of `run` and `figure` can be made again", path,
      key));
}

// The options that a picture says it was made with.
StillOptions parse_options(const std::string& text, const std::string& path) {
  StillOptions options;
  CLI::App parser;
  add_picture_options(parser, options.picture);
  add_motion_options(parser, options.motion);
  add_rate_options(parser, options.trail_rate);
  add_strip_option(parser, options.strip);
  try {
    parser.parse(text, false);
  } catch (const CLI::ParseError& error) {
    throw UsageError(fmt::format("{}: its options are not understood: {}", path, error.what()));
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: its options are not understood: {}", path, error.what()));
  }
  return options;
}

std::string report(const Comparison& comparison,
                   const std::string& made_by,
                   const ReproduceOptions& options) {
  if (!options.json) return describe(comparison) + "\n";
  const nlohmann::ordered_json json{{"same", comparison.verdict != CompareVerdict::different},
                                    {"verdict", to_string(comparison.verdict)},
                                    {"made_by", made_by},
                                    {"changed", comparison.changed},
                                    {"share", comparison.share},
                                    {"largest_difference", comparison.largest_difference},
                                    {"worst", {comparison.worst_x, comparison.worst_y}}};
  return json.dump(2) + "\n";
}

}  // namespace

ExitCode reproduce(const ReproduceOptions& options) {
  const PngFile picture = read_picture(options.picture);
  const std::string& made_by = text_of(picture, software_key, options.picture);
  const Scene scene = parse_scene(text_of(picture, scene_key, options.picture), options.picture);
  StillOptions still_options =
      parse_options(text_of(picture, options_key, options.picture), options.picture);
  still_options.times = parse_numbers(time_key, text_of(picture, time_key, options.picture));
  if (made_by != "wuerfel " WUERFEL_VERSION) {
    fmt::print(stderr, "wuerfel: the picture was made by {}, this is wuerfel {}\n", made_by,
               WUERFEL_VERSION);
  }

  const StopSignal stop;
  Font font;
  const Still still = compose_still(scene, still_options, stop, font);
  const Image again = draw_still(still);
  if (!options.output.empty()) write_png(options.output, again, still.origin);
  const Comparison comparison = compare_images(picture.image, again, options.limits);
  write_text("-", report(comparison, made_by, options));
  return comparison.verdict == CompareVerdict::different ? ExitCode::negative : ExitCode::fine;
}

}  // namespace wuerfel
