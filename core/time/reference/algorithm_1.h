/// Algorithm 1 of the paper: explicit Euler as it is printed, and with the new velocity.
#pragma once

#include "core/time/bookkeeping.h"
#include "core/time/reference/grid_point.h"
#include "core/time/workspace.h"

namespace wuerfel {

/// One time step of `dt` s from a grid point to the next. `as_printed`: places move by the old velocities.
void step_by_algorithm_1(
    GridPoint& point, double dt, bool as_printed, Workspace& work, Bookkeeping& book);

}  // namespace wuerfel
