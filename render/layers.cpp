#include "render/layers.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "render/error.h"
#include "render/nearest_name.h"

namespace wuerfel {
namespace {

constexpr std::array<std::string_view, 13> names{
    "cubes",      "rods",   "points",   "sides", "normals", "forces", "rod-forces",
    "velocities", "trails", "contacts", "grid",  "names",   "hud"};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::string_view to_string(Layer layer) {
  const auto i = static_cast<std::size_t>(layer);
  return i < names.size() ? names.at(i) : "?";
}

Layers parse_layers(std::string_view text) {
  Layers layers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view name = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    if (name.empty()) continue;
    const auto* const found = std::ranges::find(names, name);
    if (found == names.end()) {
      throw RenderError("unknown layer '" + std::string(name) + "'"
                        + nearest_name_hint(name, names));
    }
    layers.insert(static_cast<Layer>(found - names.begin()));
  }
  return layers;
}

std::string to_string(Layers layers) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!layers.has(static_cast<Layer>(i))) continue;
    if (!text.empty()) text += ',';
    text += names.at(i);
  }
  return text;
}

}  // namespace wuerfel
