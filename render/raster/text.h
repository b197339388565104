/// Text, blended over the shapes.
#pragma once

#include "render/picture/draw_list.h"
#include "render/picture/font.h"
#include "render/raster/image.h"

namespace wuerfel::internal {

/// Writes `text` into `image` (premultiplied where it is not opaque); what lies outside of `rows` is cut off.
void blend_text(const TextShape& text, const RowRange& rows, Font& font, Image& image);

}  // namespace wuerfel::internal
