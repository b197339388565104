#include "render/raster/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "render/raster/blending.h"

namespace wuerfel::internal {
namespace {

void blend_glyph(
    const Glyph& glyph, int x, int y, Color color, const RowRange& rows, Image& image) {
  const Channels letter = premultiplied(color);
  const int left = x + glyph.left;
  const int top = y - glyph.top;
  const int first = std::max(0, rows.left - left);
  const int last = std::min(glyph.width, std::min(rows.right, image.width()) - left);
  for (int row = std::max(0, rows.begin - top); row < std::min(glyph.height, rows.end - top);
       ++row) {
    const std::uint8_t* coverage =
        glyph.coverage.data() + static_cast<std::ptrdiff_t>(row) * glyph.width;
    std::uint8_t* pixels = image.row(top + row) + 4 * static_cast<std::ptrdiff_t>(left);
    for (int column = first; column < last; ++column) {
      if (coverage[column] > 0)
        lay_over(letter * coverage[column], pixels + 4 * static_cast<std::ptrdiff_t>(column));
    }
  }
}

/// One pass over the letters: the halo's, or the letters' own.
void blend_line(const TextShape& text,
                double halo,
                Color color,
                const RowRange& rows,
                Font& font,
                Image& image) {
  double pen = static_cast<double>(text.baseline.x);
  const auto size = static_cast<double>(text.size);
  const int y = static_cast<int>(std::lround(text.baseline.y));
  for (std::size_t at = 0; at < text.text.size();) {
    const char32_t letter = next_code_point(text.text, at);
    std::size_t peek = at;
    const char32_t next = at < text.text.size() ? next_code_point(text.text, peek) : 0;
    const auto quarters = static_cast<int>(std::lround(pen * 4.0));
    const int phase = ((quarters % 4) + 4) % 4;
    blend_glyph(font.glyph(letter, size, phase, halo), (quarters - phase) / 4, y, color, rows,
                image);
    pen += font.advance(letter, next, size);
  }
}

}  // namespace

void blend_text(const TextShape& text, const RowRange& rows, Font& font, Image& image) {
  if (text.halo_width > 0.0F && text.halo.a > 0) {
    blend_line(text, static_cast<double>(text.halo_width), text.halo, rows, font, image);
  }
  blend_line(text, 0.0, text.color, rows, font, image);
}

}  // namespace wuerfel::internal
