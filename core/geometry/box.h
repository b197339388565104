/// A posed rectangle: its corners, its sides and what lies outside of them.
///
/// Corners 0 .. 3 run counter-clockwise from the lower left of the unturned box. Side e joins
/// corners e and e + 1 and is stored clockwise as the paper's (p_i, p_j) = (corner e + 1, corner
/// e), so that Eq. (2) is positive outside and n = perp(p_j - p_i) points out.
#pragma once

#include <array>

#include "core/geometry/vec2.h"

namespace wuerfel {

/// Two bodies touch where they overlap or gape by no more than this part of their smallest side.
inline constexpr double touching_tolerance = 1e-9;

struct Box {
  /// Corners, and sides as well.
  static constexpr int corners = 4;

  Vec2 center = Vec2::Zero();  ///< m
  Vec2 half = Vec2::Zero();    ///< m, half width and half height
  Vec2 axis = Vec2::UnitX();   ///< unit vector along the width: (cos, sin) of the angle
  std::array<Vec2, corners> arm = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero(),
                                   Vec2::Zero()};  ///< m, corners relative to the centre

  [[nodiscard]] Vec2 corner(int k) const { return center + arm[k]; }
  /// Unit normal of side e, pointing out.
  [[nodiscard]] Vec2 normal(int e) const {
    const Vec2 n = (e & 1) != 0 ? axis : Vec2(axis.y(), -axis.x());
    return e < 2 ? n : Vec2(-n);
  }
  /// Distance of side e from the centre.
  [[nodiscard]] double reach(int e) const { return (e & 1) != 0 ? half.x() : half.y(); }
  /// Length of side e.
  [[nodiscard]] double length(int e) const { return 2.0 * ((e & 1) != 0 ? half.y() : half.x()); }
  /// Half width and half height of its bounds along the axes of the world, m.
  [[nodiscard]] Vec2 extent() const { return arm[2].cwiseAbs().cwiseMax(arm[1].cwiseAbs()); }
  /// Whether this is a point mass, which has one corner and no sides.
  [[nodiscard]] bool is_point() const { return half.x() == 0.0; }
  [[nodiscard]] int corner_count() const { return is_point() ? 1 : corners; }
  [[nodiscard]] double smaller_side() const { return 2.0 * half.minCoeff(); }
  /// Distance of the corner that is farthest from the centre, m.
  [[nodiscard]] double radius() const { return half.norm(); }
};

/// Neighbours of a corner, counter-clockwise and clockwise.
inline int next_corner(int k) { return (k + 1) % Box::corners; }
inline int previous_corner(int k) { return (k + Box::corners - 1) % Box::corners; }

Box make_box(const Vec2& center, double angle, const Vec2& size);

/// Separation of two boxes along the outward normal of side e of `a`: distance of the nearest
/// corner of `b` from the side's line, negative inside. Differences of centres are taken first, so
/// that far from the origin nothing is lost but the rounding of the positions themselves. Minus
/// infinity where `a` is a point: it has no sides.
double side_separation(const Box& a, int e, const Box& b);

/// Separations along all sides of a pair: those of `a`, then those of `b`.
using SideSeparations = std::array<double, 2 * Box::corners>;
SideSeparations side_separations(const Box& a, const Box& b);

/// Largest side separation over the eight sides (separating axes): negative where the boxes
/// overlap, then minus the depth; where positive a lower bound of the distance.
double separation(const Box& a, const Box& b);

/// Separation of a box from the half-plane at `point` with unit `normal` out of the solid.
double plane_separation(const Vec2& point, const Vec2& normal, const Box& box);

}  // namespace wuerfel
