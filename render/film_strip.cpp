#include "render/film_strip.h"

#include <charconv>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "render/error.h"
#include "render/frame_options.h"
#include "render/text.h"

namespace wuerfel {
namespace {

constexpr int smallest_cell = 16;
constexpr double gap_size = 14.0;  ///< px of a 1280x720 picture
constexpr double caption_size = 13.0;

/// A thin border, so that frames on a white page stay apart.
void frame_border(int x, int y, const StripLayout& layout, Color color, Image& sheet) {
  for (int i = -1; i <= layout.cell_width; ++i) {
    sheet.set(x + i, y - 1, color);
    sheet.set(x + i, y + layout.cell_height, color);
  }
  for (int i = -1; i <= layout.cell_height; ++i) {
    sheet.set(x - 1, y + i, color);
    sheet.set(x + layout.cell_width, y + i, color);
  }
}

}  // namespace

StripGrid parse_strip(std::string_view text) {
  StripGrid grid;
  const char* const end = text.data() + text.size();
  const auto [middle, error] = std::from_chars(text.data(), end, grid.columns);
  if (error == std::errc{} && middle != end && *middle == 'x') {
    const auto [last, second_error] = std::from_chars(middle + 1, end, grid.rows);
    if (second_error == std::errc{} && last == end && grid.columns > 0 && grid.rows > 0)
      return grid;
  }
  throw RenderError(fmt::format("'{}' is not a film strip: use COLUMNSxROWS such as 4x2", text));
}

StripLayout strip_layout(StripGrid grid, int width, int height, double scale) {
  StripLayout layout{grid, width, height, 0, 0, 0, 0, frame_unit(width, height, scale)};
  layout.gap = static_cast<int>(std::lround(gap_size * layout.unit));
  layout.caption_height = static_cast<int>(std::lround(1.7 * caption_size * layout.unit));
  layout.cell_width = (width - (grid.columns + 1) * layout.gap) / grid.columns;
  layout.cell_height =
      (height - layout.gap - grid.rows * (layout.gap + layout.caption_height)) / grid.rows;
  if (layout.cell_width < smallest_cell || layout.cell_height < smallest_cell) {
    throw RenderError(fmt::format("{}x{} frames do not fit into {}x{} pixels", grid.columns,
                                  grid.rows, width, height));
  }
  return layout;
}

std::vector<double> strip_times(int count, double end) {
  std::vector<double> times(static_cast<std::size_t>(count), end);
  for (int i = 0; i + 1 < count; ++i)
    times[static_cast<std::size_t>(i)] = end * i / (count - 1);
  return times;
}

Image film_strip(std::span<const Image> frames,
                 std::span<const std::string> captions,
                 const StripLayout& layout,
                 const Style& style,
                 Font& font) {
  Image sheet(layout.width, layout.height, style.background);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const int column = static_cast<int>(i) % layout.grid.columns;
    const int row = static_cast<int>(i) / layout.grid.columns;
    const int x = layout.gap + column * (layout.cell_width + layout.gap);
    const int y = layout.gap + row * (layout.cell_height + layout.caption_height + layout.gap);
    paste(frames[i], x, y, sheet);
    frame_border(x, y, layout, style.grid_axis, sheet);
    TextShape caption;
    caption.text = captions[i];
    caption.size = static_cast<float>(caption_size * layout.unit);
    caption.baseline = {
        static_cast<float>(x),
        static_cast<float>(y + layout.cell_height + 1.25 * caption_size * layout.unit)};
    caption.color = style.quiet_ink;
    blend_text(caption, font, sheet);
  }
  return sheet;
}

}  // namespace wuerfel
