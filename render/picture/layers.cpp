#include "render/picture/layers.h"

#include <array>
#include <cstddef>

namespace wuerfel {
namespace {

constexpr std::array<std::string_view, 24> layer_names{
    "cubes",          "rods",   "points",     "sides",      "normals", "forces",
    "contact-forces", "joints", "thrust",     "whiskers",   "weights", "accelerations",
    "mechanism",      "causes", "rod-forces", "velocities", "trails",  "contacts",
    "grid",           "names",  "values",     "symbols",    "hud",     "instances"};

constexpr std::array<std::string_view, 12> legend_names{
    "contact", "friction",  "cut",   "hidden", "several",  "impact",
    "range",   "mechanism", "cause", "above",  "negative", "beyond"};

template <typename Names, typename Enum>
std::string_view name_of(const Names& names, Enum member) {
  const auto i = static_cast<std::size_t>(member);
  return i < names.size() ? names.at(i) : "?";
}

template <typename Names, typename Enum>
std::string list_of(const Names& names, EnumSet<Enum> set) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!set.has(static_cast<Enum>(i))) continue;
    if (!text.empty()) text += ',';
    text += names.at(i);
  }
  return text;
}

}  // namespace

std::string_view to_string(Layer layer) { return name_of(layer_names, layer); }
std::string to_string(Layers layers) { return list_of(layer_names, layers); }
std::string_view to_string(LegendEntry entry) { return name_of(legend_names, entry); }
std::string to_string(Legend legend) { return list_of(legend_names, legend); }

}  // namespace wuerfel
