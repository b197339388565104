/// The files of assets/ that are built into the program (embedded.S).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "render/draw_list.h"

namespace wuerfel {

/// DejaVu Sans as a TrueType file.
std::span<const std::uint8_t> embedded_font();

struct ShaderSource {
  std::string_view vertex;
  std::string_view fragment;
};

/// GLSL 3.30 for shapes of this kind.
ShaderSource embedded_shader(ShapeKind kind);

}  // namespace wuerfel
