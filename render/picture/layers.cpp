#include "render/picture/layers.h"

#include <array>
#include <cstddef>

namespace wuerfel {
namespace {

constexpr std::array<std::string_view, 13> names{
    "cubes",      "rods",   "points",   "sides", "normals", "forces", "rod-forces",
    "velocities", "trails", "contacts", "grid",  "names",   "hud"};

}  // namespace

std::string_view to_string(Layer layer) {
  const auto i = static_cast<std::size_t>(layer);
  return i < names.size() ? names.at(i) : "?";
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
