/// Pictures of the scenes of tests, drawn as golden pictures are.
#pragma once

#include <memory>

#include "render/raster/draw_frame.h"
#include "tests/support/image_scenes.h"

namespace wuerfel::test {

inline constexpr int width = 480;
inline constexpr int height = 270;

/// One context for all tests of the process: making one takes longer than drawing a hundred
/// pictures.
inline Renderer& shared_renderer() {
  static const std::unique_ptr<Renderer> renderer = std::make_unique<Renderer>();
  return *renderer;
}

inline Image draw(const Snapshot& snapshot,
                  const View& view,
                  Theme theme,
                  const FrameOptions& options) {
  Image image;
  draw_frame(shared_renderer(), snapshot, view, make_style(theme), options, image);
  return image;
}

inline Image draw_fitted(const Snapshot& snapshot, Theme theme, Layers layers) {
  const FrameOptions options = literal_options(layers);
  return draw(snapshot, literal_view(snapshot, make_style(theme), options, width, height), theme,
              options);
}

}  // namespace wuerfel::test
