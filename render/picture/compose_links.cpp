// Rods between bodies, pins and point masses. A rod that pulls is one stroke, a rod that pushes two
// beside each other; with the layer rod-forces strokes are as wide as forces are large.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "render/picture/marks.h"

namespace wuerfel::internal {
namespace {

constexpr double plain_rod = 2.6;
constexpr double thinnest_rod = 1.6;
constexpr double thickest_rod = 9.0;
constexpr double least_gap = 1.6;        ///< between the strokes of a rod that pushes
constexpr double rounding_share = 1e-9;  ///< of the largest force, that pulls nor pushes
constexpr double pin_radius = 4.6;
constexpr double pin_room = 7.0;  ///< around a pin, without labels
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
void include_strokes(const FrameParts& parts,
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
  const auto add = [&](const Vec2& place) {
    ring.center = parts.pixel(place);
    parts.list.add(ring);
    parts.labels.keep_off(ring.center, ring.center, static_cast<double>(parts.weight(pin_room)));
  };
  for (const SnapshotLink& link : parts.snapshot.links) {
    if (!link.pin) continue;
    add(link.a);
    if (link.a != link.b) add(link.b);  // of a free-body diagram
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

double heaviest_mass(const FrameParts& parts) {
  double heaviest = 0.0;
  for (const SnapshotMass& mass : parts.snapshot.masses)
    heaviest = std::max(heaviest, mass.mass);
  return heaviest;
}

float mass_radius(const FrameParts& parts, double mass, double heaviest) {
  return parts.weight(
      std::max(largest_mass_radius * std::sqrt(mass / heaviest), smallest_mass_radius));
}

void add_masses(const FrameParts& parts) {
  const double heaviest = heaviest_mass(parts);
  for (const SnapshotMass& mass : parts.snapshot.masses) {
    DiscShape disc;
    disc.center = parts.pixel(mass.position);
    disc.outline_width = parts.weight(1.2);
    disc.fill = parts.style.mass;
    disc.outline = parts.style.joint;
    disc.radius = mass_radius(parts, mass.mass, heaviest);
    parts.list.add(disc);
  }
}

}  // namespace

void add_links(const FrameParts& parts) {
  const double full = full_force(parts);
  std::vector<SegmentShape> strokes;
  for (const SnapshotLink& link : parts.snapshot.links)
    if (!link.pin) include_strokes(parts, link, full, strokes);
  add_strokes(parts, strokes);
  add_rod_ends(parts);
  add_pins(parts);
  add_masses(parts);
}

/// Names of point masses, beside their discs.
void add_mass_names(const FrameParts& parts) {
  const double heaviest = heaviest_mass(parts);
  for (const SnapshotMass& mass : parts.snapshot.masses) {
    TextShape text;
    text.text = mass.name;
    text.size = static_cast<float>(0.86 * parts.style.text_size * parts.unit);
    text.color = parts.style.ink;
    text.halo = parts.style.halo;
    text.halo_width = static_cast<float>(2.0 * parts.unit);
    const auto width =
        static_cast<float>(parts.font.width(text.text, static_cast<double>(text.size)));
    const Pixel at = parts.pixel(mass.position);
    const float away = mass_radius(parts, mass.mass, heaviest) + 0.3F * text.size;
    const float middle = at.y + 0.36F * text.size;
    const std::vector<Pixel> places{{at.x + away, middle},
                                    {at.x - away - width, middle},
                                    {at.x - 0.5F * width, at.y - away},
                                    {at.x - 0.5F * width, at.y + away + 0.72F * text.size},
                                    {at.x + away, at.y - away},
                                    {at.x - away - width, at.y - away}};
    if (!parts.labels.place(std::move(text), places, parts.font, parts.list))
      ++parts.list.labels_left_out;
  }
}

}  // namespace wuerfel::internal
