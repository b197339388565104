#include "core/geometry/bounds.h"

namespace wuerfel {

BoundingBox posed_bounds(const Box& box, double margin) {
  const Vec2 extent = box.extent() + Vec2::Constant(margin);
  return {box.center - extent, box.center + extent};
}

BoundingBox swept_bounds(const Box& start, const Box& end, double margin) {
  BoundingBox bounds = posed_bounds(start, margin);
  bounds.include(posed_bounds(end, margin));
  return bounds;
}

BoundingBox predicted_bounds(const Vec2& start, const Vec2& end, const Vec2& reach) {
  return {start.cwiseMin(end) - reach, start.cwiseMax(end) + reach};
}

BoundingBox bounds_around(const Vec2& place, double reach) {
  return predicted_bounds(place, place, Vec2::Constant(reach));
}

}  // namespace wuerfel
