/// Vector figures: the same draw list as SVG or PDF, for papers. Cairo is loaded when the first one
/// is made.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/picture/draw_list.h"
#include "render/picture/font.h"

namespace wuerfel {

enum class VectorFormat { svg, pdf };

/// By the suffix of a path: .svg or .pdf; nothing for any other.
std::optional<VectorFormat> vector_format(const std::string& path);

/// A picture inside another one.
struct PlacedList {
  DrawList list;
  int x = 0;  ///< px, where its upper left corner lies
  int y = 0;
};

/// The bytes of the file: `list`, and `insets` on top of it. One pixel of the list is one pixel of
/// the SVG and 3/4 point of the PDF (96 to the inch). Text stays text in the PDF, with the letters
/// used embedded. No creation date: the same list gives the same bytes. Throws LibraryError where
/// Cairo is missing.
std::vector<std::uint8_t> encode_vector_figure(const DrawList& list,
                                               VectorFormat format,
                                               Font& font,
                                               std::span<const PlacedList> insets = {});

}  // namespace wuerfel
