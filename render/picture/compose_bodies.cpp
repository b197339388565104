// Cubes and fixed boxes, and what is drawn on them: rods, masses, contacts, names.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "render/picture/marks.h"

namespace wuerfel::internal {
namespace {

constexpr double thinnest_body = 1.8;  ///< px: less would be pale
constexpr double thickest_rod = 7.0;
constexpr double thinnest_rod = 1.2;
constexpr double largest_mass_radius = 11.0;
constexpr double mass_rim = 1.2;
constexpr double smallest_name = 0.6;  ///< of the text size
constexpr double name_room = 0.9;      ///< of a side, that a name may take

}  // namespace

bool visible(const FrameParts& parts, const SnapshotBox& box) {
  const Vec2 p = parts.view.to_pixel(box.center);
  const double reach = 0.5 * box.size.norm() * parts.view.pixels_per_metre + 2.0;
  return p.x() > -reach && p.y() > -reach && p.x() < parts.view.width + reach
         && p.y() < parts.view.height + reach;
}

namespace {

BoxShape painted_box(const FrameParts& parts, const SnapshotBox& box, int body) {
  BoxShape shape = box_shape(parts.view, box);
  const auto least = static_cast<float>(0.5 * thinnest_body * parts.unit);
  shape.half_size = {std::max(shape.half_size.x, least), std::max(shape.half_size.y, least)};
  const float smaller = std::min(shape.half_size.x, shape.half_size.y);
  shape.fill = parts.colors[body];
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

// The older, the fainter; what has not moved since is not drawn twice.
void add_ghosts(const FrameParts& parts) {
  const auto& ghosts = parts.snapshot.ghosts;
  std::map<std::string_view, int> number;
  for (int i = 0; i < std::ssize(parts.snapshot.boxes); ++i)
    number.emplace(parts.snapshot.boxes[i].name, i);
  for (std::size_t k = 0; k < ghosts.size(); ++k) {
    const SnapshotBox& ghost = ghosts[k];
    const auto body = number.find(ghost.name);
    if (body == number.end() || !visible(parts, ghost)) continue;
    const SnapshotBox& now = parts.snapshot.boxes[body->second];
    const double moved = (now.center - ghost.center).norm()
                         + ghost.size.minCoeff() * std::abs(now.angle - ghost.angle);
    if (moved < 1e-3 * ghost.size.minCoeff()) continue;
    const double age = static_cast<double>(k + 1) / static_cast<double>(ghosts.size());
    BoxShape shape = painted_box(parts, ghost, body->second);
    shape.fill = with_alpha(shape.fill, 0.08 + 0.22 * age);
    shape.outline = with_alpha(shape.outline, 0.25 + 0.35 * age);
    shape.outline_width *= 0.7F;
    shape.diagonal_width = 0.0F;
    parts.list.add(shape);
  }
}

void add_bodies(const FrameParts& parts) {
  for (std::size_t i = 0; i < parts.snapshot.boxes.size(); ++i) {
    const SnapshotBox& box = parts.snapshot.boxes[i];
    if (!visible(parts, box)) continue;
    parts.list.bodies.push_back({parts.list.boxes.size(), static_cast<int>(i)});
    parts.list.add(painted_box(parts, box, static_cast<int>(i)));
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
  add_strokes(parts, strokes);
}

float mass_radius(const FrameParts& parts, const SnapshotPoint& point) {
  double heaviest = 0.0;
  for (const SnapshotPoint& other : parts.snapshot.points)
    heaviest = std::max(heaviest, other.mass);
  return parts.weight(largest_mass_radius * std::sqrt(point.mass / heaviest) + mass_rim);
}

void add_points(const FrameParts& parts) {
  for (const SnapshotPoint& point : parts.snapshot.points) {
    DiscShape disc;
    disc.center = parts.pixel(point.position);
    disc.radius = mass_radius(parts, point);
    disc.outline_width = parts.weight(mass_rim);
    disc.fill = parts.style.mass;
    disc.outline = parts.style.joint;
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

namespace {

/// Whether a text of this half size around this middle, in pixels, lies on the body: none of their four directions
/// separates them.
bool lies_on(const FrameParts& parts,
             const SnapshotBox& box,
             const Vec2& middle,
             const Vec2& half) {
  const Vec2 along(axis_of(box).x(), -axis_of(box).y());
  const Vec2 across = perp(along);
  const Vec2 apart = parts.view.to_pixel(box.center) - middle;
  const Vec2 half_box = 0.5 * parts.view.pixels_per_metre * box.size;
  return std::ranges::all_of(
      std::array{Vec2(1.0, 0.0), Vec2(0.0, 1.0), along, across}, [&](const Vec2& direction) {
        const double reach = half.dot(direction.cwiseAbs())
                             + half_box.x() * std::abs(along.dot(direction))
                             + half_box.y() * std::abs(across.dot(direction));
        return std::abs(apart.dot(direction)) < reach;
      });
}

/// Beside the long sides of a body too thin for its name, where no body is.
void add_name_beside(const FrameParts& parts, const SnapshotBox& box) {
  const double size = parts.style.text_size * parts.unit;
  const Vec2 half(0.5 * parts.font.width(box.name, size), 0.48 * size);
  const double ppm = parts.view.pixels_per_metre;
  const bool wide = box.size.x() > box.size.y();
  const Vec2 side(axis_of(box).x(), -axis_of(box).y());
  const Vec2 along = wide ? side : perp(side);
  const Vec2 away = perp(along);
  const double gap = 0.5 * ppm * box.size.minCoeff() + half.dot(away.cwiseAbs()) + 3.0 * parts.unit;
  std::vector<Pixel> places;
  for (const double share : {0.0, 0.2, -0.2, 0.4, -0.4}) {
    for (const double way : {gap, -gap}) {
      const Vec2 middle =
          parts.view.to_pixel(box.center) + share * ppm * box.size.maxCoeff() * along + way * away;
      const bool covered = std::ranges::any_of(parts.snapshot.boxes, [&](const SnapshotBox& other) {
        return lies_on(parts, other, middle, half);
      });
      if (!covered) {
        places.push_back({static_cast<float>(middle.x() - half.x()),
                          static_cast<float>(middle.y() + 0.36 * size)});
      }
    }
  }
  parts.labels.place({box.name,
                      {},
                      static_cast<float>(size),
                      parts.style.ink,
                      parts.style.halo,
                      static_cast<float>(2.0 * parts.unit)},
                     places, parts.font, parts.list);
}

/// In the middle where it is free, else above or below it, else in a corner of the body, else between: a frame may take
/// its edges. False where it does not fit.
bool add_name_inside(const FrameParts& parts, const SnapshotBox& box, Color fill) {
  const double full = parts.style.text_size * parts.unit;
  const double ppm = parts.view.pixels_per_metre;
  const bool level = std::abs(axis_of(box).x()) > 0.7;
  const double upright = level ? box.size.x() : box.size.y();
  const double high = level ? box.size.y() : box.size.x();
  const bool flat = high * ppm > 1.4 * full;
  const double room = name_room * ppm * (flat ? upright : std::min(upright, high));
  const double width = parts.font.width(box.name, full);
  const double size = full * std::clamp(room / width, smallest_name, 1.0);
  const double shown = parts.font.width(box.name, size);
  if (shown > room || 1.1 * size > high * ppm) return false;
  TextShape text;
  text.text = box.name;
  text.size = static_cast<float>(size);
  text.color = brightness(fill) > 0.45 ? rgb(0x10161E) : rgb(0xFFFFFF);
  text.halo = fill;
  text.halo_width = static_cast<float>(2.0 * parts.unit);
  const Pixel center = parts.pixel(box.center);
  const double down = std::max(0.5 * (high * ppm - 1.5 * size), 0.0);
  const double aside = std::max(0.5 * (upright * ppm - 1.1 * shown), 0.0);
  std::vector<Pixel> places;
  for (const auto& [x, y] :
       {std::pair(0.0, 0.0), std::pair(0.0, 0.55), std::pair(0.0, 1.0), std::pair(0.0, -0.55),
        std::pair(0.0, -1.0), std::pair(-1.0, 0.0), std::pair(1.0, 0.0), std::pair(-1.0, 1.0),
        std::pair(1.0, 1.0), std::pair(-1.0, -1.0), std::pair(1.0, -1.0), std::pair(-0.7, 0.0),
        std::pair(0.7, 0.0)}) {
    places.push_back({center.x + static_cast<float>(x * aside - 0.5 * shown),
                      center.y + static_cast<float>(y * down + 0.36 * size)});
  }
  parts.labels.place(std::move(text), places, parts.font, parts.list);
  return true;
}

/// Whether a character is part of a word; bytes of letters beyond ASCII are.
bool in_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || std::isalnum(byte) != 0 || c == '_';
}

/// Whether a name stands in a line by itself: "a" is not told of in "leans".
bool names(const std::string& line, const std::string& name) {
  for (std::size_t at = line.find(name); at != std::string::npos; at = line.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !in_word(line[at - 1]);
    if (begins && (end == line.size() || !in_word(line[end]))) return true;
  }
  return false;
}

/// Whether the words of the picture speak of this body.
bool is_told_of(const FrameParts& parts, const SnapshotBox& box) {
  if (!parts.snapshot.reason) return false;
  const auto names_it = [&](const std::string& line) { return names(line, box.name); };
  const SnapshotReason& reason = *parts.snapshot.reason;
  return std::ranges::any_of(reason.headlines, names_it)
         || std::ranges::any_of(reason.advice, names_it);
}

}  // namespace

void add_names(const FrameParts& parts) {
  for (std::size_t i = 0; i < parts.snapshot.boxes.size(); ++i) {
    const SnapshotBox& box = parts.snapshot.boxes[i];
    if (!visible(parts, box) || box.name.empty()) continue;
    if (add_name_inside(parts, box, parts.colors[i])) continue;
    const double width = parts.font.width(box.name, parts.style.text_size * parts.unit);
    const bool is_long = box.size.maxCoeff() * parts.view.pixels_per_metre > width;
    if ((is_long && !is_crowd(parts.snapshot)) || is_told_of(parts, box)) {
      add_name_beside(parts, box);
    } else {
      ++parts.list.labels_left_out;
    }
  }
}

}  // namespace wuerfel::internal
