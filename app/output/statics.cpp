#include "app/output/statics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/output/json_values.h"
#include "app/output/table_text.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

constexpr double knife_edge = 1e-9;

Json pair(const LoadRange& range) { return {number_json(range.low), number_json(range.high)}; }

Json pair_or_none(const LoadRange& range) { return is_empty(range) ? Json(nullptr) : pair(range); }

Json tilt_json(const std::optional<TiltMargin>& tilt) {
  if (!tilt) return nullptr;
  return {{"left", number_json(tilt->left)}, {"right", number_json(tilt->right)}};
}

Json body_json(const BodyMargin& body, const MarginRequest& request) {
  Json json = Json::object();
  if (request.shift && !is_empty(body.shift)) json["shift"] = pair(body.shift);
  if (request.load && !is_empty(body.load)) {
    json["load"] = number_json(body.load.high);
    json["lift"] = number_json(-body.load.low);
  }
  if (request.move && !is_empty(body.move)) json["move"] = pair(body.move);
  return json;
}

// Of a whole scene, with --json as well as for people.
bool has_bodies(const MarginRequest& request) {
  return request.shift || request.load || request.move;
}

std::string with_limit(double value, const char* unit) {
  return std::isfinite(value) ? fmt::format("{:.6g} {}", value + 0.0, unit) : "no limit";
}

/// What is rounding beside `largest` is 0.
std::string span(const LoadRange& range, const char* unit, double largest = 0.0) {
  if (is_empty(range)) return "-";
  const double low = rounded(range.low, largest);
  return fmt::format("{} .. {}", std::isfinite(low) ? fmt::format("{:.6g}", low + 0.0) : "no limit",
                     with_limit(rounded(range.high, largest), unit));
}

std::string degrees(double angle) {
  constexpr double of_radian = 180.0 / std::numbers::pi;
  return std::isfinite(angle) ? fmt::format("{:.4g} degrees", angle * of_radian + 0.0) : "any";
}

std::string tilt_text(const char* how, const std::optional<TiltMargin>& tilt) {
  if (!tilt) return fmt::format("  tilt, {}: at no angle\n", how);
  return fmt::format("  tilt, {}: {} to the left, {} to the right\n", how, degrees(tilt->left),
                     degrees(tilt->right));
}

std::string bodies_text(const StillScene& still, const Margins& margins) {
  std::string text = fmt::format("\n{:<14} {:>26} {:>18} {:>18} {:>26}\n", "cube",
                                 "shift of weight", "load", "lift", "move");
  for (const BodyMargin& body : margins.bodies) {
    const bool loaded = !is_empty(body.load);
    text += fmt::format("{:<14} {:>26} {:>18} {:>18} {:>26}\n", still.system.body(body.cube).name,
                        span(body.shift, "m"), loaded ? with_limit(body.load.high, "N") : "-",
                        loaded ? with_limit(-body.load.low, "N") : "-", span(body.move, "m"));
  }
  return text;
}

std::string smallest_text(const StillScene& still, const Margins& margins) {
  const std::string& name = still.system.body(margins.weakest).name;
  const double share = *margins.smallest;
  if (share < 0.0) {
    return fmt::format(
        "  margin {:.4g}: it would stand if the weight of {} acted {:.4g} of its smaller side "
        "beside the middle\n",
        share, name, -share);
  }
  if (share <= knife_edge)
    return fmt::format("  margin 0: a knife edge, the weight of {} may not shift at all\n", name);
  return fmt::format(
      "  margin {:.4g}: the weight of {} may shift by that share of its smaller side\n", share,
      name);
}

}  // namespace

void add_margins(const StillScene& still,
                 const Margins& margins,
                 const MarginRequest& request,
                 Json& json) {
  Json margin = Json::object();
  if (request.tilt) {
    margin["tilt"] = {{"given", tilt_json(margins.tilt)},
                      {"no_sliding", tilt_json(margins.tilt_no_sliding)},
                      {"unit", "rad"}};
  }
  if (has_bodies(request)) {
    Json bodies = Json::object();
    for (const BodyMargin& body : margins.bodies)
      bodies[still.system.body(body.cube).name] = body_json(body, request);
    margin["bodies"] = std::move(bodies);
  }
  if (request.shift)
    margin["smallest"] = margins.smallest ? Json(*margins.smallest) : Json(nullptr);
  margin["error"] = margins.error;
  if (request.shift) {
    margin["weakest"] =
        margins.weakest < 0 ? Json(nullptr) : Json(still.system.body(margins.weakest).name);
  }
  json["margin"] = std::move(margin);
}

void add_ranges(const StillScene& still, const ForceRanges& ranges, Json& json) {
  for (std::size_t k = 0; k < ranges.contacts.size(); ++k) {
    if (is_empty(ranges.contacts[k])) continue;
    json["contacts"][k]["min"] = number_json(ranges.contacts[k].low);
    json["contacts"][k]["max"] = number_json(ranges.contacts[k].high);
  }
  json["degree"] = ranges.degree;
  Json interfaces = Json::array();
  for (const Interface& face : ranges.interfaces) {
    interfaces.push_back(
        {{"bodies", {still.system.body(face.on).name, still.system.body(face.from).name}},
         {"normal", vector_json(face.normal)},
         {"resultant", {face.force, face.tangential}},
         {"range", pair_or_none(face.force_range)},
         {"center", vector_json(face.center)},
         {"center_range", pair_or_none(face.center_range)},
         {"eccentricity", face.eccentricity ? Json(*face.eccentricity) : Json(nullptr)}});
  }
  json["interfaces"] = std::move(interfaces);
}

std::string margins_text(const StillScene& still,
                         const Margins& margins,
                         const MarginRequest& request) {
  std::string text = still.system.rubs
                         ? "\nmargins (an equilibrium exists up to there; with friction that is "
                           "necessary for standing, not sufficient):\n"
                         : "\nmargins:\n";
  if (request.tilt) {
    text += tilt_text("as given", margins.tilt);
    text += tilt_text("if nothing could slide", margins.tilt_no_sliding);
  }
  if (margins.smallest) text += smallest_text(still, margins);
  if (has_bodies(request)) text += bodies_text(still, margins);
  return text;
}

std::string ranges_text(const StillScene& still, const ForceRanges& ranges) {
  NameColumn on;
  NameColumn from;
  double largest = 0.0;
  for (const Interface& face : ranges.interfaces) {
    on.include(still.system.body(face.on).name);
    from.include(still.system.body(face.from).name);
    largest = std::max(largest, std::abs(face.force));
  }
  std::string text = fmt::format(
      "\nhyperstatic of degree {}\n\n{:<{}} {:<{}} {:>12} {:>24} {:>12} {:>24}\n", ranges.degree,
      "on", on.width(), "from", from.width(), "force / N", "possible", "center / m", "possible");
  for (const Interface& face : ranges.interfaces) {
    const double size = face.middle.norm() + face.length;
    const std::string center =
        face.center ? fmt::format("{:.4g}",
                                  rounded(perp(face.normal).dot(*face.center - face.middle), size))
                    : "-";
    text += fmt::format(
        "{:<{}} {:<{}} {:>12.6g} {:>24} {:>12} {:>24}\n", still.system.body(face.on).name,
        on.width(), still.system.body(face.from).name, from.width(), rounded(face.force, largest),
        span(face.force_range, "N", largest), center, span(face.center_range, "m", size));
  }
  return text;
}

}  // namespace wuerfel
