#include "render/raster/draw_frame.h"

#include "render/picture/compose_frame.h"

namespace wuerfel {

void draw_frame(Renderer& renderer,
                const Snapshot& snapshot,
                const View& view,
                const Style& style,
                const FrameOptions& options,
                Image& image) {
  renderer.draw(compose_frame(snapshot, view, style, options, renderer.font()), image);
}

}  // namespace wuerfel
