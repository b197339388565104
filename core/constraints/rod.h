/// Längenrestriktion, Eq. (1): a rod keeps two points at a distance.
///
///     <p_i - p_j, p_i - p_j> = l_ij^2
///     <v_i - v_j, p_i - p_j> = 0
///     <a_i - a_j, p_i - p_j> + |v_i - v_j|^2 = 0
///
/// Right as printed. The multiplier nu of such a row gives the tension -nu |p_i - p_j|.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/model/points.h"

namespace wuerfel {

/// <g, x_i - x_j> + c = 0 in the rates x of the two points.
struct RodRow {
  Vec2 g = Vec2::Zero();
  double c = 0.0;
};

/// First line of (1): how much the squared length is off, m^2.
inline double rod_error(const Vec2& p_i, const Vec2& p_j, double l_ij) {
  return (p_i - p_j).squaredNorm() - l_ij * l_ij;
}

/// Second line of (1).
inline RodRow rod_velocity_row(const Vec2& p_i, const Vec2& p_j) { return {p_i - p_j, 0.0}; }

/// Third line of (1).
inline RodRow rod_acceleration_row(const Vec2& p_i,
                                   const Vec2& p_j,
                                   const Vec2& v_i,
                                   const Vec2& v_j) {
  return {p_i - p_j, (v_i - v_j).squaredNorm()};
}

/// Largest relative change of a rod's length in a cube.
inline double largest_rod_error(const CubePoints& points, const Vec2& size) {
  double worst = 0.0;
  for (const RodEnds& rod : cube_rods) {
    const bool spoke = rod.j == points_per_cube - 1;
    const double l_ij = spoke ? 0.5 * size.norm() : size[rod.i % 2];
    const Vec2& p_i = points.p[rod.i];
    const Vec2& p_j = points.p[rod.j];
    const double lengths = l_ij * (l_ij + (p_i - p_j).norm());
    worst = std::max(worst, std::abs(rod_error(p_i, p_j, l_ij)) / lengths);
  }
  return worst;
}

}  // namespace wuerfel
