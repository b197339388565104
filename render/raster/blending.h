/// Colours laid over pixels, all four channels at a time.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "render/picture/color.h"

namespace wuerfel::internal {

/// R, B, G, A from the lowest bits on, 16 bits each: a channel times a share of 0..255 fits.
using Channels = std::uint64_t;

static_assert(std::endian::native == std::endian::little, "the channels' order is that of bytes");

inline Channels load(const std::uint8_t* pixel) {
  std::uint32_t word = 0;
  std::memcpy(&word, pixel, sizeof word);
  return (word & 0x00FF00FFU) | (Channels{word & 0xFF00FF00U} << 24U);
}

inline std::uint32_t word_of(Channels channels) {
  return static_cast<std::uint32_t>(channels | (channels >> 24U));
}

inline unsigned alpha_of(Channels channels) { return static_cast<unsigned>(channels >> 48U); }

/// Each channel / 255, rounded; exact up to 255 * 255 + 127.
inline Channels in_255ths(Channels channels) {
  constexpr Channels low = 0x00FF00FF00FF00FFU;
  const Channels sum = channels + 0x0080008000800080U;
  return ((sum + ((sum >> 8U) & low)) >> 8U) & low;
}

/// Three channels multiplied by alpha, as they add up.
inline Channels premultiplied(Color color) {
  return in_255ths((Channels{color.r} | Channels{color.b} << 16U | Channels{color.g} << 32U
                    | Channels{255} << 48U)
                   * color.a);
}

/// Lays colours over a pixel: the sum of premultiplied ones, each times how many 255ths of the pixel it
/// covers. Rounded once; what is opaque stays so.
inline void lay_over(Channels sum, std::uint8_t* pixel) {
  const unsigned rest = 255U - alpha_of(in_255ths(sum));
  const std::uint32_t word = word_of(in_255ths(sum + load(pixel) * rest));
  std::memcpy(pixel, &word, sizeof word);
}

}  // namespace wuerfel::internal
