/// The shaders of assets/, which are built into the program (embedded.S).
#pragma once

#include <string_view>

#include "render/picture/draw_list.h"

namespace wuerfel::internal {

struct ShaderSource {
  std::string_view vertex;
  std::string_view fragment;
};

/// GLSL 3.30 for shapes of this kind.
ShaderSource embedded_shader(ShapeKind kind);

}  // namespace wuerfel::internal
