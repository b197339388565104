#include "render/picture/film_strip.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "render/error.h"
#include "render/picture/frame_options.h"

namespace wuerfel {
namespace {

constexpr int smallest_cell = 16;
constexpr double gap_size = 14.0;  ///< px of a 1280x720 picture
constexpr double caption_size = 13.0;
constexpr double title_room = 30.0;
constexpr double legend_room = 40.0;  ///< of its first row
constexpr double legend_row = 20.0;   ///< of each more

/// Strokes of one pixel just outside the frame at `place`.
void add_border(CellPlace place, const StripLayout& layout, Color color, DrawList& page) {
  const float left = static_cast<float>(place.x) - 0.5F;
  const float top = static_cast<float>(place.y) - 0.5F;
  const float right = static_cast<float>(place.x + layout.cell_width) + 0.5F;
  const float bottom = static_cast<float>(place.y + layout.cell_height) + 0.5F;
  const std::array<Pixel, 5> corners{
      {{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    page.add(SegmentShape{corners.at(i), corners.at(i + 1), 0.5F, 1.0F, color});
}

[[noreturn]] void refuse(StripGrid grid, int width, int height) {
  throw RenderError(fmt::format("{}x{} frames do not fit into {}x{} pixels", grid.columns,
                                grid.rows, width, height));
}

}  // namespace

StripLayout strip_layout(StripGrid grid, int width, int height, double scale, int legend_rows) {
  // Compared in floating point first: no number of frames and no scale can overflow.
  const double unit = frame_unit(width, height, scale);
  const double least_gap = gap_size * unit + smallest_cell;
  if (!(grid.columns * least_gap < width) || !(grid.rows * least_gap < height))
    refuse(grid, width, height);
  StripLayout layout;
  layout.grid = grid;
  layout.width = width;
  layout.height = height;
  layout.unit = unit;
  if (legend_rows > 0) {
    layout.head_height = static_cast<int>(std::lround(title_room * unit));
    layout.foot_height =
        static_cast<int>(std::lround((legend_room + (legend_rows - 1) * legend_row) * unit));
  }
  layout.gap = static_cast<int>(std::lround(gap_size * layout.unit));
  layout.caption_height = static_cast<int>(std::lround(1.7 * caption_size * layout.unit));
  layout.cell_width = (width - (grid.columns + 1) * layout.gap) / grid.columns;
  layout.cell_height = (height - layout.head_height - layout.foot_height - layout.gap
                        - grid.rows * (layout.gap + layout.caption_height))
                       / grid.rows;
  if (layout.cell_width < smallest_cell || layout.cell_height < smallest_cell)
    refuse(grid, width, height);
  return layout;
}

std::vector<double> strip_times(int count, double end) {
  std::vector<double> times(count, end);
  for (int i = 0; i + 1 < count; ++i)
    times[i] = end * i / (count - 1);
  return times;
}

CellPlace cell_place(const StripLayout& layout, std::size_t i) {
  const int column = static_cast<int>(i) % layout.grid.columns;
  const int row = static_cast<int>(i) / layout.grid.columns;
  return {layout.gap + column * (layout.cell_width + layout.gap),
          layout.head_height + layout.gap
              + row * (layout.cell_height + layout.caption_height + layout.gap)};
}

DrawList strip_page(std::span<const std::string> captions,
                    const StripLayout& layout,
                    const Style& style,
                    const std::string& title) {
  DrawList page;
  page.width = layout.width;
  page.height = layout.height;
  page.background = style.background;
  if (layout.head_height > 0 && !title.empty()) {
    TextShape text;
    text.text = title;
    text.size = static_cast<float>(style.title_size * layout.unit);
    text.baseline = {static_cast<float>(layout.gap),
                     static_cast<float>(layout.gap + 0.9 * style.title_size * layout.unit)};
    text.color = style.ink;
    page.texts.push_back(std::move(text));
  }
  for (std::size_t i = 0; i < captions.size(); ++i) {
    const CellPlace place = cell_place(layout, i);
    add_border(place, layout, style.grid_axis, page);
    TextShape caption;
    caption.text = captions[i];
    caption.size = static_cast<float>(caption_size * layout.unit);
    caption.baseline = {
        static_cast<float>(place.x),
        static_cast<float>(place.y + layout.cell_height + 1.25 * caption_size * layout.unit)};
    caption.color = style.quiet_ink;
    page.texts.push_back(std::move(caption));
  }
  return page;
}

}  // namespace wuerfel
