#include "render/vector/outlines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wuerfel::internal {

std::array<Point, 4> corners(const BoxShape& box, double inset) {
  const Point center = point(box.center);
  const Point axis = point(box.axis);
  const double half_width = static_cast<double>(box.half_size.x) - inset;
  const double half_height = static_cast<double>(box.half_size.y) - inset;
  const auto corner = [&](double u, double v) {
    return Point{center.x + u * half_width * axis.x - v * half_height * axis.y,
                 center.y + u * half_width * axis.y + v * half_height * axis.x};
  };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

std::array<Point, 7> outline(const ArrowShape& arrow) {
  const Point tail = point(arrow.tail);
  const Point tip = point(arrow.tip);
  const double length = std::hypot(tip.x - tail.x, tip.y - tail.y);
  const Point along{(tip.x - tail.x) / length, (tip.y - tail.y) / length};
  const auto half_width = static_cast<double>(arrow.half_width);
  const auto head = static_cast<double>(arrow.head_length);
  const auto wing = static_cast<double>(arrow.head_half_width);
  const double notch = 0.25 * head;
  const double base = length - head;
  // Where the shaft meets the swept-back edge of the head.
  const double neck = base + notch * (1.0 - half_width / wing);
  std::array<Point, 7> places{{{0.0, half_width},
                               {neck, half_width},
                               {base, wing},
                               {length, 0.0},
                               {base, -wing},
                               {neck, -half_width},
                               {0.0, -half_width}}};
  for (Point& p : places)
    p = {tail.x + p.x * along.x - p.y * along.y, tail.y + p.x * along.y + p.y * along.x};
  return places;
}

// A triangle moved inwards on all sides is a smaller one about the incentre.
std::array<Point, 3> corners(const TriangleShape& triangle, double inset) {
  std::array<Point, 3> places{point(triangle.a), point(triangle.b), point(triangle.c)};
  const auto side = [&](std::size_t i) {
    const Point from = places.at((i + 1) % 3);
    const Point to = places.at((i + 2) % 3);
    return std::hypot(to.x - from.x, to.y - from.y);
  };
  const std::array<double, 3> sides{side(0), side(1), side(2)};
  const double perimeter = sides[0] + sides[1] + sides[2];
  Point incenter;
  for (std::size_t i = 0; i < 3; ++i) {
    incenter.x += sides.at(i) / perimeter * places.at(i).x;
    incenter.y += sides.at(i) / perimeter * places.at(i).y;
  }
  const double area = 0.5
                      * std::abs((places[1].x - places[0].x) * (places[2].y - places[0].y)
                                 - (places[1].y - places[0].y) * (places[2].x - places[0].x));
  const double radius = 2.0 * area / perimeter;
  const double shrink = inset > 0.0 ? std::max(0.0, 1.0 - inset / radius) : 1.0;
  for (Point& p : places)
    p = {incenter.x + shrink * (p.x - incenter.x), incenter.y + shrink * (p.y - incenter.y)};
  return places;
}

}  // namespace wuerfel::internal
