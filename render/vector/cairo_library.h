/// The functions of Cairo that are used, found at run time: Cairo brings X libraries along that
/// most commands don't need.
#pragma once

#include <cairo/cairo-ft.h>
#include <cairo/cairo-pdf.h>

namespace wuerfel::internal {

// clang-format off
#define WUERFEL_CAIRO_FUNCTIONS(X)                                                                      \
  X(arc) X(clip) X(close_path) X(create) X(destroy) X(fill) X(fill_preserve) X(font_face_destroy) X(font_face_set_user_data)        \
  X(ft_font_face_create_for_ft_face) X(glyph_path) X(line_to) X(move_to) X(new_path)                     \
  X(pdf_surface_create_for_stream) X(rectangle) X(restore) X(save) X(scale) X(set_font_face)    \
  X(set_font_size) X(set_line_cap) X(set_line_join) X(set_line_width) X(set_miter_limit)                 \
  X(set_source_rgba) X(show_text_glyphs) X(status) X(status_to_string) X(stroke) X(surface_destroy)      \
  X(surface_finish) X(pdf_surface_set_metadata) X(translate)
// clang-format on

struct CairoLibrary {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a member's name cannot stand in parentheses
#define WUERFEL_CAIRO_MEMBER(name) decltype(&::cairo_##name) name = nullptr;
  WUERFEL_CAIRO_FUNCTIONS(WUERFEL_CAIRO_MEMBER)
#undef WUERFEL_CAIRO_MEMBER
};

/// Loads Cairo on the first call and keeps it. Throws LibraryError where it is missing.
const CairoLibrary& cairo_library();

}  // namespace wuerfel::internal
