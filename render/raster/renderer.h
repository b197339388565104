/// Renderer: draws draw lists into images. Keeps the font and the last list between pictures.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "render/picture/draw_list.h"
#include "render/picture/font.h"
#include "render/raster/image.h"
#include "render/raster/rasteriser.h"
#include "render/raster/row_set.h"

namespace wuerfel {

/// Belongs to one thread at a time. Drawing is a function of the list alone: whatever was drawn before, the
/// pixels are the same.
class Renderer {
 public:
  /// Throws LibraryError where OSMesa is asked for and missing.
  explicit Renderer(Rasteriser rasteriser = Rasteriser::scan_lines);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  Renderer(Renderer&&) = delete;
  Renderer& operator=(Renderer&&) = delete;

  /// Paints `list` into `image`, which is made anew where its size differs from the list's. Outside
  /// of what is returned the picture equals the one drawn before. Who knows that `image` shows that
  /// one outside of `stale` saves the work of drawing that.
  RowSet draw(const DrawList& list, Image& image, const std::optional<RowSet>& stale = {});

  /// The font of the texts, to measure them.
  Font& font();
  /// Name and version of what rasterises, for manifests and bug reports.
  std::string description() const;

 private:
  class OpenGl;  // users need no OpenGL headers
  void draw_shapes(const DrawList& list, const RowSet& rows, Image& image);

  std::unique_ptr<OpenGl> gl_;
  Font font_;
  std::optional<DrawList> last_;
};

}  // namespace wuerfel
