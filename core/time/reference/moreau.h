/// The time stepping of Moreau and Jean: the velocity nearest to that of free flight which closes no
/// contact, and a step with it (theta = 1) [Acary, Brogliato 2008, chapter 10]. It needs no
/// accelerations.
#pragma once

#include "core/time/bookkeeping.h"
#include "core/time/reference/grid_point.h"
#include "core/time/workspace.h"

namespace wuerfel {

/// One time step of `dt` s from a grid point to the next.
void step_by_moreau(GridPoint& point, double dt, Workspace& work, Bookkeeping& book);

}  // namespace wuerfel
