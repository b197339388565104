/// The paper's own state: the points p_i of a cube with their velocities, and the rods between them
/// (Figure 2).
#pragma once

#include <array>

#include "core/model/mass_distribution.h"
#include "core/model/state.h"

namespace wuerfel {

/// Points of one cube: corners 0 .. 3 as in Box, then the centre.
struct CubePoints {
  std::array<Vec2, points_per_cube> p;  ///< m
  std::array<Vec2, points_per_cube> v;  ///< m/s
};

/// Stange: the two points of a cube that it joins.
struct RodEnds {
  int i = 0;
  int j = 0;
};

inline constexpr int rods_per_cube = 8;

/// Four sides and four spokes from the centre. Seven would do (ten unknowns, three motions); the
/// eighth is what makes rod forces not unique and is kept for symmetry.
inline constexpr std::array<RodEnds, rods_per_cube> cube_rods = {
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};

/// The place `at` (m, in the frame of the unturned cube from its centre) as a mean of the cube's points, which it stays
/// while the rods of the cube hold: shares of sum 1, of the centre alone or of the corners.
std::array<double, points_per_cube> share_of_points(const Vec2& at, const Vec2& size);

/// Points of a rigid cube: p = x + r, v = v_x + omega perp(r).
CubePoints points_of(const BodyState& state, const Vec2& size);

/// The nearest rigid cube to points that have drifted apart (Längenkorrektur of one cube): least
/// sum of m_i |p_i - q_i|^2 and m_i |v_i - w_i|^2 over rigid positions q and velocities w; in
/// closed form. `guess` gives the turn that the angle continues from.
BodyState nearest_cube(const CubePoints& points,
                       const Vec2& size,
                       double mass,
                       const BodyState& guess);

/// The rigid part of velocities or accelerations of the points: linear sum m a / sum m, angular sum
/// m r x a / I.
Twist rigid_part(const std::array<Vec2, points_per_cube>& rates,
                 const std::array<Vec2, points_per_cube>& arms,
                 const std::array<PointMass, points_per_cube>& masses);

}  // namespace wuerfel
