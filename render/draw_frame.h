/// draw_frame: a snapshot becomes pixels.
#pragma once

#include "core/snapshot.h"
#include "render/frame_options.h"
#include "render/image.h"
#include "render/renderer.h"
#include "render/style.h"
#include "render/view.h"

namespace wuerfel {

/// Draws into `image`, which is made anew where its size is not the view's. The pixels depend on
/// the snapshot, view, style and options alone. Throws RenderError.
void draw_frame(Renderer& renderer,
                const Snapshot& snapshot,
                const View& view,
                const Style& style,
                const FrameOptions& options,
                Image& image);

}  // namespace wuerfel
