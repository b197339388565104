/// Seitenrestriktion, Eq. (2)-(8): corner p_k stays outside the side (p_i, p_j) of another cube, and
/// how it slides along it.
///
/// Sides are stored clockwise, so that n = perp(p_j - p_i) points out and A is positive outside.
/// Multipliers of these rows are forces: multiplier times coefficient is the force on the point;
/// contact force = lambda |p_j - p_i|. Every form here is compared with finite differences in
/// tests/unit/constraints.
#pragma once

#include "core/geometry/vec2.h"

namespace wuerfel {

/// A function of time at an instant, with its first and second derivative.
struct Jet {
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
};

/// A corner as seen from the centre of another body: p_k, v_k and a_k less those of the centre.
struct RelativeMotion {
  Vec2 d = Vec2::Zero();    ///< m
  Vec2 d_1 = Vec2::Zero();  ///< m/s
  Vec2 d_2 = Vec2::Zero();  ///< m/s^2
};

/// <g_i, x_i> + <g_j, x_j> + <g_k, x_k> + c >= 0 in the rates x of the three points.
struct SideRow {
  Vec2 g_i = Vec2::Zero();
  Vec2 g_j = Vec2::Zero();
  Vec2 g_k = Vec2::Zero();
  double c = 0.0;
};

/// Eq. (2): twice the signed area of the triangle (the paper says area), m^2.
inline double side_area(const Vec2& p_i, const Vec2& p_j, const Vec2& p_k) {
  return det(p_j - p_i, p_k - p_i);
}

/// Eq. (5): alpha with p_k = alpha p_j + (1 - alpha) p_i, for p_k on the side's line (else of its
/// foot).
inline double edge_parameter(const Vec2& p_i, const Vec2& p_j, const Vec2& p_k) {
  const Vec2 e = p_j - p_i;
  return e.dot(p_k - p_i) / e.squaredNorm();
}

/// Eq. (6), the form of (3) where A = 0: <v_k, n> - alpha <v_j, n> - (1 - alpha) <v_i, n> >= 0.
/// The print lacks the term (1 - alpha) <v_i, n>.
inline SideRow side_velocity_row(const Vec2& p_i, const Vec2& p_j, double alpha) {
  const Vec2 n = perp(p_j - p_i);
  return {-(1.0 - alpha) * n, -alpha * n, n, 0.0};
}

/// Eq. (7), the form of (4) where A = A' = 0:
/// <a_k, n> - alpha <a_j, n> - (1 - alpha) <a_i, n> + 2 (|v_i,v_j| + |v_j,v_k| + |v_k,v_i|) >= 0.
/// The print lacks the factor 2 of the second derivative of a product; its third matrix in (4) must
/// start 1 1 0.
inline SideRow side_acceleration_row(const Vec2& p_i,
                                     const Vec2& p_j,
                                     double alpha,
                                     const Vec2& v_i,
                                     const Vec2& v_j,
                                     const Vec2& v_k) {
  SideRow row = side_velocity_row(p_i, p_j, alpha);
  // The sum of the three determinants is |v_j - v_i, v_k - v_i|, which loses no digits to a common
  // speed.
  row.c = 2.0 * det(v_j - v_i, v_k - v_i);
  return row;
}

/// Along the side, for friction: how fast p_k slides against the point of the side where it is, times
/// the side's length: <v_k - alpha v_j - (1 - alpha) v_i, t>, t = perp(n) = p_i - p_j.
inline SideRow side_tangent_row(const Vec2& p_i, const Vec2& p_j, double alpha) {
  const Vec2 t = p_i - p_j;
  return {-(1.0 - alpha) * t, -alpha * t, t, 0.0};
}

/// Its rate in the frame of the side, where A = 0: the second derivative of <p_k - p_m, t> with p_m,
/// the point of the side under p_k, at rest in that frame.
inline SideRow side_tangent_acceleration_row(const Vec2& p_i,
                                             const Vec2& p_j,
                                             double alpha,
                                             const Vec2& v_i,
                                             const Vec2& v_j,
                                             const Vec2& v_k) {
  SideRow row = side_tangent_row(p_i, p_j, alpha);
  row.c = 2.0 * (v_i - v_j).dot((v_k - v_i) - alpha * (v_j - v_i));
  return row;
}

/// (2) over |p_j - p_i|: the gap (m) of a corner at `d` from the centre of the side's body; the
/// side has the unit normal n and is `reach` (m) from that centre.
inline double side_gap(const Vec2& n, const Vec2& d, double reach) { return n.dot(d) - reach; }

/// (2), (3) and (4) over |p_j - p_i| at any position: the gap, m, its rate, m/s, and the rate of
/// that, m/s^2. n turns with the side's body, n' = omega perp(n), omega' = alpha.
inline Jet side_gap_jet(
    const Vec2& n, double reach, double omega, double alpha, const RelativeMotion& k) {
  const Vec2 n_1 = perp(n);
  return {side_gap(n, k.d, reach), n.dot(k.d_1) + omega * n_1.dot(k.d),
          n.dot(k.d_2) + 2.0 * omega * n_1.dot(k.d_1) + alpha * n_1.dot(k.d)
              - omega * omega * n.dot(k.d)};
}

/// (6) over |p_j - p_i|: the rate of the gap, m/s.
inline double side_gap_rate(
    const Vec2& n, double alpha, const Vec2& v_i, const Vec2& v_j, const Vec2& v_k) {
  return n.dot(v_k - alpha * v_j - (1.0 - alpha) * v_i);
}

}  // namespace wuerfel
