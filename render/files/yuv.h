/// RGB to planar YUV 4:2:0 as video wants it: ITU-R BT.709, limited range (Y 16..235, U and
/// V 16..240), chroma averaged over 2x2 pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/raster/image.h"

namespace wuerfel::internal {

/// Next even number: what 4:2:0 needs.
constexpr int even_size(int size) { return size + size % 2; }

/// Appends Y, U and V of `image` to `planes`. An odd last row or column is repeated. Alpha is
/// ignored.
void append_yuv420(const Image& image, std::vector<std::uint8_t>& planes);

}  // namespace wuerfel::internal
