/// OffscreenContext: OpenGL 3.3 core without a window, drawn by the processor (OSMesa's llvmpipe)
/// straight into an Image. Nothing else knows OSMesa, which Mesa 25.1 removed: another context can
/// take its place here.
#pragma once

// The prototypes give the function types; the functions themselves are found at run time.
#define GL_GLEXT_PROTOTYPES
#include <string>

#include <GL/gl.h>
#include <GL/glext.h>

#include "render/raster/image.h"
#include "render/raster/raster_threads.h"

namespace wuerfel::internal {

/// Every OpenGL function that is used, once.
// clang-format off
#define WUERFEL_GL_FUNCTIONS(X)                                                                        \
  X(AttachShader) X(BindBuffer) X(BindVertexArray) X(BlendFunc) X(BufferData) X(Clear) X(ClearColor)   \
  X(CompileShader) X(CreateProgram) X(CreateShader) X(DeleteBuffers) X(DeleteProgram) X(DeleteShader)  \
  X(DeleteVertexArrays) X(Disable) X(DrawElements) X(Enable) X(EnableVertexAttribArray) X(Finish)          \
  X(GenBuffers) X(GenVertexArrays) X(GetError) X(GetProgramInfoLog) X(GetProgramiv)                    \
  X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetUniformLocation) X(LinkProgram) X(Scissor) X(ShaderSource) \
  X(Uniform1i) X(Uniform2f) X(UseProgram) X(VertexAttribPointer) X(Viewport)
// clang-format on

struct GlFunctions {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a member's name cannot stand in parentheses
#define WUERFEL_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
  WUERFEL_GL_FUNCTIONS(WUERFEL_GL_MEMBER)
#undef WUERFEL_GL_MEMBER
};

class OffscreenContext {
 public:
  /// Loads OSMesa and makes a context. Throws LibraryError where OSMesa is missing, has no core 3.3
  /// or draws by anything else than llvmpipe (whose pixels are the ones we know).
  explicit OffscreenContext(RasterThreads threads);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;
  OffscreenContext(OffscreenContext&&) = delete;
  OffscreenContext& operator=(OffscreenContext&&) = delete;

  /// What is drawn until the next call ends up in `image` (after glFinish), top row first. Where
  /// nothing is drawn, it shows what was drawn last in its size.
  void draw_into(Image& image);
  const GlFunctions& gl() const { return gl_; }
  /// GL_RENDERER and GL_VERSION, for manifests and bug reports.
  const std::string& description() const { return description_; }

 private:
  struct Library;
  const Library& library_;
  void* context_ = nullptr;
  GlFunctions gl_;
  std::string description_;
};

}  // namespace wuerfel::internal
