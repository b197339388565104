/// Solutions of Coulomb's law in which some blocks stay at zero.
///
/// A program with friction may have several solutions: what stands may go on to stand or not under the same forces from
/// outside. As at rest (rest_program.h), it stands where it can: the rows of the others are solved with the held blocks as
/// ground, and the convex program finds forces for those between held blocks.
#pragma once

#include <optional>
#include <span>

#include "core/qp/coulomb/coulomb_solver.h"

namespace wuerfel {

/// The solution; none where there is none that was found, judged by the residual of the whole program. `held`: per block; some are
/// marked and some are not.
std::optional<CoulombResult> solve_holding(const FrictionProgram& friction,
                                           std::span<const char> held);

/// Puts such a solution in the place of another in which marked blocks do not stay at zero. Nothing is done where all or none are
/// marked.
void let_stand(const FrictionProgram& friction, std::span<const char> still, CoulombResult& result);

}  // namespace wuerfel
