#include "core/scene/color.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace wuerfel {
namespace {

constexpr std::array<NamedColor, 8> palette{{
    {"black", {0, 0, 0}},
    {"orange", {230, 159, 0}},
    {"sky blue", {86, 180, 233}},
    {"bluish green", {0, 158, 115}},
    {"yellow", {240, 228, 66}},
    {"blue", {0, 114, 178}},
    {"vermillion", {213, 94, 0}},
    {"reddish purple", {204, 121, 167}},
}};

}  // namespace

std::span<const NamedColor> okabe_ito() { return palette; }

std::optional<Rgb> parse_color(std::string_view text) {
  const auto named = std::find_if(palette.begin(), palette.end(),
                                  [&](const NamedColor& color) { return color.name == text; });
  if (named != palette.end()) return named->rgb;
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 1, end, value, 16);
  if (error != std::errc() || stop != end) return std::nullopt;
  return Rgb{static_cast<std::uint8_t>(value >> 16U),
             static_cast<std::uint8_t>((value >> 8U) & 0xffU),
             static_cast<std::uint8_t>(value & 0xffU)};
}

std::string color_text(const Rgb& rgb) {
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

}  // namespace wuerfel
