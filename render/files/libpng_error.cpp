#include "render/files/libpng_error.h"

#include <string>

#include "render/error.h"

namespace wuerfel::internal {

void throw_png_error(png_structp png, png_const_charp message) {
  (void)png;
  throw RenderError(std::string("PNG: ") + message);
}

void ignore_png_warning(png_structp png, png_const_charp message) {
  (void)png;
  (void)message;
}

}  // namespace wuerfel::internal
