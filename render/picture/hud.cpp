#include "render/picture/hud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace wuerfel::internal {
namespace {

constexpr double plate_edge = 7.0;  ///< px of a 1280x720 picture

/// The part of an area that lies in a half-plane: a convex polygon (Sutherland and Hodgman 1974).
std::vector<Vec2> solid_part(const FrameParts& parts,
                             const SnapshotPlane& plane,
                             const Area& area) {
  const std::array<Vec2, 4> corners{Vec2(area.left, area.top), Vec2(area.right, area.top),
                                    Vec2(area.right, area.bottom), Vec2(area.left, area.bottom)};
  const auto depth = [&](const Vec2& pixel) {
    return (plane.point - parts.view.to_world(pixel)).dot(plane.normal);
  };
  std::vector<Vec2> part;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& p = corners.at(i);
    const Vec2& q = corners.at((i + 1) % corners.size());
    const double at_p = depth(p);
    const double at_q = depth(q);
    if (at_p >= 0.0) part.push_back(p);
    if ((at_p >= 0.0) != (at_q >= 0.0)) part.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return part;
}

/// A polygon of one colour; those along the picture's edges without a seam.
void add_polygon(const FrameParts& parts, const std::vector<Vec2>& corners, Color color) {
  if (corners.size() < 3) return;
  Area around{1e300, 1e300, -1e300, -1e300};
  for (const Vec2& p : corners) {
    around = {std::min(around.left, p.x()), std::min(around.top, p.y()),
              std::max(around.right, p.x()), std::max(around.bottom, p.y())};
  }
  const auto on_edge = [&around](const Vec2& p) {
    constexpr double hair = 1e-6;  // px
    return std::min(p.x() - around.left, around.right - p.x()) < hair
           && std::min(p.y() - around.top, around.bottom - p.y()) < hair;
  };
  if (std::ranges::all_of(corners, on_edge)) return add_bar(parts, around, color);
  const auto pixel = [](const Vec2& p) {
    return Pixel{static_cast<float>(p.x()), static_cast<float>(p.y())};
  };
  for (std::size_t i = 2; i < corners.size(); ++i) {
    parts.list.add(TriangleShape{pixel(corners[0]), pixel(corners[i - 1]), pixel(corners[i]), 0.0F,
                                 color, color});
  }
}

}  // namespace

void add_bar(const FrameParts& parts, const Area& area, Color color) {
  const auto middle = static_cast<float>(0.5 * (area.top + area.bottom));
  parts.list.add(SegmentShape{{static_cast<float>(area.left), middle},
                              {static_cast<float>(area.right), middle},
                              static_cast<float>(0.5 * (area.bottom - area.top)),
                              0.0F,
                              color});
}

void add_plate(const FrameParts& parts, const Area& area) {
  const double edge = plate_edge * parts.unit;
  // Whole pixels: what lies on one another has no seams.
  const Area wide{std::floor(area.left - edge), std::floor(area.top - edge),
                  std::ceil(area.right + edge), std::ceil(area.bottom + edge)};
  parts.labels.keep_off(wide);
  add_bar(parts, wide, parts.style.background.a < 255 ? parts.style.halo : parts.style.background);
  if (!parts.has(Layer::cubes)) return;
  for (const SnapshotPlane& plane : parts.snapshot.planes)
    add_polygon(parts, solid_part(parts, plane, wide), parts.style.ground);
}

void HudText::add(std::string text, double x, double y, double size, Color color) {
  TextShape shape;
  shape.text = std::move(text);
  shape.baseline = {static_cast<float>(x), static_cast<float>(y)};
  shape.size = static_cast<float>(size);
  shape.color = color;
  texts_.push_back(std::move(shape));
}

void HudText::paint() {
  // A plate for each line: one for all would hide what is beside the shorter ones, as a slope. Plates that are seen
  // through would show where they lie on one another.
  const bool opaque = parts_.style.background.a == 255;
  for (auto line = texts_.begin(); line != texts_.end();) {
    const float y = line->baseline.y;
    const auto next = std::find_if(
        line, texts_.end(), [&](const TextShape& text) { return opaque && text.baseline.y != y; });
    add_plate(parts_, common_area({line, next}, parts_.font));
    line = next;
  }
  for (TextShape& text : texts_)
    parts_.list.texts.push_back(std::move(text));
}

}  // namespace wuerfel::internal
