#include "render/vector/pen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

namespace wuerfel::internal {
namespace {

void delete_font(void* font) { std::unique_ptr<Font>(static_cast<Font*>(font)).reset(); }

/// The shipped font for Cairo, with a FreeType face of its own: Cairo changes its size, and may
/// keep it after we are done.
cairo_font_face_t* make_face(const CairoLibrary& cairo) {
  static const cairo_user_data_key_t key{};
  auto font = std::make_unique<Font>();
  cairo_font_face_t* face = cairo.ft_font_face_create_for_ft_face(font->face(), 0);
  if (cairo.font_face_set_user_data(face, &key, font.get(), delete_font) == CAIRO_STATUS_SUCCESS) {
    static_cast<void>(font.release());
  }
  return face;
}

}  // namespace

Pen::Pen(const CairoLibrary& cairo, cairo_surface_t* surface, Font& font)
    : cairo_(cairo), context_(cairo.create(surface)), face_(make_face(cairo)), font_(font) {
  cairo_.set_font_face(context_, face_);
}

Pen::~Pen() {
  cairo_.destroy(context_);
  cairo_.font_face_destroy(face_);
}

void Pen::scale(double factor) { cairo_.scale(context_, factor, factor); }

void Pen::draw(const DrawList& list, int x, int y) {
  cairo_.save(context_);
  cairo_.translate(context_, x, y);
  cairo_.rectangle(context_, 0.0, 0.0, list.width, list.height);
  cairo_.clip(context_);
  if (list.background.a != 0) {
    source(list.background);
    cairo_.rectangle(context_, 0.0, 0.0, list.width, list.height);
    cairo_.fill(context_);
  }
  for (const ShapeRun& run : list.runs)
    draw_run(list, run);
  for (const TextShape& text : list.texts)
    draw(text);
  cairo_.restore(context_);
}

void Pen::source(Color color) {
  cairo_.set_source_rgba(context_, color.r / 255.0, color.g / 255.0, color.b / 255.0,
                         color.a / 255.0);
}

void Pen::polygon(std::span<const Point> corners) {
  cairo_.new_path(context_);
  for (const Point& corner : corners)
    cairo_.line_to(context_, corner.x, corner.y);
  cairo_.close_path(context_);
}

void Pen::stroke(double width, cairo_line_cap_t cap, cairo_line_join_t join) {
  cairo_.set_line_width(context_, width);
  cairo_.set_line_cap(context_, cap);
  cairo_.set_line_join(context_, join);
  cairo_.stroke(context_);
}

void Pen::line(Point from, Point to, double width, cairo_line_cap_t cap) {
  cairo_.new_path(context_);
  cairo_.move_to(context_, from.x, from.y);
  cairo_.line_to(context_, to.x, to.y);
  stroke(width, cap, CAIRO_LINE_JOIN_MITER);
}

void Pen::draw(const BoxShape& box) {
  const auto width = static_cast<double>(box.outline_width);
  source(box.fill);
  polygon(corners(box, 0.0));
  cairo_.fill(context_);
  source(box.outline);
  if (box.diagonal_width > 0.0F) {
    const auto ends = corners(box, width);
    line(ends[0], ends[2], static_cast<double>(box.diagonal_width), CAIRO_LINE_CAP_BUTT);
    line(ends[1], ends[3], static_cast<double>(box.diagonal_width), CAIRO_LINE_CAP_BUTT);
  }
  if (width <= 0.0) return;
  polygon(corners(box, 0.5 * width));
  stroke(width, CAIRO_LINE_CAP_BUTT, CAIRO_LINE_JOIN_MITER);
}

void Pen::draw(const SegmentShape& segment) {
  source(segment.color);
  line(point(segment.from), point(segment.to), 2.0 * static_cast<double>(segment.half_width),
       segment.round > 0.5F ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
}

void Pen::draw(const ArrowShape& arrow) {
  source(arrow.color);
  polygon(outline(arrow));
  if (arrow.grow <= 0.0F) {
    cairo_.fill(context_);
    return;
  }
  cairo_.fill_preserve(context_);
  stroke(2.0 * static_cast<double>(arrow.grow), CAIRO_LINE_CAP_BUTT, CAIRO_LINE_JOIN_MITER);
}

void Pen::draw(const DiscShape& disc) {
  const Point center = point(disc.center);
  const auto radius = static_cast<double>(disc.radius);
  const auto width = static_cast<double>(disc.outline_width);
  const auto circle = [&](double r) {
    cairo_.new_path(context_);
    cairo_.arc(context_, center.x, center.y, r, 0.0, 2.0 * std::numbers::pi);
  };
  source(disc.fill);
  circle(radius);
  cairo_.fill(context_);
  if (width <= 0.0) return;
  source(disc.outline);
  circle(radius - 0.5 * width);
  stroke(width, CAIRO_LINE_CAP_BUTT, CAIRO_LINE_JOIN_MITER);
}

void Pen::draw(const TriangleShape& triangle) {
  const auto width = static_cast<double>(triangle.outline_width);
  source(triangle.fill);
  polygon(corners(triangle, width));
  cairo_.fill(context_);
  if (width <= 0.0) return;
  source(triangle.outline);
  polygon(corners(triangle, 0.5 * width));
  stroke(width, CAIRO_LINE_CAP_BUTT, CAIRO_LINE_JOIN_MITER);
}

void Pen::draw(const TextShape& text) {
  const auto size = static_cast<double>(text.size);
  cairo_.set_font_size(context_, size);
  std::vector<cairo_glyph_t> glyphs;
  std::vector<cairo_text_cluster_t> clusters;
  double pen = static_cast<double>(text.baseline.x);
  for (std::size_t at = 0; at < text.text.size();) {
    const std::size_t start = at;
    const char32_t letter = next_code_point(text.text, at);
    std::size_t peek = at;
    const char32_t next = at < text.text.size() ? next_code_point(text.text, peek) : 0;
    glyphs.push_back({font_.glyph_index(letter), pen, static_cast<double>(text.baseline.y)});
    clusters.push_back({static_cast<int>(at - start), 1});
    pen += font_.advance(letter, next, size);
  }
  const auto count = static_cast<int>(glyphs.size());
  if (text.halo_width > 0.0F && text.halo.a > 0) {
    source(text.halo);
    cairo_.new_path(context_);
    cairo_.glyph_path(context_, glyphs.data(), count);
    stroke(2.0 * static_cast<double>(text.halo_width), CAIRO_LINE_CAP_ROUND, CAIRO_LINE_JOIN_ROUND);
  }
  source(text.color);
  cairo_.show_text_glyphs(context_, text.text.data(), static_cast<int>(text.text.size()),
                          glyphs.data(), count, clusters.data(), count, {});
}

void Pen::draw_run(const DrawList& list, const ShapeRun& run) {
  const auto draw_all = [this, &run](const auto& shapes) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i)
      draw(shapes[i]);
  };
  switch (run.kind) {
    case ShapeKind::box:
      draw_all(list.boxes);
      break;
    case ShapeKind::segment:
      draw_all(list.segments);
      break;
    case ShapeKind::arrow:
      draw_all(list.arrows);
      break;
    case ShapeKind::disc:
      draw_all(list.discs);
      break;
    case ShapeKind::triangle:
      draw_all(list.triangles);
      break;
  }
}

}  // namespace wuerfel::internal
