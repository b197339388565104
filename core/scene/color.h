/// Colours as scenes write them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace wuerfel {

using Rgb = std::array<std::uint8_t, 3>;

struct NamedColor {
  std::string_view name;
  Rgb rgb;
};

/// The eight colours of Okabe and Ito ("Color Universal Design", 2002), which colour-blind readers
/// can tell apart.
std::span<const NamedColor> okabe_ito();

/// "#rrggbb" or a name of okabe_ito(); nothing if it is neither.
std::optional<Rgb> parse_color(std::string_view text);

/// "#rrggbb"
std::string color_text(const Rgb& rgb);

}  // namespace wuerfel
