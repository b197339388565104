#include "render/vector/vector_figure.h"

#include <algorithm>
#include <string_view>

#include "render/error.h"
#include "render/vector/cairo_library.h"
#include "render/vector/pen.h"
#include "render/vector/svg_writer.h"

namespace wuerfel {
namespace {

constexpr double points_per_pixel = 0.75;

cairo_status_t append(void* target, const unsigned char* bytes, unsigned int count) {
  auto* file = static_cast<std::vector<std::uint8_t>*>(target);
  file->insert(file->end(), bytes, bytes + count);
  return CAIRO_STATUS_SUCCESS;
}

/// Takes the entry out of a PDF and keeps all offsets: blanks in its place.
void blank_creation_date(std::vector<std::uint8_t>& pdf) {
  constexpr std::string_view key = "/CreationDate (";
  const auto found = std::search(pdf.begin(), pdf.end(), key.begin(), key.end());
  if (found == pdf.end()) return;
  const auto end = std::find(found, pdf.end(), static_cast<std::uint8_t>(')'));
  if (end != pdf.end()) std::fill(found, end + 1, static_cast<std::uint8_t>(' '));
}

void set_texts(const internal::CairoLibrary& cairo,
               cairo_surface_t* surface,
               const FigureTexts& texts) {
  const auto set = [&](cairo_pdf_metadata_t key, const std::string& value) {
    if (!value.empty()) cairo.pdf_surface_set_metadata(surface, key, value.c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, texts.title);
  // The origin in one entry: a line with the key, then the value.
  std::string origin;
  for (const PngText& text : texts.origin)
    origin += text.key + ": " + text.value + "\n";
  set(CAIRO_PDF_METADATA_SUBJECT, texts.description);
  set(CAIRO_PDF_METADATA_KEYWORDS, origin);
}

std::vector<std::uint8_t> encode_pdf(const DrawList& list,
                                     Font& font,
                                     std::span<const PlacedList> insets,
                                     const FigureTexts& texts) {
  const internal::CairoLibrary& cairo = internal::cairo_library();
  constexpr double points_per_mm = 72.0 / 25.4;
  const double scale =
      texts.width_mm > 0.0 ? texts.width_mm * points_per_mm / list.width : points_per_pixel;
  std::vector<std::uint8_t> file;
  cairo_surface_t* surface =
      cairo.pdf_surface_create_for_stream(append, &file, list.width * scale, list.height * scale);
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  {
    internal::Pen pen(cairo, surface, font);
    set_texts(cairo, surface, texts);
    pen.scale(scale);
    pen.draw(list, 0, 0);
    for (const PlacedList& inset : insets)
      pen.draw(inset.list, inset.x, inset.y);
    status = pen.status();
  }
  cairo.surface_finish(surface);
  cairo.surface_destroy(surface);
  if (status != CAIRO_STATUS_SUCCESS) {
    throw LibraryError(std::string("Cairo cannot draw the figure: ")
                       + cairo.status_to_string(status));
  }
  blank_creation_date(file);
  return file;
}

std::vector<std::uint8_t> encode_svg(const DrawList& list,
                                     std::span<const PlacedList> insets,
                                     const FigureTexts& texts) {
  internal::SvgWriter writer(list.width, list.height, texts);
  writer.add(list, 0, 0, "");
  for (std::size_t i = 0; i < insets.size(); ++i)
    writer.add(insets[i].list, insets[i].x, insets[i].y, "picture" + std::to_string(i + 1) + "-");
  const std::string svg = writer.finish();
  return {svg.begin(), svg.end()};
}

}  // namespace

std::optional<VectorFormat> vector_format(const std::string& path) {
  if (path.ends_with(".svg")) return VectorFormat::svg;
  if (path.ends_with(".pdf")) return VectorFormat::pdf;
  return std::nullopt;
}

std::vector<std::uint8_t> encode_vector_figure(const DrawList& list,
                                               VectorFormat format,
                                               Font& font,
                                               std::span<const PlacedList> insets,
                                               const FigureTexts& texts) {
  return format == VectorFormat::pdf ? encode_pdf(list, font, insets, texts)
                                     : encode_svg(list, insets, texts);
}

std::vector<PngText> read_origin(std::string_view svg) { return internal::origin_of_svg(svg); }

}  // namespace wuerfel
