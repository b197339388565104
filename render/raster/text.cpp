#include "render/raster/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace wuerfel::internal {
namespace {

/// a * b / 255, rounded; exact for all bytes.
unsigned scaled(unsigned a, unsigned b) {
  const unsigned product = a * b + 128U;
  return (product + (product >> 8U)) >> 8U;
}

void blend_glyph(const Glyph& glyph, int x, int y, Color color, Image& image) {
  const int first = std::max(0, -(x + glyph.left));
  const int last = std::min(glyph.width, image.width() - (x + glyph.left));
  for (int row = 0; row < glyph.height; ++row) {
    const int target_y = y - glyph.top + row;
    if (target_y < 0 || target_y >= image.height()) continue;
    const std::uint8_t* coverage =
        glyph.coverage.data() + static_cast<std::ptrdiff_t>(row) * glyph.width;
    for (int column = first; column < last; ++column) {
      const unsigned alpha = scaled(coverage[column], color.a);
      if (alpha == 0) continue;
      std::uint8_t* pixel =
          image.row(target_y) + 4 * static_cast<std::ptrdiff_t>(x + glyph.left + column);
      const auto blended = [alpha](unsigned source, unsigned below) {
        return static_cast<std::uint8_t>(scaled(source, alpha) + scaled(below, 255U - alpha));
      };
      pixel[0] = blended(color.r, pixel[0]);
      pixel[1] = blended(color.g, pixel[1]);
      pixel[2] = blended(color.b, pixel[2]);
      pixel[3] = blended(255U, pixel[3]);
    }
  }
}

/// One pass over the letters: the halo's, or the letters' own.
void blend_line(const TextShape& text, double halo, Color color, Font& font, Image& image) {
  double pen = static_cast<double>(text.baseline.x);
  const auto size = static_cast<double>(text.size);
  const int y = static_cast<int>(std::lround(text.baseline.y));
  for (std::size_t at = 0; at < text.text.size();) {
    const char32_t letter = next_code_point(text.text, at);
    std::size_t peek = at;
    const char32_t next = at < text.text.size() ? next_code_point(text.text, peek) : 0;
    const auto quarters = static_cast<int>(std::lround(pen * 4.0));
    const int phase = ((quarters % 4) + 4) % 4;
    blend_glyph(font.glyph(letter, size, phase, halo), (quarters - phase) / 4, y, color, image);
    pen += font.advance(letter, next, size);
  }
}

}  // namespace

void blend_text(const TextShape& text, Font& font, Image& image) {
  if (text.halo_width > 0.0F && text.halo.a > 0) {
    blend_line(text, static_cast<double>(text.halo_width), text.halo, font, image);
  }
  blend_line(text, 0.0, text.color, font, image);
}

}  // namespace wuerfel::internal
