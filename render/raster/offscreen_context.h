/// OffscreenContext: OpenGL 3.3 core without a window, drawn by the processor (OSMesa's llvmpipe) on
/// a canvas from which rows are read into an Image. Nothing else knows OSMesa, which Mesa 25.1 removed.
#pragma once

// The prototypes give the function types; the functions themselves are found at run time.
#define GL_GLEXT_PROTOTYPES
#include <string>

#include <GL/gl.h>
#include <GL/glext.h>

#include "render/raster/image.h"
#include "render/raster/row_set.h"

namespace wuerfel::internal {

/// Every OpenGL function that is used, once.
// clang-format off
#define WUERFEL_GL_FUNCTIONS(X)                                                                        \
  X(AttachShader) X(BindBuffer) X(BindFramebuffer) X(BindRenderbuffer) X(BindVertexArray) X(BlendFunc) \
  X(BufferData) X(CheckFramebufferStatus) X(Clear) X(ClearColor)                                       \
  X(CompileShader) X(CreateProgram) X(CreateShader) X(DeleteBuffers) X(DeleteProgram) X(DeleteShader)  \
  X(DeleteVertexArrays) X(DrawElements) X(Enable) X(EnableVertexAttribArray)                     \
  X(FramebufferRenderbuffer) X(GenBuffers) X(GenFramebuffers) X(GenRenderbuffers) X(GenVertexArrays)   \
  X(GetError) X(GetProgramInfoLog) X(GetProgramiv)                    \
  X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetUniformLocation) X(LinkProgram) X(PixelStorei) X(ReadPixels) X(RenderbufferStorage) X(ShaderSource) \
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
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;
  OffscreenContext(OffscreenContext&&) = delete;
  OffscreenContext& operator=(OffscreenContext&&) = delete;

  /// What is drawn from now on is drawn on a canvas of this size, whose row 0 is the upper one and
  /// has y = 0.
  void use_canvas(int width, int height);
  /// Fills the canvas with a colour.
  void clear(Color color);
  /// Copies rows of the canvas into an image of its size. Throws LibraryError where OpenGL reports
  /// an error.
  void read(const RowSet& rows, Image& image);
  const GlFunctions& gl() const { return gl_; }
  /// GL_RENDERER and GL_VERSION, for manifests and bug reports.
  const std::string& description() const { return description_; }

 private:
  bool make_current();
  void make_surface();

  struct Library;
  const Library& library_;
  void* context_ = nullptr;
  Image window_{16, 16};  ///< OSMesa wants one; nothing is drawn into it
  int width_ = 0;         ///< px, of the canvas
  int height_ = 0;
  GlFunctions gl_;
  std::string description_;
};

}  // namespace wuerfel::internal
