/// Frames: where and how something stands.
#pragma once

#include "core/scene/scene.h"

namespace wuerfel {

/// A place to stand on: x along the face, y out of it.
struct Frame {
  Vec2 origin = Vec2::Zero();    ///< m
  Vec2 tangent = Vec2::UnitX();  ///< unit vector; the normal is perp(tangent)
  double angle = 0.0;            ///< rad, of the tangent
  [[nodiscard]] Vec2 point(const Vec2& local) const {
    return origin + local.x() * tangent + local.y() * perp(tangent);
  }
};

/// On a plane, `offset` along it from the plane's point.
Frame frame_on(const ScenePlane& plane, double offset);

/// On the top face of a box, `offset` along it from the middle: the face whose normal points up
/// most. Of two equally steep faces the one that is the box's own upper face, else the one further
/// to its left.
Frame frame_on_box(const Vec2& position, double angle, const Vec2& size, double offset);

}  // namespace wuerfel
