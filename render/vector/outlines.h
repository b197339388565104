/// The outlines of shapes as polygons, in pixels: what vector figures draw.
#pragma once

#include <array>

#include "render/picture/draw_list.h"

namespace wuerfel::internal {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

inline Point point(Pixel pixel) {
  return {static_cast<double>(pixel.x), static_cast<double>(pixel.y)};
}

/// The corners of a box, `inset` pixels inside.
std::array<Point, 4> corners(const BoxShape& box, double inset);

/// Shaft and swept-back head.
std::array<Point, 7> outline(const ArrowShape& arrow);

/// The corners of a triangle that is moved inwards by `inset` on all sides.
std::array<Point, 3> corners(const TriangleShape& triangle, double inset);

}  // namespace wuerfel::internal
