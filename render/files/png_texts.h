/// The texts of PNG files: tEXt, zTXt and iTXt chunks (PNG specification, section 11.3.4).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/files/png.h"
#include "render/files/png_chunks.h"

namespace wuerfel::internal {

/// Appends the chunk of one text.
void append_text(const PngText& text, std::vector<std::uint8_t>& file);

/// All texts among the chunks of a file. libpng would drop those of more than 8 000 000 bytes
/// without a word, and read any number below that. Throws RenderError on damaged ones and where all
/// together take more than `room` bytes.
std::vector<PngText> read_texts(std::span<const PngChunk> chunks, std::size_t room);

}  // namespace wuerfel::internal
