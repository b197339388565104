/// draw_frame: a snapshot becomes pixels.
#pragma once

#include "core/snapshot.h"
#include "render/picture/frame_options.h"
#include "render/picture/style.h"
#include "render/picture/view.h"
#include "render/raster/image.h"
#include "render/raster/renderer.h"

namespace wuerfel {

/// Draws into `image`, which is made anew where its size is not the view's. The pixels depend on
/// the snapshot, view, style and options alone. Throws RenderError and LibraryError.
void draw_frame(Renderer& renderer,
                const Snapshot& snapshot,
                const View& view,
                const Style& style,
                const FrameOptions& options,
                Image& image);

}  // namespace wuerfel
