#include "render/vector/cairo_library.h"

#include <dlfcn.h>
#include <string>

#include "render/error.h"

namespace wuerfel::internal {
namespace {

constexpr const char* library_name = "libcairo.so.2";

CairoLibrary load() {
  void* handle = dlopen(library_name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) {
    throw RenderError(std::string("vector figures need Cairo, which could not be loaded (")
                      + dlerror() + "); on Debian it is in the package libcairo2");
  }
  CairoLibrary library;
#define WUERFEL_CAIRO_RESOLVE(name)                                                       \
  library.name = reinterpret_cast<decltype(library.name)>(dlsym(handle, "cairo_" #name)); \
  if (library.name == nullptr)                                                            \
    throw RenderError(std::string(library_name) + " has no cairo_" #name);
  WUERFEL_CAIRO_FUNCTIONS(WUERFEL_CAIRO_RESOLVE)
#undef WUERFEL_CAIRO_RESOLVE
  return library;
}

}  // namespace

const CairoLibrary& cairo_library() {
  static const CairoLibrary library = load();
  return library;
}

}  // namespace wuerfel::internal
