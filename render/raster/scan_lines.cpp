#include "render/raster/scan_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "render/raster/blending.h"
#include "render/raster/extent.h"
#include "render/raster/shape_areas.h"

namespace wuerfel::internal {
namespace {

void fill_pixels(Channels color, std::uint8_t* pixel, int count) {
  const std::uint32_t word = word_of(color);
  for (int i = 0; i < count; ++i, pixel += 4)
    std::memcpy(pixel, &word, sizeof word);
}

/// Lays the two colours of a shape over pixels of one row.
class RowPainter {
 public:
  RowPainter(Color outline, Color fill)
      : outline_(premultiplied(outline)), fill_(premultiplied(fill)) {}

  /// Pixels on the edges.
  template <class Area>
  void cover(const Area& area, float y, Span span, std::uint8_t* row) const {
    std::uint8_t* pixel = row + 4 * static_cast<std::ptrdiff_t>(span.begin);
    for (int x = span.begin; x < span.end; ++x, pixel += 4) {
      const Coverage covered = area.at(static_cast<float>(x) + 0.5F, y);
      const int all = in_255ths(covered.all);
      const int fill = in_255ths(covered.fill);
      if (all == 0) continue;
      lay_over(outline_ * static_cast<Channels>(all - fill) + fill_ * static_cast<Channels>(fill),
               pixel);
    }
  }

  /// Pixels within.
  void fill(Span span, std::uint8_t* row) const {
    std::uint8_t* pixel = row + 4 * static_cast<std::ptrdiff_t>(span.begin);
    if (alpha_of(fill_) == 255) return fill_pixels(fill_, pixel, span.size());
    for (int i = 0; i < span.size(); ++i, pixel += 4)
      lay_over(255 * fill_, pixel);
  }

 private:
  static int in_255ths(float share) {
    constexpr float half = 0.5F;  // what is cut off becomes what is nearest
    return static_cast<int>(share * 255.0F + half);
  }
  Channels outline_;
  Channels fill_;
};

/// What is filled but for what crosses it.
template <class Area>
void fill_area(
    const Area& area, const RowPainter& painter, float y, Span filled, std::uint8_t* row) {
  if constexpr (std::is_same_v<Area, BoxArea>) {
    for (const Span& crossed : area.crossed(y, filled)) {
      if (crossed.size() <= 0) continue;
      painter.fill({filled.begin, crossed.begin}, row);
      painter.cover(area, y, crossed, row);
      filled.begin = crossed.end;
    }
  }
  painter.fill(filled, row);
}

template <class Area>
void draw_area(const Area& area,
               const RowPainter& painter,
               const Extent& extent,
               const RowRange& rows,
               Image& image) {
  if (!std::isfinite(extent.left + extent.top + extent.right + extent.bottom)) return;
  const Span columns =
      pixels_in({extent.left, extent.right}, {rows.left, std::min(rows.right, image.width())});
  const Span lines = pixels_in({extent.top, extent.bottom}, {rows.begin, rows.end});
  for (int line = lines.begin; line < lines.end; ++line) {
    const float y = static_cast<float>(line) + 0.5F;
    const Span touched = area.touched(y, columns);
    if (touched.size() <= 0) continue;
    Span filled = area.filled(y, touched);
    if (filled.size() <= 0) filled = {touched.end, touched.end};
    painter.cover(area, y, {touched.begin, filled.begin}, image.row(line));
    fill_area(area, painter, y, filled, image.row(line));
    painter.cover(area, y, {filled.end, touched.end}, image.row(line));
  }
}

void draw_shape(const BoxShape& box, const RowRange& rows, Image& image) {
  draw_area(BoxArea(box), RowPainter(box.outline, box.fill), extent(box), rows, image);
}
void draw_shape(const SegmentShape& segment, const RowRange& rows, Image& image) {
  draw_area(SegmentArea(segment), RowPainter({}, segment.color), extent(segment), rows, image);
}
void draw_shape(const ArrowShape& arrow, const RowRange& rows, Image& image) {
  if (arrow.tail == arrow.tip) return;  // it has no direction
  draw_area(ArrowArea(arrow), RowPainter({}, arrow.color), extent(arrow), rows, image);
}
void draw_shape(const DiscShape& disc, const RowRange& rows, Image& image) {
  draw_area(DiscArea(disc), RowPainter(disc.outline, disc.fill), extent(disc), rows, image);
}
void draw_shape(const TriangleShape& triangle, const RowRange& rows, Image& image) {
  draw_area(TriangleArea(triangle), RowPainter(triangle.outline, triangle.fill), extent(triangle),
            rows, image);
}

}  // namespace

void draw_scan_lines(const DrawList& list, const RowRange& rows, Image& image) {
  const Channels ground = premultiplied(list.background);
  const int columns = std::min(rows.right, image.width()) - rows.left;
  for (int y = rows.begin; y < rows.end; ++y)
    fill_pixels(ground, image.row(y) + 4 * static_cast<std::ptrdiff_t>(rows.left), columns);
  for (const ShapeRun& run : list.runs) {
    with_shapes(list, run.kind, [&](const auto& shapes) {
      for (std::size_t i = run.first; i < run.first + run.count; ++i)
        draw_shape(shapes[i], rows, image);
    });
  }
}

}  // namespace wuerfel::internal
