/// Vector figures: the same draw list as SVG or PDF, for papers. Cairo is loaded when the first one
/// is made.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/draw_list.h"
#include "render/font.h"

namespace wuerfel {

enum class VectorFormat { svg, pdf };

/// True for paths that end in .svg or .pdf.
bool is_vector_path(const std::string& path);

/// The bytes of the file. One pixel of the list is one pixel of the SVG and 3/4 point of the PDF
/// (96 to the inch). Text stays text in the PDF, with the letters used embedded. No creation date:
/// the same list gives the same bytes. Throws RenderError where Cairo is missing.
std::vector<std::uint8_t> encode_vector_figure(const DrawList& list,
                                               VectorFormat format,
                                               Font& font);

/// By the suffix of `path`; the file appears whole or not at all. Throws RenderError and
/// OutputError.
void write_vector_figure(const std::string& path, const DrawList& list, Font& font);

}  // namespace wuerfel
