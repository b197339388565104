#include "core/scene/frame.h"

#include <array>
#include <numbers>

#include "core/geometry/trig.h"

namespace wuerfel {
namespace {

constexpr double right_angle = 0.5 * std::numbers::pi;

/// A face seen from the box: its tangent turned against the box's width by `turns` right angles.
struct Face {
  Vec2 tangent = Vec2::UnitX();
  double turns = 0.0;
  double reach = 0.0;  ///< m, distance from the centre
};

}  // namespace

Frame frame_on(const ScenePlane& plane, double offset) {
  Frame frame;
  frame.tangent = {plane.normal.y(), -plane.normal.x()};
  frame.angle = atan2(frame.tangent.y(), frame.tangent.x());
  frame.origin = plane.point + offset * frame.tangent;
  return frame;
}

Frame frame_on_box(const Vec2& position, double angle, const Vec2& size, double offset) {
  Vec2 u;
  sin_cos(angle, u.y(), u.x());
  const Vec2 w = perp(u);
  const std::array<Face, 4> faces{{{u, 0.0, 0.5 * size.y()},
                                   {w, 1.0, 0.5 * size.x()},
                                   {-w, -1.0, 0.5 * size.x()},
                                   {-u, 2.0, 0.5 * size.y()}}};
  const Face* top = &faces[0];
  for (const Face& face : faces) {
    if (perp(face.tangent).y() > perp(top->tangent).y()) top = &face;
  }
  Frame frame;
  frame.tangent = top->tangent;
  frame.angle = top->turns == 0.0 ? angle : angle + top->turns * right_angle;
  frame.origin = position + offset * top->tangent + top->reach * perp(top->tangent);
  return frame;
}

}  // namespace wuerfel
