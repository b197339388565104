#include "core/model/points.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/trig.h"

namespace wuerfel {
namespace {

std::array<Vec2, points_per_cube> turned_arms(double angle, const Vec2& size) {
  double s = 0.0;
  double c = 1.0;
  sin_cos(angle, s, c);
  const Vec2 u = 0.5 * size.x() * Vec2(c, s);
  const Vec2 w = 0.5 * size.y() * Vec2(-s, c);
  return {-u - w, u - w, u + w, w - u, Vec2::Zero()};
}

}  // namespace

std::array<double, points_per_cube> share_of_points(const Vec2& at, const Vec2& size) {
  if (at.isZero(0.0)) return {0.0, 0.0, 0.0, 0.0, 1.0};
  const Vec2 right = Vec2::Constant(0.5) + at.cwiseQuotient(size);
  const Vec2 left = Vec2::Ones() - right;
  return {left.x() * left.y(), right.x() * left.y(), right.x() * right.y(), left.x() * right.y(),
          0.0};
}

CubePoints points_of(const BodyState& state, const Vec2& size) {
  const auto arms = turned_arms(state.angle, size);
  CubePoints points;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    points.p[k] = state.position + arms[k];
    points.v[k] = point_velocity(state, arms[k]);
  }
  return points;
}

Twist rigid_part(const std::array<Vec2, points_per_cube>& rates,
                 const std::array<Vec2, points_per_cube>& arms,
                 const std::array<PointMass, points_per_cube>& masses) {
  Twist twist;
  double mass = 0.0;
  double inertia = 0.0;
  for (std::size_t k = 0; k < rates.size(); ++k) {
    mass += masses[k].mass;
    inertia += masses[k].mass * arms[k].squaredNorm();
    twist.linear += masses[k].mass * rates[k];
    twist.angular += masses[k].mass * det(arms[k], rates[k]);
  }
  twist.linear /= mass;
  twist.angular /= inertia;
  return twist;
}

BodyState nearest_cube(const CubePoints& points,
                       const Vec2& size,
                       double mass,
                       const BodyState& guess) {
  const auto masses = mass_distribution(size, mass);
  BodyState state = guess;
  state.position.setZero();
  for (std::size_t k = 0; k < masses.size(); ++k) {
    state.position += masses[k].mass / mass * points.p[k];
  }
  // Procrustes in the plane: the turn that maximises sum m_k <turned arm, p - centre>.
  const auto arms = turned_arms(guess.angle, size);
  double along = 0.0;
  double across = 0.0;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    const Vec2 d = points.p[k] - state.position;
    along += masses[k].mass * arms[k].dot(d);
    across += masses[k].mass * det(arms[k], d);
  }
  state.angle = guess.angle + atan2(across, along);
  const Twist rates = rigid_part(points.v, turned_arms(state.angle, size), masses);
  state.velocity = rates.linear;
  state.spin = rates.angular;
  return state;
}

}  // namespace wuerfel
