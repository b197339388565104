/// Draws shapes by the processor, row by row: our own rasteriser. Coverage is that of the distance to
/// the edge, as in the shaders of OSMesa, but computed at edges alone; what lies inside is filled.
/// Nothing but the arithmetic of IEEE 754 decides, so that the pixels of a list are equal on every machine.
#pragma once

#include "render/picture/draw_list.h"
#include "render/raster/image.h"

namespace wuerfel::internal {

/// Background and shapes of `list`, without its texts, into some rows and columns of an image of its
/// size, which has premultiplied alpha there afterwards. No pixel depends on which others are drawn.
void draw_scan_lines(const DrawList& list, const RowRange& rows, Image& image);

}  // namespace wuerfel::internal
