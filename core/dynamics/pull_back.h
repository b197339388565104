/// Rows on points as rows on the rigid cubes that carry them, by the chain rule: v_p = v + omega perp(r),
/// a_p = a + alpha perp(r) - omega^2 r.
#pragma once

#include <array>

#include "core/geometry/vec2.h"

namespace wuerfel {

/// Coefficients on (x, y, theta) of a cube, and the constant of the centripetal term.
struct RigidRow {
  std::array<double, 3> g{};
  double centripetal = 0.0;
};

/// Adds <g, rate of the point at arm r> to the row of its cube, which turns at `omega`.
inline void pull_back(const Vec2& g, const Vec2& r, double omega, RigidRow& row) {
  row.g[0] += g.x();
  row.g[1] += g.y();
  row.g[2] += g.dot(perp(r));
  row.centripetal -= omega * omega * g.dot(r);
}

}  // namespace wuerfel
