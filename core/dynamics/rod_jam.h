/// Impact without collision of rods. Velocities that satisfy the second line of Eq. (1) may still have no accelerations
/// that satisfy the third: rods that depend on one another, sum lambda_k g_k = 0, ask for
///
///     b(v) = sum lambda_k c_k(v) = 0,    c_k(v) = |v_i - v_j|^2 / l_ij,
///
/// as where a point between two rods in one line is struck across them. What is not allowed of the velocities is taken
/// from them at once, inelastically.
#pragma once

#include <vector>

#include "core/dynamics/impact.h"

namespace wuerfel {

struct [[nodiscard]] RodJam {
  /// Rods that contradicted each other, of which none can be left out; empty: there is no jam.
  std::vector<int> rods;
  Impact hit;
};

/// Of an island whose velocities keep all lengths to first order and close no contact. Changes nothing: the caller takes
/// the velocities over and books.
RodJam rod_jam(const System& system, const State& state, const Island& island);

}  // namespace wuerfel
