#include "core/geometry/box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/trig.h"

namespace wuerfel {

Box make_box(const Vec2& center, double angle, const Vec2& size) {
  Box box;
  box.center = center;
  box.half = 0.5 * size;
  double sine = 0.0;
  double cosine = 1.0;
  sin_cos(angle, sine, cosine);
  box.axis = {cosine, sine};
  const Vec2 u = box.half.x() * box.axis;
  const Vec2 w = box.half.y() * perp(box.axis);
  box.arm = {-u - w, u - w, u + w, w - u};
  return box;
}

double side_separation(const Box& a, int e, const Box& b) {
  if (a.is_point()) return -std::numeric_limits<double>::infinity();
  const Vec2 n = a.normal(e);
  const double center_distance = n.dot(b.center - a.center);
  // Half the extent of b along n is what its nearest corner is closer than its centre.
  const double extent =
      std::abs(n.dot(b.axis)) * b.half.x() + std::abs(n.dot(perp(b.axis))) * b.half.y();
  return center_distance - extent - a.reach(e);
}

double separation(const Box& a, const Box& b) {
  double largest = side_separation(a, 0, b);
  for (int e = 1; e < Box::corners; ++e) {
    largest = std::max(largest, side_separation(a, e, b));
  }
  for (int e = 0; e < Box::corners; ++e) {
    largest = std::max(largest, side_separation(b, e, a));
  }
  return largest;
}

double plane_separation(const Vec2& point, const Vec2& normal, const Box& box) {
  const double extent = std::abs(normal.dot(box.axis)) * box.half.x()
                        + std::abs(normal.dot(perp(box.axis))) * box.half.y();
  return normal.dot(box.center - point) - extent;
}

}  // namespace wuerfel
