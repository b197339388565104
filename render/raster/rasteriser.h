/// Rasteriser: who turns shapes into pixels.
#pragma once

#include <string_view>

namespace wuerfel {

enum class Rasteriser {
  scan_lines,  ///< our own: a list has the same pixels on every machine
  osmesa,      ///< OpenGL shaders on OSMesa's llvmpipe: no pixel differs by more than rounding
};

std::string_view to_string(Rasteriser rasteriser);

}  // namespace wuerfel
