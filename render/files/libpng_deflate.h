/// Pictures compressed by libpng: the encoder that is everywhere.
#pragma once

#include <cstdint>
#include <vector>

#include "render/raster/image.h"

namespace wuerfel::internal {

/// The zlib stream of PNG's image data without filters, at zlib's level 1.
std::vector<std::uint8_t> libpng_deflate(const Image& image, bool alpha);

}  // namespace wuerfel::internal
