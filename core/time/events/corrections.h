/// Positions and velocities are put right at an event: out of what bodies overlap by, which is
/// rounding, and onto the contacts that stay closed.
#pragma once

#include <vector>

#include "core/dynamics/projection.h"
#include "core/model/scales.h"
#include "core/time/workspace.h"

namespace wuerfel {

struct OutOfOverlap {
  State state;          ///< where something was moved
  bool moved = false;   ///< something did overlap
  bool pushed = false;  ///< contacts took part that are in none of the islands
};
/// Removes what bodies overlap by, so that it cannot add up. `islands` are those of `state`, found
/// with `touching` (a share of the smaller side); those of cubes that all rest (`resting`, one per
/// cube) stay as they are. A light body between others may have to move by more than rounding, into
/// what it did not touch before: that takes part then as well.
OutOfOverlap out_of_overlap(const State& state,
                            const std::vector<Island>& islands,
                            const std::vector<char>& resting,
                            double touching,
                            Workspace& work);

/// Puts an island on its closed contacts. These (`closed`, one entry per contact of the island) may still have gaps within what
/// counts as touching, and open slowly. The smooth phase makes both zero, which may not push other
/// contacts into overlap or let them close: they take part here, as inequalities.
void onto_closed(const Island& island,
                 const std::vector<char>& closed,
                 State& state,
                 Workspace& work);

/// Overlap that events may leave, as a share of the smaller side. Far from the origin rounding of the positions is more than
/// that of steps.
double bearable_overlap(const State& state, const Scales& scales);

/// How far a corner has come at most from one state to another, m.
double farthest_way(const System& system, const State& from, const State& to);

}  // namespace wuerfel
