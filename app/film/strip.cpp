#include "app/film/strip.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "render/picture/compose_frame.h"

namespace wuerfel {

namespace {

bool has_legend(const StillOptions& options) { return options.picture.layers.has(Layer::hud); }

}  // namespace

StripLayout layout_of(const StillOptions& options) {
  const auto [width, height] = options.picture.size;
  return strip_layout(*options.strip, width, height, options.picture.scale,
                      has_legend(options) ? options.legend_rows : 0);
}

PictureOptions cell_options(const PictureOptions& page, const StripLayout& layout) {
  PictureOptions cell = page;
  cell.size = {layout.cell_width, layout.cell_height};
  cell.layers.erase(Layer::hud);
  return cell;
}

PixelSize size_of(const StillOptions& options, const Recording& motion) {
  PixelSize size = options.picture.size;
  if (size.height > 0) return size;
  PictureOptions scaled = fit_scales(options.picture, motion.range());
  size.height = size.width * 9 / 16;
  if (!options.strip) {
    size.height = auto_height(scaled, motion);
    return size;
  }
  StillOptions page = options;
  for (int k = 0; k < 8; ++k) {
    page.picture.size = size;
    const StripLayout layout = layout_of(page);
    const int wanted = auto_height(cell_options(scaled, layout), motion);
    size.height += options.strip->rows * (wanted - layout.cell_height);
    size.height = std::clamp(size.height, 16 * (4 + 3 * options.strip->rows), 16384);
  }
  return size;
}

void add_strip(const StillOptions& options,
               const PictureOptions& fitted,
               const Snapshot& first,
               std::vector<DrawList> lists,
               Font& font,
               Still& still) {
  const StripLayout layout = layout_of(options);
  std::vector<std::string> captions;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const CellPlace place = cell_place(layout, i);
    captions.push_back(fmt::format("t = {:.3f} s", options.times[i]));
    still.cells.push_back({std::move(lists[i]), place.x, place.y});
  }
  const Style style = make_style(fitted.theme);
  still.page = strip_page(captions, layout, style, first.title);
  if (layout.foot_height == 0) return;
  View view = view_of(fitted, first);
  view.width = layout.width;
  view.height = layout.foot_height;
  FrameOptions frame = frame_options(fitted);
  frame.layers.insert(Layer::hud);
  frame.layers.erase(Layer::cubes);  // the page has no ground
  DrawList legend = compose_legend(first, view, layout.unit, style, frame, font);
  still.legend_left_out = legend.legend_left_out;
  still.cells.push_back({std::move(legend), 0, layout.height - layout.foot_height});
}

}  // namespace wuerfel
