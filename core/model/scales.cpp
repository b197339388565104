#include "core/model/scales.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wuerfel {

double size_of(const Body& body, const Twist& a) {
  return a.linear.norm() + body.smaller_side() * std::abs(a.angular);
}

double energy_in_motion(const System& system, const State& state, const Scales& scales) {
  return kinetic_energy(system, state) + scales.weight * scales.length;
}

Scales scales_of(const System& system, const State& state) {
  Scales scales;
  double mass = 0.0;
  double fastest = 0.0;
  scales.length = std::numeric_limits<double>::max();
  for (int i = 0; i < system.cubes; ++i) {
    const Body& body = system.body(i);
    const BodyState& s = state[i];
    scales.length = std::min(scales.length, body.smaller_side());
    mass += body.mass;
    fastest = std::max(fastest, fastest_corner(body, s));
  }
  if (system.cubes == 0) scales.length = 1.0;
  const double g = system.gravity.norm();
  if (g > 0.0) {
    scales.speed = std::sqrt(g * scales.length);
  } else if (fastest > 0.0) {
    scales.speed = fastest;
  }
  scales.time = scales.length / scales.speed;
  scales.gravity = scales.speed / scales.time;
  scales.weight = mass * scales.gravity;
  return scales;
}

}  // namespace wuerfel
