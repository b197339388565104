// The paper's symbols where they stand: p_i, p_j, p_k, alpha, n and velocities of points at contacts
// (Figures 5 and 6), areas of triangles (Figures 3 and 4), masses of points (Figure 7).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/geometry/trig.h"
#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

constexpr double symbol_size = 1.15;  ///< of the text size
constexpr double script_size = 0.7;   ///< of a symbol, of its sub- and superscripts
constexpr double lowered = 0.24;      ///< of a symbol's size
constexpr double raised = 0.42;
constexpr double away = 9.0;        ///< px from a place to its symbol
constexpr double dimension = 16.0;  ///< px from a side to the line that measures it
constexpr std::ptrdiff_t most = 4;  ///< contacts and sides; among more, symbols say nothing

/// Texts of a symbol from (0, 0) on: what follows _ is lowered, what follows ^ raised, one letter or
/// what stands in braces.
std::vector<TextShape> symbol(const FrameParts& parts, std::string_view markup) {
  const double full = symbol_size * parts.style.text_size * parts.unit;
  std::vector<TextShape> texts;
  double x = 0.0;
  const auto add = [&](std::string_view text, double size, double y) {
    if (text.empty()) return;
    texts.push_back({std::string(text),
                     {static_cast<float>(x), static_cast<float>(y)},
                     static_cast<float>(size),
                     parts.style.ink,
                     parts.style.halo,
                     static_cast<float>(2.0 * parts.unit)});
    x += parts.font.width(text, size);
  };
  while (!markup.empty()) {
    const std::size_t plain = std::min(markup.find_first_of("_^"), markup.size());
    add(markup.substr(0, plain), full, 0.0);
    markup.remove_prefix(plain);
    if (markup.size() < 2) break;
    const double y = markup.front() == '_' ? lowered : -raised;
    const bool braced = markup[1] == '{';
    const std::size_t end = braced ? markup.find('}') : 2;
    add(braced ? markup.substr(2, end - 2) : markup.substr(1, 1), script_size * full, y * full);
    markup.remove_prefix(std::min(braced ? end + 1 : end, markup.size()));
  }
  return texts;
}

/// Beside a place, in a direction of the world as near to the wanted one as is free.
/// `radius` px around the place are taken.
void place(const FrameParts& parts,
           std::string_view markup,
           const Vec2& at,
           const Vec2& wanted,
           double radius = 0.0) {
  std::vector<TextShape> texts = symbol(parts, markup);
  const Area area = common_area(texts, parts.font);
  const double half_width = 0.5 * (area.right - area.left);
  const double half_height = 0.5 * (area.bottom - area.top);
  const Pixel p = parts.pixel(at);
  const double first = wanted.isZero(0.0) ? 0.0 : atan2(-wanted.y(), wanted.x());
  std::vector<Pixel> baselines;
  for (const int eighths : {0, 1, -1, 2, -2, 3, -3, 4}) {
    const double angle = first + 0.25 * std::numbers::pi * eighths;
    Vec2 way;
    sin_cos(angle, way.y(), way.x());
    const double gap = away * parts.unit + radius;
    const Vec2 center(static_cast<double>(p.x) + way.x() * (gap + half_width),
                      static_cast<double>(p.y) + way.y() * (gap + half_height));
    baselines.push_back({static_cast<float>(center.x() - half_width - area.left),
                         static_cast<float>(center.y() - half_height - area.top)});
  }
  parts.labels.place(std::move(texts), baselines, parts.font, parts.list);
}

/// In the middle of something, else beside it.
void place_in(const FrameParts& parts, std::string_view markup, const Vec2& middle) {
  std::vector<TextShape> texts = symbol(parts, markup);
  const Area area = common_area(texts, parts.font);
  const Pixel p = parts.pixel(middle);
  const auto x = static_cast<float>(0.5 * (area.left + area.right));
  const auto y = static_cast<float>(0.5 * (area.top + area.bottom));
  const auto step = static_cast<float>(1.4 * (area.bottom - area.top));
  std::vector<Pixel> baselines;
  for (const auto& [right, down] :
       {std::pair(0.0F, 0.0F), std::pair(0.0F, step), std::pair(0.0F, -step), std::pair(step, 0.0F),
        std::pair(-step, 0.0F)})
    baselines.push_back({p.x - x + right, p.y - y + down});
  parts.labels.place(std::move(texts), baselines, parts.font, parts.list);
}

struct Triple {
  Vec2 p_i;
  Vec2 p_j;
  Vec2 p_k;
};

// Outside at the ends of the side; in the wedge between the two bodies at the corner.
void add_points_of(const FrameParts& parts, const Triple& of) {
  const Vec2 along = (of.p_j - of.p_i).normalized();
  const Vec2 out = perp(along);
  place(parts, "p_i", of.p_i, -along - out);
  place(parts, "p_j", of.p_j, along - out);
  place(parts, "p_k", of.p_k, along + 0.3 * out);
}

/// A line with ticks at its ends, inside the body along its side, with a symbol in the middle.
void add_measure(const FrameParts& parts,
                 const Vec2& from,
                 const Vec2& to,
                 const Vec2& inwards,
                 std::string_view markup) {
  const Vec2 aside = parts.metres(dimension * parts.unit) * inwards;
  const Vec2 tick = parts.metres(4.0 * parts.unit) * inwards;
  const std::array<std::pair<Vec2, Vec2>, 3> strokes{{{from + aside, to + aside},
                                                      {from + aside - tick, from + aside + tick},
                                                      {to + aside - tick, to + aside + tick}}};
  for (const bool halo : {true, false}) {
    SegmentShape line;
    line.half_width = 0.5F * parts.weight(halo ? 1.2 + 2.0 * parts.style.halo_width : 1.2);
    line.color = halo ? parts.style.halo : parts.style.ink;
    if (line.color.a == 0) continue;
    for (const auto& [a, b] : strokes) {
      line.from = parts.pixel(a);
      line.to = parts.pixel(b);
      parts.list.add(line);
    }
  }
  parts.labels.keep_off(parts.pixel(from + aside), parts.pixel(to + aside), 2.0 * parts.unit);
  place(parts, markup, 0.5 * (from + to) + aside, inwards);
}

