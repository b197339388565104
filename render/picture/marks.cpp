#include "render/picture/marks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "render/picture/view.h"

namespace wuerfel::internal {
namespace {

constexpr double dash = 7.0;            ///< px of a 1280x720 picture
constexpr double label_distance = 9.0;  ///< px

}  // namespace

BoxShape box_shape(const View& view, const SnapshotBox& box) {
  const double ppm = view.pixels_per_metre;
  const Vec2 center = view.to_pixel(box.center);
  BoxShape shape;
  shape.center = {static_cast<float>(center.x()), static_cast<float>(center.y())};
  const Vec2 axis = axis_of(box);
  shape.axis = {static_cast<float>(axis.x()), static_cast<float>(-axis.y())};
  shape.half_size = {static_cast<float>(0.5 * box.size.x() * ppm),
                     static_cast<float>(0.5 * box.size.y() * ppm)};
  return shape;
}

void add_strokes(const FrameParts& parts, const std::vector<SegmentShape>& strokes) {
  for (SegmentShape halo : strokes) {
    halo.half_width += parts.weight(parts.style.halo_width);
    halo.color = parts.style.halo;
    if (halo.color.a > 0) parts.list.add(halo);
  }
  for (const SegmentShape& stroke : strokes)
    parts.list.add(stroke);
}

void frame_box(
    const FrameParts& parts, const SnapshotBox& box, double width, Color line, Color fill) {
  BoxShape shape = box_shape(parts.view, box);
  const float smaller = std::min(shape.half_size.x, shape.half_size.y);
  shape.outline_width = std::min(parts.weight(width), 0.3F * smaller);
  shape.outline = line;
  shape.fill = fill;
  parts.list.add(shape);
}

void add_disc(const FrameParts& parts, const Vec2& at, double radius, Color fill, Color outline) {
  DiscShape shape;
  shape.center = parts.pixel(at);
  shape.radius = parts.weight(radius);
  shape.outline_width = parts.weight(0.3 * radius);
  shape.fill = fill;
  shape.outline = outline;
  parts.list.add(shape);
  parts.labels.keep_off(shape.center, shape.center, static_cast<double>(shape.radius));
}

void add_stroke(const FrameParts& parts, Pixel from, Pixel to, double width, Color color) {
  SegmentShape shape;
  shape.from = from;
  shape.to = to;
  shape.half_width = 0.5F * parts.weight(width);
  shape.color = color;
  parts.list.add(shape);
  parts.labels.keep_off(from, to, static_cast<double>(shape.half_width));
}

void add_dashes(
    const FrameParts& parts, const Vec2& from, const Vec2& to, double width, Color color) {
  const double length = (to - from).norm() * parts.view.pixels_per_metre;
  const int dashes = std::max(1, static_cast<int>(length / (2.0 * parts.unit * dash)));
  for (int i = 0; i < dashes; ++i) {
    const Vec2 start = from + (i + 0.25) / dashes * (to - from);
    const Vec2 end = from + (i + 0.75) / dashes * (to - from);
    add_stroke(parts, parts.pixel(start), parts.pixel(end), width, color);
  }
}

Pixel moved(Pixel p, const Vec2& way) {
  return {p.x + static_cast<float>(way.x()), p.y + static_cast<float>(way.y())};
}

ArrowShape arrow_from(
    const FrameParts& parts, const Vec2& at, const Vec2& way, double length, Color color) {
  const Vec2 direction = way.normalized();
  const Pixel tail = parts.pixel(at);
  return styled_arrow(parts, tail, moved(tail, length * Vec2(direction.x(), -direction.y())),
                      color);
}

void add_label(const FrameParts& parts, const std::string& text, Pixel at, Color color) {
  if (text.empty()) return;
  TextShape shape;
  shape.text = text;
  shape.size = static_cast<float>(1.1 * parts.style.text_size * parts.unit);
  shape.color = mix(color, parts.style.ink, 0.35);
  shape.halo = parts.style.halo;
  shape.halo_width = static_cast<float>(2.0 * parts.unit);
  const auto size = static_cast<double>(shape.size);
  const double width = parts.font.width(text, size);
  std::vector<Pixel> places;
  for (const double away : {1.0, 2.5, 4.5}) {
    const double gap = away * label_distance * parts.unit;
    places.push_back(moved(at, {-0.5 * width, gap + 0.76 * size}));
    places.push_back(moved(at, {gap, 0.3 * size}));
    places.push_back(moved(at, {-0.5 * width, -gap}));
    places.push_back(moved(at, {-gap - width, 0.3 * size}));
  }
  parts.labels.place(shape, places, parts.font, parts.list);
}

}  // namespace wuerfel::internal
