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

}  // namespace wuerfel
