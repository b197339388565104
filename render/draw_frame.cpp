#include "render/draw_frame.h"

#include "render/compose_frame.h"

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
