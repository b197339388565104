#include "render/vector/cairo_library.h"

#include "render/shared_library.h"

namespace wuerfel::internal {
namespace {

CairoLibrary load() {
  const SharedLibrary file("libcairo.so.2", "vector figures need Cairo", "libcairo2");
  CairoLibrary library;
#define WUERFEL_CAIRO_RESOLVE(name) file.find("cairo_" #name, library.name);
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
