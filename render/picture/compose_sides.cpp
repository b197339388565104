// The triangles of Eq. (2), with their signs.
#include <algorithm>
#include <array>
#include <cmath>

#include "render/picture/frame_parts.h"

namespace wuerfel {

bool is_negative(const SnapshotSide& side) {
  constexpr double rounding = 1e-9;  // of the side's square
  return side.area < -rounding * (side.p_j - side.p_i).squaredNorm();
}

namespace internal {
namespace {

constexpr std::size_t most_sides = 4;  ///< all of which are drawn, however far apart
constexpr double near_side = 0.3;      ///< of a side: sides farther off are not drawn among many
constexpr double side_outline = 1.8;   ///< px of a 1280x720 picture

Color side_color(const FrameParts& parts, bool negative) {
  return negative ? parts.style.negative_side : parts.style.positive_side;
}

/// Strokes from one side of a triangle to another: what is negative differs by more than its colour.
void hatch(const FrameParts& parts, const TriangleShape& triangle) {
  const auto between = [](Pixel p, Pixel q, float share) {
    return Pixel{p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
  };
  const float length = std::hypot(triangle.b.x - triangle.a.x, triangle.b.y - triangle.a.y);
  const int count = std::clamp(static_cast<int>(length / parts.weight(9.0)), 2, 200);
  SegmentShape stroke;
  stroke.half_width = 0.5F * parts.weight(1.2);
  stroke.round = 0.0F;
  stroke.color = triangle.outline;
  for (int i = 1; i < count; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(count);
    stroke.from = between(triangle.a, triangle.b, share);
    stroke.to = between(triangle.c, triangle.b, share);
    parts.list.add(stroke);
  }
}

}  // namespace

void paint_side(const FrameParts& parts, const std::array<Pixel, 3>& corners, bool negative) {
  const Color color = side_color(parts, negative);
  TriangleShape triangle;
  triangle.a = corners[0];
  triangle.b = corners[1];
  triangle.c = corners[2];
  triangle.outline_width = parts.weight(side_outline);
  triangle.fill = with_alpha(color, 0.32);
  triangle.outline = color;
  parts.list.add(triangle);
  if (negative) hatch(parts, triangle);
}

void add_sides(const FrameParts& parts) {
  for (const SnapshotSide& side : parts.snapshot.sides) {
    const double base = std::max((side.p_j - side.p_i).norm(), 1e-300);
    if (parts.snapshot.sides.size() > most_sides && std::abs(side.area) > near_side * base * base)
      continue;
    const Color color = side_color(parts, is_negative(side));
    const std::array<Pixel, 3> corners{parts.pixel(side.p_i), parts.pixel(side.p_j),
                                       parts.pixel(side.p_k)};
    const double height = std::abs(side.area) / base * parts.view.pixels_per_metre;
    const float outline = parts.weight(side_outline);
    if (static_cast<float>(height) > 2.0F * outline) {
      paint_side(parts, corners, is_negative(side));
    } else {
      parts.list.add(SegmentShape{corners[0], corners[1], outline, 1.0F, color});
    }
    DiscShape corner;
    corner.radius = parts.weight(3.8);
    corner.fill = color;
    for (const Pixel place : corners) {
      corner.center = place;
      parts.list.add(corner);
    }
  }
}

}  // namespace internal
}  // namespace wuerfel
