/// Pen: draws draw lists with Cairo, for PDF; the counterpart of Renderer and its shaders.
#pragma once

#include <span>

#include "render/picture/draw_list.h"
#include "render/picture/font.h"
#include "render/vector/cairo_library.h"
#include "render/vector/outlines.h"

namespace wuerfel::internal {

class Pen {
 public:
  /// Draws on `surface` with the shipped font; `font` measures the texts.
  Pen(const CairoLibrary& cairo, cairo_surface_t* surface, Font& font);
  ~Pen();
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;
  Pen(Pen&&) = delete;
  Pen& operator=(Pen&&) = delete;

  /// From here on `factor` surface units are one pixel.
  void scale(double factor);
  /// The whole list with its upper left corner at (x, y) pixels; what lies outside it is cut off.
  void draw(const DrawList& list, int x, int y);
  /// Cairo's, of all that was drawn.
  cairo_status_t status() const { return cairo_.status(context_); }

 private:
  void draw(const BoxShape& box);
  void draw(const SegmentShape& segment);
  void draw(const ArrowShape& arrow);
  void draw(const DiscShape& disc);
  void draw(const TriangleShape& triangle);
  void draw(const TextShape& text);
  void draw_run(const DrawList& list, const ShapeRun& run);

  void source(Color color);
  void polygon(std::span<const Point> corners);
  void stroke(double width, cairo_line_cap_t cap, cairo_line_join_t join);
  void line(Point from, Point to, double width, cairo_line_cap_t cap);

  const CairoLibrary& cairo_;
  cairo_t* context_;
  cairo_font_face_t* face_;
  Font& font_;
};

}  // namespace wuerfel::internal
