/// Units of a motion: what is small, fast or short is judged by them.
#pragma once

#include "core/model/system.h"

namespace wuerfel {

struct Scales {
  double length = 1.0;   ///< m, L: smallest side of a cube; of points alone the shortest rod
  double speed = 1.0;    ///< m/s, V = sqrt(g L); without gravity the largest speed at hand
  double time = 1.0;     ///< s, L / V
  double gravity = 1.0;  ///< m/s^2, V^2 / L
  double weight = 1.0;   ///< N, of all cubes under that acceleration
};

/// |a| + side |alpha|, m/s^2: accelerations of a body are measured by it, of boxes those of their corners.
double size_of(const Body& body, const Twist& a);

/// Energy that is in motion or may come into it at once, J: kinetic, and that of a fall by L.
double energy_in_motion(const System& system, const State& state, const Scales& scales);

/// Scales of a system at a state. Where nothing moves and nothing falls, V is 1.
Scales scales_of(const System& system, const State& state);

}  // namespace wuerfel
