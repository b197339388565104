// Cubes and fixed boxes, and what is drawn on them: rods, masses, contacts, the triangles of Eq.
// (2), names.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

constexpr double thickest_rod = 7.0;
constexpr double thinnest_rod = 1.2;
constexpr double largest_mass_radius = 11.0;
constexpr double smallest_name = 0.6;  ///< of the text size

bool visible(const FrameParts& parts, const SnapshotBox& box) {
  const Vec2 p = parts.view.to_pixel(box.center);
  const double reach = 0.5 * box.size.norm() * parts.view.pixels_per_metre + 2.0;
  return p.x() > -reach && p.y() > -reach && p.x() < parts.view.width + reach
         && p.y() < parts.view.height + reach;
}

BoxShape box_shape(const FrameParts& parts, const SnapshotBox& box) {
  const double ppm = parts.view.pixels_per_metre;
  BoxShape shape;
  shape.center = parts.pixel(box.center);
  shape.axis = {static_cast<float>(std::cos(box.angle)), static_cast<float>(-std::sin(box.angle))};
  shape.half_size = {static_cast<float>(0.5 * box.size.x() * ppm),
                     static_cast<float>(0.5 * box.size.y() * ppm)};
  const float smaller = std::min(shape.half_size.x, shape.half_size.y);
  shape.fill = body_color(parts.style, box);
  // Coloured rods want quiet bodies.
  if (parts.has(Layer::rod_forces))
    shape.fill = mix(shape.fill, with_alpha(parts.style.halo, 1.0), 0.6);
  if (box.fixed) {
    shape.outline = parts.style.ground_line;
  } else {
    shape.outline = mix(shape.fill, parts.style.outline, parts.style.outline_shade);
  }
  shape.outline_width = std::min(parts.weight(parts.style.outline_width), 0.2F * smaller);
  // Rods that are not listed one by one are the two diagonals; the sides coincide with the outline.
  if (parts.has(Layer::rods) && parts.snapshot.rods.empty() && !box.fixed) {
    shape.diagonal_width = std::min(parts.weight(1.3), 0.1F * smaller);
  }
  return shape;
}

/// Where rods meet, each place once.
std::vector<Vec2> joints(const std::vector<SnapshotRod>& rods) {
  std::vector<Vec2> ends;
  for (const SnapshotRod& rod : rods) {
    ends.push_back(rod.a);
    ends.push_back(rod.b);
  }
  std::sort(ends.begin(), ends.end(), [](const Vec2& p, const Vec2& q) {
    return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
  });
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

}  // namespace

void add_bodies(const FrameParts& parts) {
  for (const SnapshotBox& box : parts.snapshot.boxes) {
    if (visible(parts, box)) parts.list.add(box_shape(parts, box));
  }
}

void add_rods(const FrameParts& parts) {
  SegmentShape segment;
  segment.half_width = 0.5F * parts.weight(1.8);
  segment.color = parts.style.rod;
  for (const SnapshotRod& rod : parts.snapshot.rods) {
    segment.from = parts.pixel(rod.a);
    segment.to = parts.pixel(rod.b);
    parts.list.add(segment);
  }
  DiscShape joint;
  joint.radius = parts.weight(3.6);
  joint.outline_width = parts.weight(1.4);
  joint.fill = parts.style.joint;
  joint.outline = parts.style.rod;
  for (const Vec2& place : joints(parts.snapshot.rods)) {
    joint.center = parts.pixel(place);
    parts.list.add(joint);
  }
}

void add_rod_forces(const FrameParts& parts) {
  double full = parts.options.full_rod_force;
  if (full <= 0.0) {
    for (const SnapshotRod& rod : parts.snapshot.rods)
      full = std::max(full, std::abs(rod.tension));
  }
  if (full <= 0.0) return;
  std::vector<SegmentShape> strokes;
  for (const SnapshotRod& rod : parts.snapshot.rods) {
    const double share = std::min(std::abs(rod.tension) / full, 1.0);
    SegmentShape segment;
    segment.from = parts.pixel(rod.a);
    segment.to = parts.pixel(rod.b);
    segment.half_width = 0.5F * parts.weight(thinnest_rod + (thickest_rod - thinnest_rod) * share);
    segment.color = rod.tension >= 0.0 ? parts.style.tension : parts.style.compression;
    strokes.push_back(segment);
  }
  for (SegmentShape halo : strokes) {
    halo.half_width += parts.weight(parts.style.halo_width);
    halo.color = parts.style.halo;
    if (halo.color.a > 0) parts.list.add(halo);
  }
  for (const SegmentShape& stroke : strokes)
    parts.list.add(stroke);
}

