#include "render/vector/vector_figure.h"

#include <algorithm>
#include <string_view>

#include "render/error.h"
#include "render/vector/cairo_library.h"
#include "render/vector/pen.h"

namespace wuerfel {
namespace {

constexpr double points_per_pixel = 0.75;

cairo_status_t append(void* target, const unsigned char* bytes, unsigned int count) {
  auto* file = static_cast<std::vector<std::uint8_t>*>(target);
  file->insert(file->end(), bytes, bytes + count);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_surface(const internal::CairoLibrary& cairo,
                              const DrawList& list,
                              VectorFormat format,
                              std::vector<std::uint8_t>& file) {
  if (format == VectorFormat::pdf) {
    return cairo.pdf_surface_create_for_stream(append, &file, list.width * points_per_pixel,
                                               list.height * points_per_pixel);
  }
  cairo_surface_t* surface =
      cairo.svg_surface_create_for_stream(append, &file, list.width, list.height);
  cairo.svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
  return surface;
}

/// Takes the entry out of a PDF and keeps all offsets: blanks in its place.
void blank_creation_date(std::vector<std::uint8_t>& pdf) {
  constexpr std::string_view key = "/CreationDate (";
  const auto found = std::search(pdf.begin(), pdf.end(), key.begin(), key.end());
  if (found == pdf.end()) return;
  const auto end = std::find(found, pdf.end(), static_cast<std::uint8_t>(')'));
  if (end != pdf.end()) std::fill(found, end + 1, static_cast<std::uint8_t>(' '));
}

/// Cairo numbers its surfaces through the life of a process.
void name_picture(std::vector<std::uint8_t>& svg) {
  constexpr std::string_view key = "<g id=\"surface";
  constexpr std::string_view name = "<g id=\"picture";
  const auto found = std::search(svg.begin(), svg.end(), key.begin(), key.end());
  if (found == svg.end()) return;
  const auto digits = std::copy(name.begin(), name.end(), found);
  svg.erase(digits, std::find(digits, svg.end(), static_cast<std::uint8_t>('"')));
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
                                               std::span<const PlacedList> insets) {
  const internal::CairoLibrary& cairo = internal::cairo_library();
  std::vector<std::uint8_t> file;
  cairo_surface_t* surface = make_surface(cairo, list, format, file);
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  {
    internal::Pen pen(cairo, surface, font);
    if (format == VectorFormat::pdf) pen.scale(points_per_pixel);
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
  if (format == VectorFormat::pdf) {
    blank_creation_date(file);
  } else {
    name_picture(file);
  }
  return file;
}

}  // namespace wuerfel
