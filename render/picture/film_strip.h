/// Film strip: several moments in one picture, for a report.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "render/picture/draw_list.h"
#include "render/picture/style.h"

namespace wuerfel {

struct StripGrid {
  int columns = 4;
  int rows = 2;
};

/// Where the frames of a strip lie in a picture of this size.
struct StripLayout {
  StripGrid grid;
  int width = 0;  ///< px, of the whole
  int height = 0;
  int cell_width = 0;  ///< px, of one frame: draw them at this size, without a HUD
  int cell_height = 0;
  int head_height = 0;  ///< of the title; 0: none
  int foot_height = 0;  ///< of the legend; 0: none
  int gap = 0;
  int caption_height = 0;
  double unit = 1.0;  ///< text scale
};
/// With a title and a legend of so many rows, or without. Throws RenderError where the frames would
/// be smaller than 16 pixels.
StripLayout strip_layout(StripGrid grid, int width, int height, double scale, int legend_rows = 0);

/// `count` times from 0 to `end`, both included, evenly spaced (one: the end).
std::vector<double> strip_times(int count, double end);

/// Where the frame `i` of a strip has its upper left corner.
struct CellPlace {
  int x = 0;  ///< px
  int y = 0;
};
CellPlace cell_place(const StripLayout& layout, std::size_t i);

/// What a strip shows besides its frames: the background, a thin border around every frame, so that
/// frames on a white page stay apart, and below it the caption (for instance its time); where the
/// layout has room for it the title.
DrawList strip_page(std::span<const std::string> captions,
                    const StripLayout& layout,
                    const Style& style,
                    const std::string& title = {});

}  // namespace wuerfel
