/// State of the cubes: the reduced coordinates x, y, theta and their rates. The points p_i of the
/// paper follow from it (model/points.h), as rods keep cubes rigid.
#pragma once

#include <vector>

#include "core/geometry/vec2.h"

namespace wuerfel {

/// State of one cube.
struct BodyState {
  Vec2 position = Vec2::Zero();  ///< m, centre
  double angle = 0.0;            ///< rad, counter-clockwise
  Vec2 velocity = Vec2::Zero();  ///< m/s, of the centre
  double spin = 0.0;             ///< rad/s
  bool operator==(const BodyState&) const = default;
};

/// To the bit.
inline bool is_still(const BodyState& s) { return s.velocity.isZero(0.0) && s.spin == 0.0; }
inline void stop(BodyState& s) {
  s.velocity.setZero();
  s.spin = 0.0;
}

/// Velocity, acceleration, impulse ... of one cube as a rigid body.
struct Twist {
  Vec2 linear = Vec2::Zero();  ///< of the centre
  double angular = 0.0;
};

// The chain rule from a body to its point at arm r from the centre; accelerating, it turns at `omega`.
inline Vec2 point_velocity(const Twist& v, const Vec2& r) { return v.linear + v.angular * perp(r); }
inline Vec2 point_velocity(const BodyState& s, const Vec2& r) {
  return point_velocity(Twist{s.velocity, s.spin}, r);
}
inline Vec2 point_acceleration(const Twist& a, double omega, const Vec2& r) {
  return a.linear + a.angular * perp(r) - omega * omega * r;
}

/// One per cube, in the order of the scene.
using State = std::vector<BodyState>;

}  // namespace wuerfel
