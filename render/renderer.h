/// Renderer: draws draw lists into images. Keeps the context, the shaders and the font between
/// pictures.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "render/draw_list.h"
#include "render/font.h"
#include "render/image.h"
#include "render/offscreen_context.h"
#include "render/shape_pipeline.h"

namespace wuerfel {

/// Belongs to one thread at a time; a process wants one. Drawing is a function of the list alone:
/// whatever was drawn before and however many threads there are, the pixels are the same.
class Renderer {
 public:
  /// Throws RenderError where OSMesa is missing.
  explicit Renderer(RasterThreads threads = RasterThreads::all);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  Renderer(Renderer&&) = delete;
  Renderer& operator=(Renderer&&) = delete;

  /// Paints `list` into `image`, which is made anew where its size differs from the list's.
  void draw(const DrawList& list, Image& image);

  /// The font of the texts, to measure them.
  Font& font() { return font_; }
  /// Name and version of what rasterises, for manifests and bug reports.
  const std::string& description() const { return context_.description(); }

 private:
  /// Made when the first shape of that kind is drawn.
  ShapePipeline& pipeline(ShapeKind kind);

  OffscreenContext context_;
  Font font_;
  std::array<std::unique_ptr<ShapePipeline>, 5> pipelines_;
};

}  // namespace wuerfel
