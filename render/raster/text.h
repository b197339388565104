/// Text is blended by the processor after the shapes: it costs less than a draw call.
#pragma once

#include "render/picture/draw_list.h"
#include "render/picture/font.h"
#include "render/raster/image.h"

namespace wuerfel::internal {

/// Writes `text` into `image` (premultiplied where it is not opaque); what lies outside is cut off.
void blend_text(const TextShape& text, Font& font, Image& image);

}  // namespace wuerfel::internal