void add_contact_symbols(const FrameParts& parts, const SnapshotContact& contact) {
  const Vec2 inwards = -perp(Vec2(contact.p_j - contact.p_i)).normalized();
  add_measure(parts, contact.p_i, contact.p_k, inwards, "α");
  add_measure(parts, contact.p_k, contact.p_j, inwards, "1 − α");
  if (parts.has(Layer::velocities)) {
    const double scale = parts.options.metres_per_speed;
    const auto tip = [&](std::string_view name, const Vec2& p, const Vec2& v) {
      if (!v.isZero(0.0)) place(parts, name, p + scale * v, v);
    };
    tip("v_i", contact.p_i, contact.v_i);
    tip("v_j", contact.p_j, contact.v_j);
    tip("v_k", contact.p_k, contact.v_k);
  }
  if (parts.has(Layer::normals)) place(parts, "n", normal_tip(parts, contact), contact.normal);
  add_points_of(parts, {contact.p_i, contact.p_j, contact.p_k});
}

/// Figure 3 has one area; Figure 4 tells positive ones, A_1, from negative ones, A_2.
std::string_view area_symbol(const FrameParts& parts, const SnapshotSide& side) {
  const bool one = parts.snapshot.sides.size() == 1;
  SnapshotSide mirrored = side;
  mirrored.area = -side.area;
  if (is_negative(side)) return one ? "A < 0" : "A_2 < 0";
  if (is_negative(mirrored)) return one ? "A > 0" : "A_1 > 0";
  return "A = 0";
}

void add_side_symbols(const FrameParts& parts, const SnapshotSide& side) {
  place_in(parts, area_symbol(parts, side), (side.p_i + side.p_j + side.p_k) / 3.0);
  add_points_of(parts, {side.p_i, side.p_j, side.p_k});
}

/// "m/12", "2m/3": the fraction of least denominator.
std::string share_of(double share) {
  for (int below = 1; below <= 36; ++below) {
    const double above = std::round(share * below);
    if (std::abs(share * below - above) > 1e-9 || above < 1.0) continue;
    const std::string times = above == 1.0 ? "" : fmt::format("{:.0f}", above);
    return times + "m" + (below == 1 ? "" : fmt::format("/{}", below));
  }
  return fmt::format("{:.3g} m", share);
}

/// Points stand cube by cube, the same number for each.
void add_mass_symbols(const FrameParts& parts) {
  const auto& boxes = parts.snapshot.boxes;
  const auto& points = parts.snapshot.points;
  const auto cubes = std::ranges::count(boxes, false, &SnapshotBox::fixed);
  const std::ptrdiff_t each = cubes > 0 ? std::ssize(points) / cubes : 0;
  if (cubes > most) parts.list.labels_left_out += static_cast<int>(std::ssize(points));
  if (cubes > most || each == 0) return;
  for (std::ptrdiff_t k = 0; k < cubes * each; ++k) {
    const SnapshotBox& box = boxes[k / each];
    const Vec2 way = points[k].position - box.center;
    const Vec2 outwards = way.norm() > 1e-9 * box.size.norm() ? way : Vec2::UnitX();
    const double radius = 0.7 * static_cast<double>(mass_radius(parts, points[k]));
    place(parts, share_of(points[k].mass / box.mass), points[k].position, outwards, radius);
  }
}

/// Contacts with sides that have ends.
std::vector<SnapshotContact> named_contacts(const FrameParts& parts) {
  std::vector<SnapshotContact> contacts;
  for (const SnapshotContact& contact : parts.snapshot.contacts)
    if (contact.from < std::ssize(parts.snapshot.boxes)) contacts.push_back(contact);
  return contacts;
}

}  // namespace

bool shows_symbols(const FrameParts& parts) {
  const auto contacts = std::ssize(parts.snapshot.contacts);
  return parts.has(Layer::symbols) && contacts > 0 && contacts <= most;
}

void add_symbols(const FrameParts& parts) {
  const auto& sides = parts.snapshot.sides;
  if (parts.has(Layer::points)) add_mass_symbols(parts);
  if (std::ssize(sides) <= most) {
    for (const SnapshotSide& side : sides)
      add_side_symbols(parts, side);
  }
  if (sides.empty() && std::ssize(parts.snapshot.contacts) > most)
    parts.list.labels_left_out += static_cast<int>(std::ssize(parts.snapshot.contacts));
  if (std::ssize(sides) > most) parts.list.labels_left_out += static_cast<int>(std::ssize(sides));
  if (!sides.empty() || !shows_symbols(parts)) return;
  const std::vector<SnapshotContact> contacts = named_contacts(parts);
  for (const SnapshotContact& contact : contacts)
    add_contact_symbols(parts, contact);
  if (contacts.size() != 1 || parts.has(Layer::names)) return;
  place_in(parts, "w_{i,j}", parts.snapshot.boxes[contacts.front().from].center);
  place_in(parts, "w_k", parts.snapshot.boxes[contacts.front().on].center);
}

}  // namespace wuerfel::internal
