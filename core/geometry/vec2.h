/// Plane vectors: the two operations of the paper that Eigen does not have.
#pragma once

#include <Eigen/Core>

namespace wuerfel {

using Vec2 = Eigen::Vector2d;

/// The vector turned left by a right angle: the paper's superscript "perp" (section 2.2, text
/// before Eq. (6)).
inline Vec2 perp(const Vec2& u) { return {-u.y(), u.x()}; }

/// |u, w| = u_x w_y - u_y w_x. Eq. (8); the print has a wrong product of differences.
inline double det(const Vec2& u, const Vec2& w) { return u.x() * w.y() - u.y() * w.x(); }

}  // namespace wuerfel
