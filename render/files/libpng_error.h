/// How libpng reports errors: by a callback that must not return. Exceptions pass through its C code
/// because it is built with unwind tables on every Debian architecture.
#pragma once

#include <png.h>

namespace wuerfel::internal {

/// Throws RenderError.
[[noreturn]] void throw_png_error(png_structp png, png_const_charp message);
void ignore_png_warning(png_structp png, png_const_charp message);

}  // namespace wuerfel::internal
