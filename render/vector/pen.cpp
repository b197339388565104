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

Pen::Point point(Pixel pixel) {
  return {static_cast<double>(pixel.x), static_cast<double>(pixel.y)};
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
  const Point center = point(box.center);
  const Point axis = point(box.axis);
  const auto corners = [&](double inset) {
    const double half_width = static_cast<double>(box.half_size.x) - inset;
    const double half_height = static_cast<double>(box.half_size.y) - inset;
    const auto corner = [&](double u, double v) {
      return Point{center.x + u * half_width * axis.x - v * half_height * axis.y,
                   center.y + u * half_width * axis.y + v * half_height * axis.x};
    };
    return std::array<Point, 4>{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
  };
  source(box.fill);
  polygon(corners(0.0));
  cairo_.fill(context_);
  source(box.outline);
  const auto width = static_cast<double>(box.outline_width);
  if (box.diagonal_width > 0.0F) {
    const auto ends = corners(width);
    line(ends[0], ends[2], static_cast<double>(box.diagonal_width), CAIRO_LINE_CAP_BUTT);
    line(ends[1], ends[3], static_cast<double>(box.diagonal_width), CAIRO_LINE_CAP_BUTT);
  }
  if (width <= 0.0) return;
  polygon(corners(0.5 * width));
  stroke(width, CAIRO_LINE_CAP_BUTT, CAIRO_LINE_JOIN_MITER);
}

void Pen::draw(const SegmentShape& segment) {
  source(segment.color);
  line(point(segment.from), point(segment.to), 2.0 * static_cast<double>(segment.half_width),
       segment.round > 0.5F ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
}

void Pen::draw(const ArrowShape& arrow) {
  const Point tail = point(arrow.tail);
  const Point tip = point(arrow.tip);
  const double length = std::hypot(tip.x - tail.x, tip.y - tail.y);
  const Point along{(tip.x - tail.x) / length, (tip.y - tail.y) / length};
  const auto half_width = static_cast<double>(arrow.half_width);
  const auto head = static_cast<double>(arrow.head_length);
  const auto wing = static_cast<double>(arrow.head_half_width);
  const double notch = 0.25 * head;
  const double base = length - head;
  // Where the shaft meets the swept-back edge of the head.
  const double neck = base + notch * (1.0 - half_width / wing);
  const std::array<Point, 7> outline{{{0.0, half_width},
                                      {neck, half_width},
                                      {base, wing},
                                      {length, 0.0},
                                      {base, -wing},
                                      {neck, -half_width},
                                      {0.0, -half_width}}};
  std::array<Point, 7> corners{};
  std::ranges::transform(outline, corners.begin(), [&](Point p) {
    return Point{tail.x + p.x * along.x - p.y * along.y, tail.y + p.x * along.y + p.y * along.x};
  });
  source(arrow.color);
  polygon(corners);
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
  const std::array<Point, 3> corners{point(triangle.a), point(triangle.b), point(triangle.c)};
  const auto side = [&](std::size_t i) {
    const Point from = corners.at((i + 1) % 3);
    const Point to = corners.at((i + 2) % 3);
    return std::hypot(to.x - from.x, to.y - from.y);
  };
  const double perimeter = side(0) + side(1) + side(2);
  Point incenter;
  for (std::size_t i = 0; i < 3; ++i) {
    incenter.x += side(i) / perimeter * corners.at(i).x;
    incenter.y += side(i) / perimeter * corners.at(i).y;
  }
  const double area = 0.5
                      * std::abs((corners[1].x - corners[0].x) * (corners[2].y - corners[0].y)
                                 - (corners[1].y - corners[0].y) * (corners[2].x - corners[0].x));
  const double radius = 2.0 * area / perimeter;
  const auto width = static_cast<double>(triangle.outline_width);
  // A triangle moved inwards on all sides is a smaller one about the incentre.
  const auto inset = [&](double by) {
    std::array<Point, 3> moved{};
    const double shrink = std::max(0.0, 1.0 - by / radius);
    std::ranges::transform(corners, moved.begin(), [&](Point p) {
      return Point{incenter.x + shrink * (p.x - incenter.x),
                   incenter.y + shrink * (p.y - incenter.y)};
    });
    return moved;
  };
  source(triangle.fill);
  polygon(inset(width));
  cairo_.fill(context_);
  if (width <= 0.0) return;
  source(triangle.outline);
  polygon(inset(0.5 * width));
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
