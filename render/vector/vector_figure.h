/// Vector figures: the same draw list as SVG or PDF, for papers. Cairo is loaded when the first one
/// is made.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/files/png.h"
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

/// What a figure says besides what it shows.
struct FigureTexts {
  std::string title;
  std::string description;
  std::vector<PngText> origin;      ///< what it was made from, as in PNG files
  std::vector<std::string> bodies;  ///< names, by BoxShape::body
  double width_mm = 0.0;            ///< on paper; 0: 96 pixels to the inch
};

/// The bytes of the file: `list`, and `insets` on top of it. One pixel of the list is one pixel of
/// the SVG and 3/4 point of the PDF (96 to the inch), unless a width is given. Text stays text, in
/// the PDF with the letters used embedded. No creation date: the same list gives the same bytes.
/// Throws LibraryError where Cairo is missing, which PDF needs.
std::vector<std::uint8_t> encode_vector_figure(const DrawList& list,
                                               VectorFormat format,
                                               Font& font,
                                               std::span<const PlacedList> insets = {},
                                               const FigureTexts& texts = {});

/// The texts of the origin of an SVG file; none where it carries none. Throws RenderError where they
/// are damaged.
std::vector<PngText> read_origin(std::string_view svg);

}  // namespace wuerfel
