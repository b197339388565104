#include "app/commands/statics_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/argument.h"
#include "app/cli/exit_code.h"
#include "app/cli/scene_source.h"
#include "app/cli/shipped_scenes.h"
#include "app/output/statics.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

/// Of more cubes margins take too long to be asked for by the way.
constexpr int most_cubes = 200;

struct MarginName {
  const char* name;
  bool MarginRequest::*asked;
};
constexpr std::array margin_names{
    MarginName{"tilt", &MarginRequest::tilt}, MarginName{"load", &MarginRequest::load},
    MarginName{"shift", &MarginRequest::shift}, MarginName{"move", &MarginRequest::move}};

const MarginName* find_margin(const std::string& name) {
  const auto* found = std::ranges::find(margin_names, name, &MarginName::name);
  return found == margin_names.end() ? nullptr : found;
}

// What is there, or looks like a path.
bool names_scene(const std::string& text) {
  std::error_code ignored;
  return text.find_first_of("./") != std::string::npos || find_shipped_scene(text) != nullptr
         || std::filesystem::exists(text, ignored);
}

// What begins with - is an option, or standard input.
bool names_margins(const std::string& text) {
  const std::vector<std::string> parts = split_list(text);
  return std::ranges::any_of(parts, find_margin) || !(text.starts_with('-') || names_scene(text));
}

MarginRequest parse_margins(const std::string& text) {
  if (text == "all") return {};
  MarginRequest request{false, false, false, false, {}};
  for (const std::string& part : split_list(text)) {
    const MarginName* margin = find_margin(part);
    if (margin == nullptr) {
      throw UsageError(fmt::format("--margin: '{}' is unknown{}", part,
                                   suggestion(part, margin_names, &MarginName::name)));
    }
    request.*(margin->asked) = true;
  }
  return request;
}

std::vector<int> cubes_named(const Scene& scene, const std::vector<std::string>& names) {
  std::vector<int> cubes;
  cubes.reserve(names.size());
  for (const std::string& name : names)
    cubes.push_back(moving_number(scene, "--bodies", name));
  return cubes;
}

}  // namespace

void add_statics_options(Options& options, StaticsRequest& request) {
  options.optional_value(
      "--margin", "tilt,load,shift,move",
      "how nearly it stands or falls: angles, loads, shifts of weights, moves of cubes with what "
      "they carry [all]",
      names_margins, [&request](const std::string& text) { request.margin = parse_margins(text); });
  options.flag("--ranges", "which forces are possible, of contacts and of faces", request.ranges);
  options.single("--bodies", "A,B,..", "margins and ranges of these cubes only",
                 [&request](const std::string& text) { request.bodies = split_list(text); });
}

StaticsAnswer::StaticsAnswer(const Scene& scene,
                             const MotionSettings& settings,
                             const StaticsRequest& request,
                             Verdict verdict,
                             Notes& notes) {
  const std::vector<int> cubes = cubes_named(scene, request.bodies);
  if (!request.any()) {
    if (!cubes.empty()) notes.add("--bodies does nothing without --margin or --ranges");
    return;
  }
  if (verdict == Verdict::moves) {
    notes.add("--margin and --ranges are of scenes in which nothing moves yet: this one moves");
    return;
  }
  still_ = stopped_scene(scene, settings);
  if (request.margin) {
    request_ = *request.margin;
    request_.cubes = cubes;
    if (cubes.empty() && still_->system.cubes > most_cubes) {
      notes.add(fmt::format("margins of {} cubes one by one: name some of them with --bodies",
                            still_->system.cubes));
      request_ = {request_.tilt, false, false, false, {}};
    }
    margins_ = find_margins(*still_, settings, request_);
  }
  if (!request.ranges) return;
  double contacts = 0.0;
  for (const IslandForces& of : still_->found.islands)
    contacts += static_cast<double>(of.island.contacts.size());
  Progress progress(request.style, "ranges of forces", contacts, "contacts");
  ranges_ = find_ranges(*still_, {cubes, true, request.threads, [&](double share) {
                                    progress.reached(std::floor(share * contacts));
                                  }});
}

void StaticsAnswer::add_to(nlohmann::ordered_json& json) const {
  if (margins_) add_margins(*still_, *margins_, request_, json);
  if (ranges_) add_ranges(*still_, *ranges_, json);
}

std::string StaticsAnswer::text() const {
  std::string text;
  if (margins_) text += margins_text(*still_, *margins_, request_);
  if (ranges_) text += ranges_text(*still_, *ranges_);
  return text;
}

}  // namespace wuerfel
