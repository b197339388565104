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

/// The same bits as one by one: opposite sides have opposite distances, and all of them see the other box under the same
/// angle.
SideSeparations side_separations(const Box& a, const Box& b) {
  const Vec2 way = b.center - a.center;
  const double along = std::abs(a.axis.dot(b.axis));
  const double across = std::abs(det(a.axis, b.axis));
  SideSeparations all{};
  const auto add = [&](const Box& from, const Box& on, const Vec2& to, double* out) {
    const double of_width = along * on.half.x() + across * on.half.y();
    const double of_height = across * on.half.x() + along * on.half.y();
    for (int e = 0; e < 2; ++e) {
      const double distance = from.normal(e).dot(to);
      const double extent = e == 0 ? of_height : of_width;
      out[e] = distance - extent - from.reach(e);
      out[e + 2] = -distance - extent - from.reach(e + 2);
    }
    if (from.is_point()) std::fill_n(out, Box::corners, -std::numeric_limits<double>::infinity());
  };
  add(a, b, way, all.data());
  add(b, a, -way, all.data() + Box::corners);
  return all;
}

double separation(const Box& a, const Box& b) { return std::ranges::max(side_separations(a, b)); }

double plane_separation(const Vec2& point, const Vec2& normal, const Box& box) {
  const double extent = std::abs(normal.dot(box.axis)) * box.half.x()
                        + std::abs(normal.dot(perp(box.axis))) * box.half.y();
  return normal.dot(box.center - point) - extent;
}

}  // namespace wuerfel
