/// ShapePipeline: shaders and vertices for one kind of shape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/picture/draw_list.h"
#include "render/raster/offscreen_context.h"

namespace wuerfel::internal {

/// Draws all shapes of a run at once, each in a quad whose fragments know how far they are from the
/// shape's edge. Every vertex carries the whole shape: drawing instances
/// instead would send less, but costs llvmpipe 2 microseconds for each; and each draw call costs it
/// a copy of all state, 40 kB.
class ShapePipeline {
 public:
  /// Throws LibraryError where the shaders are refused.
  ShapePipeline(const GlFunctions& gl, ShapeKind kind);
  ~ShapePipeline();
  ShapePipeline(const ShapePipeline&) = delete;
  ShapePipeline& operator=(const ShapePipeline&) = delete;
  ShapePipeline(ShapePipeline&&) = delete;
  ShapePipeline& operator=(ShapePipeline&&) = delete;

  /// The shapes of a run of this kind, into the picture that is being drawn.
  void draw(const DrawList& list, const ShapeRun& run);

 private:
  void describe_vertices();
  void make_indices(std::size_t quads);
  void draw_quads(std::size_t count);

  const GlFunctions& gl_;
  ShapeKind kind_;
  std::size_t shape_size_;  ///< bytes
  GLuint program_ = 0;
  GLuint vertex_array_ = 0;
  GLuint vertex_buffer_ = 0;
  GLuint index_buffer_ = 0;
  GLint picture_ = -1;
  std::size_t indexed_quads_ = 0;
  std::vector<std::byte> vertices_;  ///< of the shapes that are to be drawn next
};

}  // namespace wuerfel::internal
