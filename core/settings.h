/// How a scene is to be solved: what users choose with the motion options.
#pragma once

#include <string_view>

#include "core/qp/qp_solver.h"

namespace wuerfel {

enum class Integrator {
  euler,       ///< Algorithm 1 exactly as printed: p takes the old v
  symplectic,  ///< semi-implicit Euler: p takes the new v
};
enum class Formulation {
  rigid,   ///< x, y, theta per cube; the same rows pulled back, no rods
  points,  ///< the paper to the letter: every point an unknown, every rod a restriction
};

struct MotionSettings {
  Integrator integrator = Integrator::symplectic;
  Formulation formulation = Formulation::rigid;
  QpMethod solver = QpMethod::automatic;
  double tolerance = 1e-8;    ///< of states; also the error budget of the audit
  double step = 1.0 / 240.0;  ///< s, of the stepping integrators
};

std::string_view to_string(Integrator integrator);
std::string_view to_string(Formulation formulation);

}  // namespace wuerfel
