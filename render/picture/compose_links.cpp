// Rods between bodies, pins and point masses. A rod that pulls is one stroke, a rod that pushes two
// beside each other; with the layer rod-forces strokes are as wide as forces are large.
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

constexpr double plain_rod = 2.6;
constexpr double thinnest_rod = 1.6;
constexpr double thickest_rod = 9.0;
constexpr double least_gap = 1.6;        ///< between the strokes of a rod that pushes
constexpr double rounding_share = 1e-9;  ///< of the largest force, that pulls nor pushes
constexpr double pin_radius = 4.6;
constexpr double largest_mass_radius = 9.0;
constexpr double smallest_mass_radius = 3.0;

/// The force that makes a rod as wide as it gets, N.
double full_force(const FrameParts& parts) {
  double full = parts.options.full_rod_force;
  if (full > 0.0) return full;
  for (const SnapshotLink& link : parts.snapshot.links)
    full = std::max(full, std::abs(link.tension));
  return full;
}

/// Strokes of a rod by its force: one, or two beside each other.
void add_strokes(const FrameParts& parts,
                 const SnapshotLink& rod,
                 double full,
                 std::vector<SegmentShape>& strokes) {
  SegmentShape stroke;
  stroke.from = parts.pixel(rod.a);
  stroke.to = parts.pixel(rod.b);
  stroke.half_width = 0.5F * parts.weight(plain_rod);
  stroke.color = parts.style.rod;
  const bool bears = parts.has(Layer::rod_forces) && std::abs(rod.tension) > rounding_share * full;
  if (!bears) {
    if (parts.has(Layer::rod_forces)) stroke.half_width = 0.5F * parts.weight(thinnest_rod);
    strokes.push_back(stroke);
    return;
  }
  const double share = std::min(std::abs(rod.tension) / full, 1.0);
  const double width = thinnest_rod + (thickest_rod - thinnest_rod) * share;
  if (rod.tension > 0.0) {
    stroke.half_width = 0.5F * parts.weight(width);
    stroke.color = parts.style.tension;
    strokes.push_back(stroke);
    return;
  }
  stroke.half_width = 0.25F * parts.weight(width);
  stroke.color = parts.style.compression;
  const float dx = stroke.to.x - stroke.from.x;
  const float dy = stroke.to.y - stroke.from.y;
  const float aside =
      (stroke.half_width + 0.5F * parts.weight(least_gap)) / std::max(std::hypot(dx, dy), 1e-6F);
  for (const float side : {-aside, aside}) {
    SegmentShape half = stroke;
    for (Pixel* end : {&half.from, &half.to}) {
      end->x -= side * dy;
      end->y += side * dx;
    }
    strokes.push_back(half);
  }
}

void add_pins(const FrameParts& parts) {
  DiscShape ring;
  ring.radius = parts.weight(pin_radius);
  ring.outline_width = parts.weight(1.6);
  ring.fill = parts.style.joint;
  ring.outline = parts.style.rod;
  for (const SnapshotLink& link : parts.snapshot.links) {
    if (!link.pin) continue;
    ring.center = parts.pixel(link.a);
    parts.list.add(ring);
    if (link.a == link.b) continue;  // but of a free-body diagram
    ring.center = parts.pixel(link.b);
    parts.list.add(ring);
  }
}

/// Where rods hold bodies, or are fixed: small, so that they differ from pins.
void add_rod_ends(const FrameParts& parts) {
  DiscShape end;
  end.radius = parts.weight(2.6);
  end.outline_width = parts.weight(1.0);
  end.fill = parts.style.rod;
  end.outline = parts.style.rod;
  for (const SnapshotLink& link : parts.snapshot.links) {
    if (link.pin) continue;
    for (const Vec2& place : {link.a, link.b}) {
      end.center = parts.pixel(place);
      parts.list.add(end);
    }
  }
}

void add_masses(const FrameParts& parts) {
  double heaviest = 0.0;
  for (const SnapshotMass& mass : parts.snapshot.masses)
    heaviest = std::max(heaviest, mass.mass);
  for (const SnapshotMass& mass : parts.snapshot.masses) {
    DiscShape disc;
    disc.center = parts.pixel(mass.position);
    disc.outline_width = parts.weight(1.2);
    disc.fill = parts.style.mass;
    disc.outline = parts.style.joint;
    disc.radius = parts.weight(
        std::max(largest_mass_radius * std::sqrt(mass.mass / heaviest), smallest_mass_radius));
    parts.list.add(disc);
  }
}

}  // namespace

void add_links(const FrameParts& parts) {
  const double full = full_force(parts);
  std::vector<SegmentShape> strokes;
  for (const SnapshotLink& link : parts.snapshot.links)
    if (!link.pin) add_strokes(parts, link, full, strokes);
  for (SegmentShape halo : strokes) {
    halo.half_width += parts.weight(parts.style.halo_width);
    halo.color = parts.style.halo;
    if (halo.color.a > 0) parts.list.add(halo);
  }
  for (const SegmentShape& stroke : strokes)
    parts.list.add(stroke);
  add_rod_ends(parts);
  add_pins(parts);
  add_masses(parts);
}

}  // namespace wuerfel::internal
