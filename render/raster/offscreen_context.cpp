#include "render/raster/offscreen_context.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

#include <GL/osmesa.h>

#include "render/error.h"
#include "render/shared_library.h"

// Read by LeakSanitizer at the end of a program that was built with it: Mesa keeps a few hundred
// bytes of its own. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so"; }

namespace wuerfel::internal {

/// The functions of libOSMesa. It is loaded when the first picture is drawn, because loading it
/// takes longer than many a command that draws nothing, and never unloaded.
struct OffscreenContext::Library {
  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) get_proc_address = nullptr;

  Library();
  static const Library& loaded();
};

namespace {

/// llvmpipe is the only driver whose pixels we know, and other settings of these variables change
/// pixels or crash it (swr, zink and 512-bit vectors do).
void settle_environment() {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  for (const char* name : {"LP_NATIVE_VECTOR_WIDTH", "GALLIVM_PERF", "GALLIVM_DEBUG",
                           "GALLIUM_OVERRIDE_CPU_CAPS", "LP_DEBUG", "LP_PERF"}) {
    unsetenv(name);
  }
  setenv("LP_NUM_THREADS", "0", 1);  // the calling thread alone draws
}

std::string text_of(const GLubyte* text) {
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

}  // namespace

OffscreenContext::Library::Library() {
  settle_environment();
  const SharedLibrary file("libOSMesa.so.8", "pictures need OSMesa", "libosmesa6");
  file.find("OSMesaCreateContextAttribs", create_context);
  file.find("OSMesaDestroyContext", destroy_context);
  file.find("OSMesaMakeCurrent", make_current);
  file.find("OSMesaGetProcAddress", get_proc_address);
}

const OffscreenContext::Library& OffscreenContext::Library::loaded() {
  static const Library library;
  return library;
}

OffscreenContext::OffscreenContext() : library_(Library::loaded()) {
  constexpr std::array<int, 13> attributes{OSMESA_FORMAT,
                                           OSMESA_RGBA,
                                           OSMESA_DEPTH_BITS,
                                           0,
                                           OSMESA_STENCIL_BITS,
                                           0,
                                           OSMESA_PROFILE,
                                           OSMESA_CORE_PROFILE,
                                           OSMESA_CONTEXT_MAJOR_VERSION,
                                           3,
                                           OSMESA_CONTEXT_MINOR_VERSION,
                                           3,
                                           0};
  context_ = library_.create_context(attributes.data(), nullptr);
  if (context_ == nullptr) throw LibraryError("OSMesa offers no OpenGL 3.3 core context");
  if (!make_current()) {
    library_.destroy_context(static_cast<OSMesaContext>(context_));
    throw LibraryError("OSMesa cannot make its context current");
  }
#define WUERFEL_GL_RESOLVE(name) \
  gl_.name = reinterpret_cast<decltype(gl_.name)>(library_.get_proc_address("gl" #name));
  WUERFEL_GL_FUNCTIONS(WUERFEL_GL_RESOLVE)
#undef WUERFEL_GL_RESOLVE
  description_ =
      text_of(gl_.GetString(GL_RENDERER)) + ", OpenGL " + text_of(gl_.GetString(GL_VERSION));
  if (!description_.starts_with("llvmpipe")) {
    library_.destroy_context(static_cast<OSMesaContext>(context_));
    throw LibraryError("OSMesa draws by " + description_ + " instead of llvmpipe");
  }
  make_surface();
}

bool OffscreenContext::make_current() {
  return library_.make_current(static_cast<OSMesaContext>(context_), window_.data(),
                               GL_UNSIGNED_BYTE, window_.width(), window_.height())
         == GL_TRUE;
}

OffscreenContext::~OffscreenContext() {
  library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  library_.destroy_context(static_cast<OSMesaContext>(context_));
}

void OffscreenContext::make_surface() {
  GLuint framebuffer = 0;
  GLuint pixels = 0;
  gl_.GenFramebuffers(1, &framebuffer);
  gl_.GenRenderbuffers(1, &pixels);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, pixels);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels);
}

void OffscreenContext::use_canvas(int width, int height) {
  if (!make_current()) throw LibraryError("OSMesa cannot make its context current");
  if (width == width_ && height == height_) return;
  width_ = 0;
  gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw LibraryError("OSMesa cannot draw a picture of " + std::to_string(width) + "x"
                       + std::to_string(height) + " pixels");
  }
  gl_.Viewport(0, 0, width, height);
  width_ = width;
  height_ = height;
}

void OffscreenContext::clear(Color color) {
  const float alpha = static_cast<float>(color.a) / 255.0F;
  gl_.ClearColor(static_cast<float>(color.r) / 255.0F * alpha,
                 static_cast<float>(color.g) / 255.0F * alpha,
                 static_cast<float>(color.b) / 255.0F * alpha, alpha);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void OffscreenContext::read(const RowSet& rows, Image& image) {
  gl_.PixelStorei(GL_PACK_ROW_LENGTH, width_);
  for (const RowRange& range : rows.ranges()) {
    gl_.ReadPixels(range.left, range.begin, std::min(range.right, width_) - range.left,
                   range.end - range.begin, GL_RGBA, GL_UNSIGNED_BYTE,
                   image.row(range.begin) + 4 * static_cast<std::ptrdiff_t>(range.left));
  }
  if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR)
    throw LibraryError("OpenGL reports error " + std::to_string(error));
}

}  // namespace wuerfel::internal
