/// Colours as they lie in an image: 8 bits a channel, straight alpha, sRGB.
#pragma once

#include <cstdint>

namespace wuerfel {

struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;
  friend bool operator==(const Color&, const Color&) = default;
};

/// 0xRRGGBB, opaque.
constexpr Color rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>((hex >> 16U) & 0xFFU),
          static_cast<std::uint8_t>((hex >> 8U) & 0xFFU), static_cast<std::uint8_t>(hex & 0xFFU),
          255};
}

/// A number of 0..255 rounded to a channel's value.
constexpr std::uint8_t channel(double value) {
  const int below = static_cast<int>(value);
  return static_cast<std::uint8_t>(value - below < 0.5 ? below : below + 1);
}

/// The colour at `share` (0..1) of the way from `from` to `to`, alpha too.
constexpr Color mix(Color from, Color to, double share) {
  return {channel(from.r + (to.r - from.r) * share), channel(from.g + (to.g - from.g) * share),
          channel(from.b + (to.b - from.b) * share), channel(from.a + (to.a - from.a) * share)};
}

constexpr Color with_alpha(Color color, double alpha) {
  color.a = channel(alpha * 255.0);
  return color;
}

/// Perceived brightness (Rec. 709 luma), 0 black .. 1 white.
constexpr double brightness(Color color) {
  return (0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b) / 255.0;
}

}  // namespace wuerfel
