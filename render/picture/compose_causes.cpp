// Why a scene falls and what would help: what fails, the corner that it tips over, how far its centre
// of mass is beside it, and changes that make it stand; in words above and below.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "render/picture/hud.h"

namespace wuerfel::internal {
namespace {

// Pixels of a 1280x720 picture.
constexpr double part_outline = 4.5;
constexpr double ghost_outline = 2.2;
constexpr double centre_radius = 6.5;
constexpr double corner_radius = 5.5;
constexpr double lever_width = 5.0;
constexpr double arrow_length = 64.0;
constexpr double least_way = 24.0;  ///< shorter ways are shown by an arrow of this length
constexpr double dash = 7.0;
constexpr double label_distance = 9.0;

constexpr double ghost_fill = 0.16;
constexpr double motion_length = 0.6;  ///< of the smaller side, for the cube that moves most

Color failing(const FrameParts& parts) { return parts.style.contact; }
Color helping(const FrameParts& parts) { return parts.style.positive_side; }

void frame_box(
    const FrameParts& parts, const SnapshotBox& box, double width, Color line, Color fill) {
  const double ppm = parts.view.pixels_per_metre;
  BoxShape shape;
  shape.center = parts.pixel(box.center);
  shape.axis = {static_cast<float>(std::cos(box.angle)), static_cast<float>(-std::sin(box.angle))};
  shape.half_size = {static_cast<float>(0.5 * box.size.x() * ppm),
                     static_cast<float>(0.5 * box.size.y() * ppm)};
  const float smaller = std::min(shape.half_size.x, shape.half_size.y);
  shape.outline_width = std::min(parts.weight(width), 0.3F * smaller);
  shape.outline = line;
  shape.fill = fill;
  parts.list.add(shape);
}

void disc(const FrameParts& parts, const Vec2& at, double radius, Color fill, Color outline) {
  DiscShape shape;
  shape.center = parts.pixel(at);
  shape.radius = parts.weight(radius);
  shape.outline_width = parts.weight(0.3 * radius);
  shape.fill = fill;
  shape.outline = outline;
  parts.list.add(shape);
  parts.labels.keep_off(shape.center, shape.center, static_cast<double>(shape.radius));
}

void stroke(const FrameParts& parts, Pixel from, Pixel to, double width, Color color) {
  SegmentShape shape;
  shape.from = from;
  shape.to = to;
  shape.half_width = 0.5F * parts.weight(width);
  shape.color = color;
  parts.list.add(shape);
  parts.labels.keep_off(from, to, static_cast<double>(shape.half_width));
}

void dashed(const FrameParts& parts, const Vec2& from, const Vec2& to, Color color) {
  const double length = (to - from).norm() * parts.view.pixels_per_metre;
  const int dashes = static_cast<int>(length / (2.0 * parts.unit * dash));
  for (int i = 0; i < dashes; ++i) {
    const double start = (i + 0.25) / dashes;
    const double end = (i + 0.75) / dashes;
    stroke(parts, parts.pixel(from + start * (to - from)), parts.pixel(from + end * (to - from)),
           2.0, color);
  }
}

Pixel moved(Pixel p, const Vec2& way) {
  return {p.x + static_cast<float>(way.x()), p.y + static_cast<float>(way.y())};
}

/// An arrow of a direction in the world, `length` px, from a place on.
ArrowShape arrow(
    const FrameParts& parts, const Vec2& at, const Vec2& way, double length, Color color) {
  const Vec2 direction = way.normalized();
  const Pixel tail = parts.pixel(at);
  return styled_arrow(parts, tail, moved(tail, length * Vec2(direction.x(), -direction.y())),
                      color);
}

/// A label beside a place, wherever there is room; below it first.
void label(const FrameParts& parts, const std::string& text, Pixel at, Color color) {
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

/// The part that fails: its weight, and the corner that does not carry it.
void add_part(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  const SnapshotReason& reason = *parts.snapshot.reason;
  for (const int box : reason.part)
    frame_box(parts, parts.snapshot.boxes[box], part_outline, failing(parts),
              with_alpha(failing(parts), 0.0));
  if (!reason.centre) return;
  if (reason.corner && reason.beside) {
    dashed(parts, *reason.centre, *reason.beside, failing(parts));
    stroke(parts, parts.pixel(*reason.corner), parts.pixel(*reason.beside), lever_width,
           failing(parts));
    disc(parts, *reason.corner, corner_radius, failing(parts), failing(parts));
  }
  arrows.push_back({arrow(parts, *reason.centre, parts.snapshot.gravity, arrow_length * parts.unit,
                          failing(parts))});
}

void add_motion(const FrameParts& parts, std::vector<PendingArrow>& arrows) {
  for (const SnapshotReason::Motion& motion : parts.snapshot.reason->motion) {
    const SnapshotBox& box = parts.snapshot.boxes[motion.box];
    frame_box(parts, box, part_outline, failing(parts), with_alpha(failing(parts), 0.0));
    const Vec2 way = motion_length * box.size.minCoeff() * motion.way;
    const double length = way.norm() * parts.view.pixels_per_metre;
    if (length > 2.0) arrows.push_back({arrow(parts, box.center, way, length, failing(parts))});
  }
}

/// Where the label of a fix belongs.
Pixel add_fix(const FrameParts& parts,
              const SnapshotReason::Fix& fix,
              std::vector<PendingArrow>& arrows) {
  const Color color = helping(parts);
  if (fix.moved.empty()) {  // it pushes: inside the picture, where the bodies are
    const double length = arrow_length * parts.unit;
    const Vec2 tail = fix.point - parts.metres(length) * fix.force.normalized();
    arrows.push_back({arrow(parts, tail, fix.force, length, color)});
    return arrows.back().shape.tail;
  }
  for (const int number : fix.moved) {
    SnapshotBox box = parts.snapshot.boxes[number];
    box.center += fix.way;
    frame_box(parts, box, ghost_outline, color, with_alpha(color, ghost_fill));
  }
  const double length =
      std::max(fix.way.norm() * parts.view.pixels_per_metre, least_way * parts.unit);
  arrows.push_back({arrow(parts, fix.point, fix.way, length, color)});
  return arrows.back().shape.tip;
}

/// Lines from a baseline on, each as small as it has to be.
void add_lines(const FrameParts& parts,
               const std::vector<std::string>& lines,
               double y,
               bool title) {
  const double x = hud_margin * parts.unit;
  const double room = parts.view.width - 2.0 * x;
  HudText text(parts);
  bool first = title;
  for (const std::string& line : lines) {
    const double full = (first ? parts.style.title_size : parts.style.text_size) * parts.unit;
    const double size = full * std::min(1.0, room / parts.font.width(line, full));
    y += 0.78 * full;
    text.add(line, x, y, size, parts.style.ink);
    y += 0.55 * full;
    first = false;
  }
  text.paint();
}

}  // namespace

void add_reason(const FrameParts& parts) {
  const SnapshotReason& reason = *parts.snapshot.reason;
  std::vector<PendingArrow> arrows;
  std::vector<Pixel> places;
  for (const SnapshotReason::Fix& fix : reason.fixes)
    places.push_back(add_fix(parts, fix, arrows));
  add_part(parts, arrows);
  add_motion(parts, arrows);
  paint_arrows(parts, arrows);
  for (const PendingArrow& a : arrows)
    parts.labels.keep_off(a.shape.tail, a.shape.tip, static_cast<double>(a.shape.head_half_width));
  if (reason.centre)
    disc(parts, *reason.centre, centre_radius, with_alpha(parts.style.halo, 1.0), failing(parts));
  if (reason.corner && reason.beside)
    label(parts, reason.label, parts.pixel(0.5 * (*reason.corner + *reason.beside)),
          failing(parts));
  for (std::size_t i = 0; i < places.size(); ++i)
    label(parts, reason.fixes[i].label, places[i], helping(parts));
}

void add_reason_text(const FrameParts& parts) {
  const SnapshotReason& reason = *parts.snapshot.reason;
  const double margin = hud_margin * parts.unit;
  add_lines(parts, reason.headlines, margin, true);
  const double line = 1.33 * parts.style.text_size * parts.unit;
  const double height = line * static_cast<double>(reason.advice.size());
  add_lines(parts, reason.advice, parts.view.height - margin - height, false);
}

}  // namespace wuerfel::internal
