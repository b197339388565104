/// Verteilung der Masse (Figure 7): a uniform rectangle as point masses with the same mass, centre
/// and inertia.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/vec2.h"

namespace wuerfel {

struct PointMass {
  Vec2 arm = Vec2::Zero();  ///< m, in the frame of the unturned cube, from its centre
  double mass = 0.0;        ///< kg
};

inline constexpr int points_per_cube = 5;

/// Corners m/12 each (order of Box) and the centre 2m/3. Exact: sum m_i |r_i|^2 = 4 (m/12)
/// (w^2+h^2)/4 = m (w^2+h^2)/12. With all mass in the corners the inertia would be three times too
/// large.
std::array<PointMass, points_per_cube> mass_distribution(const Vec2& size, double mass);

}  // namespace wuerfel
