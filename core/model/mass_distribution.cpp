#include "core/model/mass_distribution.h"

namespace wuerfel {

std::array<PointMass, points_per_cube> mass_distribution(const Vec2& size, double mass) {
  const double w = 0.5 * size.x();
  const double h = 0.5 * size.y();
  const double corner = mass / 12.0;
  return {{{{-w, -h}, corner},
           {{w, -h}, corner},
           {{w, h}, corner},
           {{-w, h}, corner},
           {Vec2::Zero(), mass * 2.0 / 3.0}}};
}

std::array<PointMass, 9> simpson_mass_distribution(const Vec2& size, double mass) {
  constexpr std::array<double, 3> weight = {1.0, 4.0, 1.0};
  std::array<PointMass, 9> points;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const Vec2 arm(0.5 * size.x() * (static_cast<double>(column) - 1.0),
                     0.5 * size.y() * (static_cast<double>(row) - 1.0));
      points[3 * row + column] = {arm, mass * weight[row] * weight[column] / 36.0};
    }
  }
  return points;
}

}  // namespace wuerfel
