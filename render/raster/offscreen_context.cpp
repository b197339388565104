#include "render/raster/offscreen_context.h"

#include <array>
#include <cstdlib>

#include <GL/osmesa.h>

#include "render/error.h"
#include "render/shared_library.h"

// Read by LeakSanitizer at the end of a program that was built with it: Mesa keeps a few hundred
// bytes of its own. NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so"; }

namespace wuerfel::internal {

/// The functions of libOSMesa. It is loaded when the first picture is drawn, because loading it
/// takes longer than many a command that draws nothing, and never unloaded.
struct OffscreenContext::Library {
  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaPixelStore) pixel_store = nullptr;
  decltype(&OSMesaGetProcAddress) get_proc_address = nullptr;

  explicit Library(RasterThreads threads);
  static const Library& loaded(RasterThreads threads);
};

namespace {

/// llvmpipe is the only driver whose pixels we know, and other settings of these variables change
/// pixels or crash it (swr, zink and 512-bit vectors do).
void settle_environment(RasterThreads threads) {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  for (const char* name : {"LP_NATIVE_VECTOR_WIDTH", "GALLIVM_PERF", "GALLIVM_DEBUG",
                           "GALLIUM_OVERRIDE_CPU_CAPS", "LP_DEBUG", "LP_PERF"}) {
    unsetenv(name);
  }
  if (threads == RasterThreads::caller) setenv("LP_NUM_THREADS", "0", 1);
}

std::string text_of(const GLubyte* text) {
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

}  // namespace

OffscreenContext::Library::Library(RasterThreads threads) {
  settle_environment(threads);
  const SharedLibrary file("libOSMesa.so.8", "pictures need OSMesa", "libosmesa6");
  file.find("OSMesaCreateContextAttribs", create_context);
  file.find("OSMesaDestroyContext", destroy_context);
  file.find("OSMesaMakeCurrent", make_current);
  file.find("OSMesaPixelStore", pixel_store);
  file.find("OSMesaGetProcAddress", get_proc_address);
}

const OffscreenContext::Library& OffscreenContext::Library::loaded(RasterThreads threads) {
  static const Library library(threads);
  return library;
}

OffscreenContext::OffscreenContext(RasterThreads threads) : library_(Library::loaded(threads)) {
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
  Image scratch(16, 16);
  if (library_.make_current(static_cast<OSMesaContext>(context_), scratch.data(), GL_UNSIGNED_BYTE,
                            scratch.width(), scratch.height())
      == GL_FALSE) {
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
}

OffscreenContext::~OffscreenContext() {
  library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  library_.destroy_context(static_cast<OSMesaContext>(context_));
}

void OffscreenContext::draw_into(Image& image) {
  if (library_.make_current(static_cast<OSMesaContext>(context_), image.data(), GL_UNSIGNED_BYTE,
                            image.width(), image.height())
      == GL_FALSE) {
    throw LibraryError("OSMesa cannot draw into a picture of " + std::to_string(image.width()) + "x"
                       + std::to_string(image.height()) + " pixels");
  }
  // Top row first.
  library_.pixel_store(OSMESA_Y_UP, 0);
  gl_.Viewport(0, 0, image.width(), image.height());
}

}  // namespace wuerfel::internal
