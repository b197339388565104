/// Bounds along the axes of the world, of boxes where they stand and where they may go.
#pragma once

#include "core/geometry/box.h"

namespace wuerfel {

/// Axis-aligned bounds.
struct BoundingBox {
  Vec2 low = Vec2::Zero();   ///< m
  Vec2 high = Vec2::Zero();  ///< m
  [[nodiscard]] bool overlaps(const BoundingBox& other) const {
    return low.x() <= other.high.x() && other.low.x() <= high.x() && low.y() <= other.high.y()
           && other.low.y() <= high.y();
  }
  /// Grows until it holds `other`, too.
  void include(const BoundingBox& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
};

/// Bounds of a box where it stands, with a margin (m) around them.
BoundingBox posed_bounds(const Box& box, double margin);
/// Bounds of both ends of a way that is no longer than its chord, with a margin (m).
BoundingBox swept_bounds(const Box& start, const Box& end, double margin);
/// Bounds of all places within `reach` (m) of the chord from `start` to `end`.
BoundingBox predicted_bounds(const Vec2& start, const Vec2& end, const Vec2& reach);
/// The same of one place.
BoundingBox bounds_around(const Vec2& place, double reach);

}  // namespace wuerfel
