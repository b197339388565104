/// How a scene is to be solved: what users choose with the motion options.
#pragma once

#include <string_view>

#include "core/qp/qp_solver.h"

namespace wuerfel {

enum class Integrator {
  automatic,   ///< event, and rattle where events crowd, for each group of cubes by itself
  event,       ///< from event to event, with error control
  rattle,      ///< second-order time stepping without overlap
  moreau,      ///< Moreau-Jean time stepping, first order
  euler,       ///< Algorithm 1 exactly as printed: p takes the old v
  symplectic,  ///< semi-implicit Euler: p takes the new v
};
enum class Formulation {
  rigid,   ///< x, y, theta per cube; the same rows pulled back, no rods
  points,  ///< the paper to the letter: every point an unknown, every rod a restriction
};

/// Work that a scene may not need. Each can be switched off, which changes no answer beyond its
/// residual (tests/equivalence/skips_test.cpp).
struct Skips {
  /// No program and no steps for a cube that touches nothing: its fall is a parabola.
  bool free_bodies = true;
  bool islands = true;  ///< a program for each group of touching cubes, not one for all
  bool rest = true;     ///< what rests with a certificate is not touched until a neighbour changes
  /// An island's former answer is taken where it still passes the optimality test.
  bool certificate = true;
  bool warm_start = true;     ///< solvers start from what they remember of the island
  bool resting_steps = true;  ///< no programs in steps for islands that rest, until somebody comes
  /// What stands while few cubes of its group move, and forces are many, has no equations of motion.
  bool standing = true;
  bool looks = true;  ///< forces of what is as it was at the last look are not found again
};

struct MotionSettings {
  Integrator integrator = Integrator::automatic;
  Formulation formulation = Formulation::rigid;
  QpMethod solver = QpMethod::automatic;
  double tolerance = 1e-8;    ///< of states; also the error budget of the audit
  double step = 1.0 / 240.0;  ///< s, of the stepping integrators; of rattle the longest one
  Skips skips{};
};

std::string_view to_string(Integrator integrator);
std::string_view to_string(Formulation formulation);

}  // namespace wuerfel