void add_points(const FrameParts& parts) {
  double heaviest = 0.0;
  for (const SnapshotPoint& point : parts.snapshot.points)
    heaviest = std::max(heaviest, point.mass);
  for (const SnapshotPoint& point : parts.snapshot.points) {
    DiscShape disc;
    disc.center = parts.pixel(point.position);
    disc.radius = parts.weight(largest_mass_radius * std::sqrt(point.mass / heaviest));
    disc.outline_width = parts.weight(1.2);
    disc.fill = parts.style.mass;
    disc.outline = parts.style.joint;
    disc.radius += disc.outline_width;
    parts.list.add(disc);
  }
}

void add_contacts(const FrameParts& parts) {
  for (const SnapshotContact& contact : parts.snapshot.contacts) {
    DiscShape disc;
    disc.center = parts.pixel(contact.p_k);
    disc.radius = parts.weight(4.4);
    disc.outline_width = parts.weight(1.7);
    disc.fill = parts.style.joint;
    disc.outline = parts.style.contact;
    parts.list.add(disc);
  }
}

void add_sides(const FrameParts& parts) {
  for (const SnapshotSide& side : parts.snapshot.sides) {
    const Color color = side.area < 0.0 ? parts.style.negative_side : parts.style.positive_side;
    TriangleShape triangle;
    triangle.a = parts.pixel(side.p_i);
    triangle.b = parts.pixel(side.p_j);
    triangle.c = parts.pixel(side.p_k);
    triangle.outline_width = parts.weight(1.8);
    triangle.fill = with_alpha(color, 0.32);
    triangle.outline = color;
    const double ppm = parts.view.pixels_per_metre;
    const double height =
        std::abs(side.area) / std::max((side.p_j - side.p_i).norm(), 1e-300) * ppm;
    if (static_cast<float>(height) > 2.0F * triangle.outline_width) {
      parts.list.add(triangle);
    } else {
      parts.list.add(SegmentShape{triangle.a, triangle.b, triangle.outline_width, 1.0F, color});
    }
    DiscShape corner;
    corner.radius = parts.weight(3.8);
    corner.fill = color;
    for (const Pixel place : {triangle.a, triangle.b, triangle.c}) {
      corner.center = place;
      parts.list.add(corner);
    }
  }
}

void add_names(const FrameParts& parts) {
  for (const SnapshotBox& box : parts.snapshot.boxes) {
    if (!visible(parts, box) || box.name.empty()) continue;
    const Color fill = body_color(parts.style, box);
    const double full = parts.style.text_size * parts.unit;
    const bool flat = box.size.y() * parts.view.pixels_per_metre > 1.4 * full;
    const double room = 0.86 * parts.view.pixels_per_metre
                        * (flat ? box.size.x() : std::min(box.size.x(), box.size.y()));
    const double width = parts.font.width(box.name, full);
    const double size = full * std::clamp(room / width, smallest_name, 1.0);
    const Pixel center = parts.pixel(box.center);
    TextShape text;
    text.text = box.name;
    text.size = static_cast<float>(size);
    text.baseline = {center.x - static_cast<float>(0.5 * parts.font.width(box.name, size)),
                     center.y + static_cast<float>(0.36 * size)};
    text.color = brightness(fill) > 0.45 ? rgb(0x10161E) : rgb(0xFFFFFF);
    text.halo = fill;
    text.halo_width = static_cast<float>(2.0 * parts.unit);
    parts.list.texts.push_back(text);
  }
}

}  // namespace wuerfel::internal
